#pragma once
#include <vector>

#include "representations/infrastructure/Image.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// What a robot sees in a game, and from where.
struct GameImage {
  Image image;
  CameraMatrix camera;
};

/// Images of random moments of a match, as the default camera takes them: the same for all that
/// is compared.
const std::vector<GameImage>& gameImages();

/// The color table that the robots use.
const ColorTable64& gameColors();

}  // namespace gt
