#pragma once
#include <QTreeWidget>
#include <array>

#include "workbench/CurvePlot.h"

namespace gt {

/// Two cursor lines in a plot over time, which can be dragged, and a table of the values there.
class PlotCursors : public QTreeWidget {
 public:
  explicit PlotCursors(CurvePlot& plot);

  /// Shows the cursors within the visible range of the plot, or hides them.
  void setOn(bool on);
  /// Grabs the cursor at a place of the plot (pixels); false if there is none.
  bool hold(const QPoint& at);
  /// Drags the grabbed cursor to a place (pixels); false if none is grabbed.
  bool drag(const QPoint& at);
  void letGo() { held_ = nullptr; }
  void showValues();

 private:
  CurvePlot& plot_;
  std::array<QCPItemStraightLine*, 2> lines_{};
  QCPItemStraightLine* held_ = nullptr;
  bool on_ = false;
};

}  // namespace gt
