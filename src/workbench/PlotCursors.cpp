#include "workbench/PlotCursors.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gt {
namespace {

constexpr double grip = 6;  ///< Pixels: so near a cursor is taken hold of.

double placeOf(const QCPItemStraightLine* line) {
  return line->point1->key();
}

void place(QCPItemStraightLine* line, double time) {
  line->point1->setCoords(time, 0);
  line->point2->setCoords(time, 1);
}

}  // namespace

PlotCursors::PlotCursors(CurvePlot& plot) : plot_{plot} {
  for (QCPItemStraightLine*& line : lines_) {
    line = new QCPItemStraightLine{&plot};
    line->setVisible(false);
    line->setPen(QPen{palette().color(QPalette::Highlight), 1.5, Qt::DashLine});
  }
  setObjectName("cursorValues");
  setRootIsDecorated(false);
  setHeaderLabels({"Value", "First", "Second", "Difference", "Mean between"});
  setMaximumHeight(130);
  setVisible(false);
}

void PlotCursors::setOn(bool on) {
  on_ = on;
  const QCPRange range = plot_.xAxis->range();
  for (std::size_t i = 0; i < lines_.size(); ++i)
    place(lines_[i], range.lower + range.size() * static_cast<double>(i + 1) / 3);
  setVisible(on);
}

bool PlotCursors::hold(const QPoint& at) {
  held_ = nullptr;
  for (QCPItemStraightLine* line : lines_)
    if (line->visible() && std::abs(plot_.xAxis->coordToPixel(placeOf(line)) - at.x()) < grip)
      held_ = line;
  return held_ != nullptr;
}

bool PlotCursors::drag(const QPoint& at) {
  if (held_) place(held_, plot_.xAxis->pixelToCoord(at.x()));
  return held_ != nullptr;
}

void PlotCursors::showValues() {
  for (QCPItemStraightLine* line : lines_) line->setVisible(on_ && plot_.x().empty());
  if (!on_) return;
  const double first = placeOf(lines_[0]), second = placeOf(lines_[1]);
  clear();
  const auto row = [&](const QString& name, std::optional<double> a, std::optional<double> b,
                       std::optional<double> mean) {
    const auto shown = [](std::optional<double> value) {
      return value ? QString::number(*value, 'g', 6) : QString{"–"};
    };
    const auto difference = a && b ? std::optional{*b - *a} : std::nullopt;
    addTopLevelItem(
        new QTreeWidgetItem{{name, shown(a), shown(b), shown(difference), shown(mean)}});
  };
  row("Time (s)", first, second, std::nullopt);
  for (const auto& [name, curve] : plot_.curves()) {
    const auto& points = *curve.graph->data();
    double sum = 0;
    int count = 0;
    const auto end = points.findEnd(std::max(first, second), false);
    for (auto point = points.findBegin(std::min(first, second), false); point < end; ++point) {
      sum += point->value;
      ++count;
    }
    row(curve.graph->name(), CurvePlot::valueIn(points, first), CurvePlot::valueIn(points, second),
        count > 0 ? std::optional{sum / count} : std::nullopt);
  }
  for (int column = 0; column < columnCount(); ++column) resizeColumnToContents(column);
}

}  // namespace gt
