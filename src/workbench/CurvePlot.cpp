#include "workbench/CurvePlot.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/File.h"
#include "workbench/PlotColors.h"

namespace gt {
namespace {

constexpr QRgb curveColors[] = {0xff2f7ed8, 0xffe4572e, 0xff3a9b52, 0xffb05bc4,
                                0xffd79a1e, 0xff17a2a2, 0xffc2417c, 0xff7f8c9b};
constexpr std::size_t mostPoints = 2'000'000;
constexpr double keptSeconds = 120;  ///< Of a curve with too many points.

}  // namespace

CurvePlot::CurvePlot() {
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom | QCP::iSelectLegend | QCP::iSelectPlottables);
  legend->setVisible(false);
  keepLegendInside(*this);
  xAxis->setNumberFormat("gb");
  setNoAntialiasingOnDrag(true);
  axes_ = {yAxis, yAxis2};
  while (axes_.size() < axisCount) axes_ << axisRect()->addAxis(QCPAxis::atRight);
  for (QCPAxis* axis : axes_) axis->setVisible(axis == axes_.front());
  axisRect()->setRangeZoomAxes({xAxis}, axes_);
  axisRect()->setRangeDragAxes({xAxis}, axes_);
}

bool CurvePlot::add(const std::string& name, int axis, CurveFilterKind filter) {
  if (name.empty() || curves_.contains(name)) return false;
  Curve& curve = curves_[name];
  const QPen pen{QColor{curveColors[colors_++ % std::size(curveColors)]}, 1.5};
  curve.graph = addGraph(xAxis, axes_[axis]);
  curve.graph->setPen(pen);
  curve.graph->setAdaptiveSampling(true);
  curve.overX = new QCPCurve{xAxis, axes_[axis]};
  curve.overX->setPen(pen);
  curve.filter = CurveFilter{filter};
  nameCurve(name, curve);
  showParts();
  return true;
}

void CurvePlot::remove(const std::string& name) {
  const auto curve = curves_.find(name);
  if (curve == curves_.end()) return;
  if (curve->second.before) removeGraph(curve->second.before);
  removeGraph(curve->second.graph);
  removePlottable(curve->second.overX);
  if (x_ == name) x_.clear();
  curves_.erase(curve);
  showParts();
}

void CurvePlot::clear() {
  while (!curves_.empty()) remove(curves_.begin()->first);
}

int CurvePlot::axisOf(const Curve& curve) const {
  return static_cast<int>(axes_.indexOf(curve.graph->valueAxis()));
}

void CurvePlot::setAxis(const std::string& name, int axis) {
  Curve& curve = curves_.at(name);
  curve.graph->setValueAxis(axes_[axis]);
  curve.overX->setValueAxis(axes_[axis]);
  if (curve.before) curve.before->setValueAxis(axes_[axis]);
  showParts();
}

void CurvePlot::setFilter(const std::string& name, CurveFilterKind kind) {
  Curve& curve = curves_.at(name);
  filterAnew(curve, kind);
  nameCurve(name, curve);
}

void CurvePlot::setX(const std::string& name) {
  x_ = curves_.contains(name) ? name : std::string{};
  showParts();
}

void CurvePlot::take(const PlottedValues& news) {
  now_ = static_cast<double>(news.now.ms) / 1000;
  for (const PlottedValues::Points& fresh : news.points) {
    const auto known = curves_.find(fresh.name);
    if (known == curves_.end()) continue;
    Curve& curve = known->second;
    QVector<double> times, values;
    for (const auto& [time, value] : fresh.points) {
      const double seconds = static_cast<double>(time.ms) / 1000;
      curve.raw.emplace_back(seconds, value);
      if (const auto filtered = curve.filter.take(seconds, value)) {
        times << seconds;
        values << *filtered;
      }
    }
    if (curve.raw.size() > mostPoints) {
      curve.graph->data()->removeBefore(now_ - keptSeconds);
      while (curve.raw.front().first < now_ - keptSeconds) curve.raw.pop_front();
    }
    curve.graph->addData(times, values, true);
    curve.last = fresh.points.back().time;
  }
}

void CurvePlot::keepRuns() {
  for (auto& [name, curve] : curves_) keepRun(curve);
}

void CurvePlot::keepRun(Curve& curve) {
  curve.last = never();
  curve.raw.clear();
  const bool shows = !curve.graph->data()->isEmpty();
  if (shows && !curve.before) {
    curve.before = addGraph(curve.graph->keyAxis(), curve.graph->valueAxis());
    curve.before->removeFromLegend();
    QPen pen = curve.graph->pen();
    QColor faint = pen.color();
    faint.setAlpha(110);
    pen.setColor(faint);
    pen.setStyle(Qt::DashLine);
    curve.before->setPen(pen);
  }
  if (shows) curve.before->data()->set(*curve.graph->data());
  filterAnew(curve, curve.filter.kind());
}

