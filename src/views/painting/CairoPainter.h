#pragma once
#include "views/painting/Sheet.h"

namespace gt {

/// Renders a sheet to pixels, with smooth edges (by Cairo).
RgbImage paintByCairo(const Sheet& sheet);

}  // namespace gt
