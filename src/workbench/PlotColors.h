#pragma once
#include <QPalette>

#include "workbench/CustomPlot.h"

namespace gt {

/// Gives a plot the colors of the window.
void setPlotColors(QCustomPlot& plot, const QPalette& palette);

/// Reduces the legend's font until all of it is visible, and places it over the oldest part of the
/// curves.
void keepLegendInside(QCustomPlot& plot);

}  // namespace gt
