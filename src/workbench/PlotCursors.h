#pragma once
#include <QTreeWidget>
#include <array>

#include "workbench/CurvePlot.h"

namespace gt {

/// Two lines in a plot over time that are dragged, and a table of the values there.
class PlotCursors : public QTreeWidget {
 public:
  explicit PlotCursors(CurvePlot& plot);

  /// Shows them within what the plot shows, or hides them.
  void setOn(bool on);
  /// Takes hold of the cursor at a place of the plot; false if there is none.
  bool hold(const QPoint& at);
  /// Drags the cursor that is held; false if none is.
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
