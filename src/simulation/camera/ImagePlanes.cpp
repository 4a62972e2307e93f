#include "simulation/camera/ImagePlanes.h"

#include <algorithm>

#include "base/WideInstructions.h"

namespace gt {
namespace {

/// Splits a row into its channels.
struct TakeRow {
  const PackedColor* in;

  [[gnu::always_inline]] inline void operator()(std::uint8_t* __restrict y,
                                                std::uint8_t* __restrict cb,
                                                std::uint8_t* __restrict cr,
                                                std::size_t count) const {
    for (std::size_t i = 0; i < count; ++i) {
      y[i] = static_cast<std::uint8_t>(in[i]);
      cb[i] = static_cast<std::uint8_t>(in[i] >> 8);
      cr[i] = static_cast<std::uint8_t>(in[i] >> 16);
    }
  }
};

}  // namespace

void Plane::resize(int width, int height) {
  width_ = width;
  height_ = height;
  paddedWidth_ = static_cast<std::size_t>((width + step - 1) / step * step);
  values_.resize(offset(height));
}

void Plane::fillMargins(int y) {
  std::uint8_t* const first = row(y);
  std::uint8_t* const end = first + width_;
  std::fill(first - margin, first, *first);
  std::fill(end, first + paddedWidth_ + margin, end[-1]);
}

void takePlanes(const Rasterizer& picture, ImagePlanes& planes) {
  for (Plane& plane : planes) plane.resize(picture.width(), picture.height());
  withWideInstructions([&]() __attribute__((always_inline)) {
    for (int y = 0; y < picture.height(); ++y)
      TakeRow{picture.row(y)}(planes[0].row(y), planes[1].row(y), planes[2].row(y),
                              static_cast<std::size_t>(picture.width()));
  });
}

void joinPlanes(const ImagePlanes& planes, Image& image) {
  withWideInstructions([&]() __attribute__((always_inline)) {
    for (int y = 0; y < image.info.height; ++y)
      joinRow({planes[0].row(y), planes[1].row(y), planes[2].row(y)},
              {&image.at(0, y), static_cast<std::size_t>(image.info.width)});
  });
}

}  // namespace gt
