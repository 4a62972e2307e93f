#pragma once
#include <QPalette>

#include "workbench/CustomPlot.h"

namespace gt {

/// Gives a plot the colors of the window.
void setPlotColors(QCustomPlot& plot, const QPalette& palette);

/// Gives the legend a font so small that all of it can be seen, and a place where curves are
/// oldest.
void keepLegendInside(QCustomPlot& plot);

}  // namespace gt
