#pragma once
#include "representations/infrastructure/Image.h"

namespace gt {

/// An image of 40 x 20 pixels whose left half has one color and whose right half another one.
inline Image halvedImage(const Pixel& left, const Pixel& right) {
  Image image;
  image.info.width = 40;
  image.info.height = 20;
  image.allocate();
  for (int y = 0; y < 20; ++y)
    for (int x = 0; x < 40; ++x) image.at(x, y) = x < 20 ? left : right;
  return image;
}

}  // namespace gt
