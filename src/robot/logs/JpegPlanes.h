#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/Result.h"

namespace gt {

/// The samples of a JPEG picture as they are stored, without conversion of colours.
struct JpegPlanes {
  int width = 0, height = 0, channels = 0;
  std::vector<std::uint8_t> samples;  ///< Channel by channel within a pixel, row by row.
};

/// Decodes a JPEG picture of at most 4096 by 4096 pixels.
Result<JpegPlanes> decodeJpegPlanes(std::string_view bytes);

}  // namespace gt
