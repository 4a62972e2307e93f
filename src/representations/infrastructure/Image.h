#pragma once
#include <cstdint>
#include <vector>

#include "base/Time.h"
#include "representations/infrastructure/CameraInfo.h"

namespace gt {

/// One pixel in YCbCr (the report calls it YUV), padded to four bytes so that it is read at once.
struct Pixel {
  std::uint8_t y = 0, cb = 128, cr = 128, unused = 0;

  static constexpr auto fields() {
    return Fields{field<&Pixel::y>(), field<&Pixel::cb>(), field<&Pixel::cr>(),
                  field<&Pixel::unused>()};
  }
};
static_assert(sizeof(Pixel) == 4);

/// An image of the robot's camera. Provided by the platform.
struct Image {
  Time time;
  CameraInfo info;
  std::vector<Pixel> pixels;

  const Pixel& at(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(info.width) +
                  static_cast<std::size_t>(x)];
  }
  Pixel& at(int x, int y) {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(info.width) +
                  static_cast<std::size_t>(x)];
  }
  /// The number of pixels that `info` asks for.
  std::size_t area() const {
    return static_cast<std::size_t>(info.width) * static_cast<std::size_t>(info.height);
  }
  void allocate() { pixels.resize(area()); }
  /// Checks an image from outside (`checked`).
  std::string_view validationError() const {
    return pixels.size() == area() ? "" : "its pixels are not as many as its size says";
  }

  static constexpr auto fields() {
    return Fields{field<&Image::time>(Unit::ms, "time of exposure of the last row"),
                  field<&Image::info>(), field<&Image::pixels>("pixels row by row, from the top")};
  }
};

}  // namespace gt
