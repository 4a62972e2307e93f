#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// An image of interleaved components of 8 bits, row by row from the top.
struct RawImage {
  int width = 0, height = 0;
  int components = 0;  ///< 1 gray, 3 YCbCr, 4 as stored in the file (CMYK or YCCK).
  std::vector<std::uint8_t> data;
};

/// Packs an image of YCbCr as JPEG without converting its colors. Pixels are `pixelStride` bytes
/// apart (Y, Cb, Cr first), rows follow one another. Quality from 1 to 100. Chroma keeps its full
/// resolution. The image is not larger than 65500 pixels a side and not empty.
std::vector<std::uint8_t> encodeJpeg(const std::uint8_t* pixels, int width, int height,
                                     int pixelStride = 4, int quality = 90);

/// Unpacks a JPEG image without converting its colors. Not more than 2^26 pixels.
Result<RawImage> decodeJpeg(std::span<const std::uint8_t> bytes);

}  // namespace gt
