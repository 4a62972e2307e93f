#pragma once
#include "views/painting/Sheet.h"
#include "representations/perception/ColorTable64.h"

namespace gt {

/// A picture's colour classes instead of its colours.
RgbPicture classesOf(const Image& image, const ColorTable64& table);

/// A whole colour table: for every fourth brightness all its colours, as they are and by class,
/// with a legend.
Sheet tableSheet(const ColorTable64& table);

}  // namespace gt
