#pragma once
#include "representations/perception/ColorTable64.h"
#include "views/painting/Sheet.h"

namespace gt {

/// A picture's colour classes instead of its colours.
RgbPicture classesOf(const Image& image, const ColorTable64& table);

/// A whole colour table: for every fourth brightness all its colours, as they are and by class,
/// with a legend.
Sheet tableSheet(const ColorTable64& table);

}  // namespace gt
