#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "base/Result.h"

namespace gt {

/// Packs an image of RGB, 3 bytes a pixel, as PNG.
std::vector<std::uint8_t> encodePng(int width, int height, std::span<const std::uint8_t> rgb);

/// The same, into a file.
Result<void> writePng(const std::string& path, int width, int height,
                      std::span<const std::uint8_t> rgb);

}  // namespace gt
