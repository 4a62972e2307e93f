#pragma once
#include <QPalette>

#include "workbench/CustomPlot.h"

namespace gt {

/// Gives a plot the colors of the window.
void setPlotColors(QCustomPlot& plot, const QPalette& palette);

}  // namespace gt
