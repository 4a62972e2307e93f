#include "workbench/LabelErrorPlot.h"

#include <QEvent>
#include <cmath>
#include <utility>

#include "base/File.h"
#include "base/Statistics.h"
#include "workbench/PlotColors.h"

namespace gt {
namespace {

constexpr QRgb kindColors[] = {0xffe07010, 0xff7f8c9b, 0xff2f7ed8,
                               0xffc2417c, 0xffd79a1e, 0xff3a9b52};
constexpr const char* kinds[] = {"ball", "lines", "post", "flag", "goal", "player"};

/// Whether something was found that is labeled; otherwise it was missed, or is not there.
bool isRight(const LabelError& error) {
  return error.labeled && error.found;
}
double heightOf(const LabelError& error) {
  return isRight(error) ? error.degrees : 0.0;
}

}  // namespace

LabelErrorPlot::LabelErrorPlot() {
  setMinimumHeight(100);
  setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
  yAxis->setLabel("°");
  yAxis->ticker()->setTickCount(3);
  keepLegendInside(*this);
  for (std::size_t i = 0; i < std::size(kinds); ++i)
    for (const auto shape : {QCPScatterStyle::ssDisc, QCPScatterStyle::ssCross}) {
      QCPGraph* graph = addGraph();
      graph->setName(kinds[i]);
      graph->setLineStyle(QCPGraph::lsNone);
      graph->setPen(QPen{QColor{kindColors[i]}, 1.5});
      graph->setScatterStyle(QCPScatterStyle{shape, 6});
    }
  QObject::connect(this, &QCustomPlot::mouseRelease, this, [this](const QMouseEvent* event) {
    const LabelError* error = errorAt(event->pos());
    if (error && clicked) clicked(*error);
  });
  setPlotColors(*this, palette());
  drawErrors();
}

void LabelErrorPlot::setErrors(std::vector<LabelError> errors) {
  errors_ = std::move(errors);
  drawErrors();
}

void LabelErrorPlot::setOverDistance(bool overDistance) {
  overDistance_ = overDistance;
  drawErrors();
}

QString LabelErrorPlot::summary() const {
  QStringList parts;
  for (const char* kind : kinds) {
    std::vector<double> degrees;
    int labeled = 0, found = 0, wrong = 0;
    for (const LabelError& error : errors_) {
      if (!error.what.starts_with(kind)) continue;
      labeled += error.labeled;
      found += isRight(error);
      wrong += !error.labeled;
      if (isRight(error)) degrees.push_back(error.degrees);
    }
    if (labeled + wrong == 0) continue;
    QString part = QString{"%1: %2 of %3 found"}.arg(kind).arg(found).arg(labeled);
    if (wrong > 0) part += QString{", %1 false"}.arg(wrong);
    if (!degrees.empty())
      part += QString{", off by %1° on average, 95 % below %2°"}
                  .arg(mean(degrees), 0, 'f', 2)
                  .arg(quantile(degrees, 0.95), 0, 'f', 2);
    parts << part;
  }
  return parts.join("; ");
}

Result<void> LabelErrorPlot::exportTo(const std::string& file) const {
  std::string table = "picture,time,what,labeled,found,degrees,distance\n";
  for (const LabelError& error : errors_)
    table += std::to_string(error.picture) + "," + std::to_string(error.time.ms) + "," +
             error.what + "," + std::to_string(error.labeled) + "," + std::to_string(error.found) +
             "," + std::to_string(error.degrees) + "," + std::to_string(error.distance) + "\n";
  return writeFile(file, table);
}

void LabelErrorPlot::changeEvent(QEvent* event) {
  if (event->type() == QEvent::PaletteChange) setPlotColors(*this, palette());
  QCustomPlot::changeEvent(event);
}

double LabelErrorPlot::placeOf(const LabelError& error) const {
  constexpr double perUnit = 1000;  // s, m
  return (overDistance_ ? error.distance : static_cast<double>(error.time.ms)) / perUnit;
}
bool LabelErrorPlot::isShown(const LabelError& error) const {
  return !overDistance_ || error.distance > 0;
}

/// The error that is nearest to a place of the plot; null if none is near.
const LabelError* LabelErrorPlot::errorAt(const QPointF& at) const {
  constexpr double nearest = 10;  // pixels
  const LabelError* chosen = nullptr;
  double least = nearest;
  for (const LabelError& error : errors_) {
    if (!isShown(error)) continue;
    const double distance = std::hypot(xAxis->coordToPixel(placeOf(error)) - at.x(),
                                       yAxis->coordToPixel(heightOf(error)) - at.y());
    if (distance >= least) continue;
    least = distance;
    chosen = &error;
  }
  return chosen;
}

void LabelErrorPlot::drawErrors() {
  xAxis->setLabel(overDistance_ ? "m" : "s");
  for (std::size_t kind = 0; kind < std::size(kinds); ++kind) {
    QVector<double> xs[2], ys[2];
    bool known = false;
    for (const LabelError& error : errors_) {
      if (!error.what.starts_with(kinds[kind])) continue;
      known = true;
      if (!isShown(error)) continue;
      xs[!isRight(error)] << placeOf(error);
      ys[!isRight(error)] << heightOf(error);
    }
    for (int i = 0; i < 2; ++i) {
      QCPGraph* points = graph(2 * static_cast<int>(kind) + i);
      points->setData(xs[i], ys[i]);
      points->removeFromLegend();
      if (i == 0 && known) points->addToLegend();
    }
  }
  legend->setVisible(!errors_.empty());
  rescaleAxes();
  xAxis->scaleRange(1.05);
  yAxis->setRange(-0.05 * yAxis->range().upper, 1.1 * yAxis->range().upper);
  replot(QCustomPlot::rpQueuedReplot);
}

}  // namespace gt
