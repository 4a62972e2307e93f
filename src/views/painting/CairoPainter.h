#pragma once
#include "views/painting/Sheet.h"

namespace gt {

/// A sheet in pixels, with smooth edges (by Cairo).
RgbImage paintByCairo(const Sheet& sheet);

}  // namespace gt
