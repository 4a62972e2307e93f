#pragma once
#include "representations/perception/ColorTable64.h"
#include "views/painting/Sheet.h"

namespace gt {

/// An image's color classes instead of its colors.
RgbImage classesOf(const Image& image, const ColorTable64& table);

/// A whole color table: for every fourth brightness all its colors, in their own color and by
/// class, with a legend.
Sheet tableSheet(const ColorTable64& table);

}  // namespace gt