/// Filters all of a curve.
void CurvePlot::filterAnew(Curve& curve, CurveFilterKind kind) {
  curve.filter = CurveFilter{kind};
  QVector<double> times, values;
  for (const auto& [time, value] : curve.raw)
    if (const auto filtered = curve.filter.take(time, value)) {
      times << time;
      values << *filtered;
    }
  curve.graph->setData(times, values, true);
}

void CurvePlot::nameCurve(const std::string& name, Curve& curve) {
  QString shown = QString::fromStdString(name);
  for (const auto& [kind, text] : filters)
    if (kind == curve.filter.kind() && kind != CurveFilterKind::none)
      shown += QString{" – "} + QString{text}.toLower();
  curve.graph->setName(shown);
  curve.overX->setName(shown);
}

/// Shows the axes and curves that are needed.
void CurvePlot::showParts() {
  for (QCPAxis* axis : axes_)
    axis->setVisible(axis == axes_.front() ||
                     std::ranges::any_of(curves_, [axis](const auto& known) {
                       return known.second.graph->valueAxis() == axis;
                     }));
  for (auto& [name, curve] : curves_) {
    curve.graph->setVisible(x_.empty());
    if (curve.before) curve.before->setVisible(x_.empty());
    curve.overX->setVisible(!x_.empty() && name != x_);
    for (QCPAbstractPlottable* part : {static_cast<QCPAbstractPlottable*>(curve.graph),
                                       static_cast<QCPAbstractPlottable*>(curve.overX)}) {
      part->removeFromLegend();
      if (part->visible()) part->addToLegend();
    }
  }
  xAxis->setLabel(QString::fromStdString(x_));
  legend->setVisible(!curves_.empty());
}

void CurvePlot::follow(double seconds) {
  if (!x_.empty()) return drawOverX(seconds);
  xAxis->setRange(now_ - seconds, now_);
  for (QCPAxis* axis : axes_) fit(axis);
}

/// Draws the last seconds of all values over one of them.
void CurvePlot::drawOverX(double seconds) {
  const auto& xs = *curves_.at(x_).graph->data();
  for (auto& [name, curve] : curves_) {
    if (name == x_) continue;
    QVector<double> ts, over, values;
    const auto& all = *curve.graph->data();
    for (auto point = all.findBegin(now_ - seconds, false); point != all.constEnd(); ++point) {
      const auto x = valueIn(xs, point->key);
      if (!x) continue;
      ts << point->key;
      over << *x;
      values << point->value;
    }
    curve.overX->setData(ts, over, values, true);
  }
  rescaleAxes(true);
  constexpr double margin = 1.1;
  xAxis->scaleRange(margin);
  for (QCPAxis* axis : axes_) axis->scaleRange(margin);
}

std::optional<double> CurvePlot::valueIn(const QCPGraphDataContainer& points, double time) {
  auto point = points.findEnd(time, false);
  if (point == points.constBegin()) return std::nullopt;
  return std::prev(point)->value;
}

/// Fits an axis to what can be seen of its curves.
void CurvePlot::fit(QCPAxis* axis) {
  bool any = false;
  QCPRange all;
  for (const auto& [name, curve] : curves_)
    for (const QCPGraph* graph : {curve.graph, curve.before}) {
      if (!graph || graph->valueAxis() != axis) continue;
      bool found = false;
      const QCPRange range = graph->getValueRange(found, QCP::sdBoth, xAxis->range());
      if (!found) continue;
      if (any)
        all.expand(range);
      else
        all = range;
      any = true;
    }
  if (!any) return;
  const double margin =
      all.size() > 0 ? 0.06 * all.size() : std::max(1.0, 0.1 * std::abs(all.lower));
  axis->setRange(all.lower - margin, all.upper + margin);
}

QString CurvePlot::textAt(double time) const {
  QStringList lines{QString{"%1 s"}.arg(time, 0, 'f', 2)};
  for (const auto& [name, curve] : curves_)
    for (const QCPGraph* graph : {curve.graph, curve.before}) {
      if (!graph) continue;
      const auto point = graph->data()->findBegin(time);
      if (point != graph->data()->constEnd())
        lines << QString{"%1%2 = %3"}
                     .arg(QString::fromStdString(name), graph == curve.before ? " before" : "")
                     .arg(point->value, 0, 'g', 6);
    }
  return lines.join("\n");
}

Result<void> CurvePlot::exportTo(const std::string& file) const {
  std::map<double, std::map<std::string, double>> rows;
  std::string text = "time";
  for (const auto& [name, curve] : curves_) {
    text += "," + name;
    for (const QCPGraphData& point : *curve.graph->data()) rows[point.key][name] = point.value;
  }
  text += "\n";
  for (const auto& [time, values] : rows) {
    text += QString::number(time, 'f', 3).toStdString();
    for (const auto& [name, curve] : curves_) {
      const auto value = values.find(name);
      text += "," + (value == values.end() ? std::string{}
                                           : QString::number(value->second, 'g', 9).toStdString());
    }
    text += "\n";
  }
  return writeFile(file, text);
}

}  // namespace gt
