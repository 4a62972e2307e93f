#include <algorithm>
#include <cmath>
#include <limits>

#include "views/ViewText.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr Color grid{225, 225, 225};
constexpr std::array curveColors{colors::red,    colors::blue, colors::green,
                                 colors::orange, colors::pink, colors::skyblue};
constexpr std::size_t mostInLegend = 100;

/// A round step that divides a range into about five.
double niceStep(double range) {
  const double rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

struct Curve {
  std::string name;
  std::vector<ObservedRobot::Point> points;
};

/// Axes of a plot, which map times and values to the sheet.
struct Axes {
  double fromTime, toTime, low, high;
  Vector2d corner{60, 20}, size{720, 300};

  Vector2d of(double seconds, double value) const {
    return corner + Vector2d{(seconds - fromTime) / (toTime - fromTime) * size.x(),
                             (high - value) / (high - low) * size.y()};
  }
};

/// The curves of recorded values, and of values that the robots plot.
std::vector<Curve> curvesOf(const ViewSubject& subject) {
  std::vector<Curve> curves;
  if (subject.recorded)
    for (const auto& [name, points] : *subject.recorded) curves.push_back({name, points});
  for (const ObservedRobot* robot : subject.robots)
    for (const auto& [key, points] : robot->plots())
      curves.push_back({robot->name() + " " + key, {points.begin(), points.end()}});
  std::erase_if(curves, [](const Curve& curve) { return curve.points.empty(); });
  return curves;
}

Axes axesOf(const std::vector<Curve>& curves, double seconds, Time now) {
  const double infinity = std::numeric_limits<double>::infinity();
  Axes axes{infinity, secondsOf(now), infinity, -infinity};
  for (const Curve& curve : curves)
    for (const auto& [time, value] : curve.points) {
      axes.fromTime = std::min(axes.fromTime, secondsOf(time));
      axes.low = std::min(axes.low, value);
      axes.high = std::max(axes.high, value);
    }
  axes.fromTime = std::max(axes.fromTime, axes.toTime - seconds);
  if (!(axes.toTime > axes.fromTime)) axes.fromTime = axes.toTime - 1;
  const double margin = axes.high > axes.low ? 0.05 * (axes.high - axes.low)
                                             : std::max(1.0, 0.1 * std::abs(axes.high));
  axes.low -= margin;
  axes.high += margin;
  return axes;
}

void paintGrid(Sheet& sheet, const Axes& axes) {
  const double step = niceStep(axes.high - axes.low);
  for (double value = std::ceil(axes.low / step) * step; value <= axes.high; value += step) {
    const Vector2d at = axes.of(axes.fromTime, value);
    sheet.line(at, at + Vector2d{axes.size.x(), 0}, grid);
    sheet.text(at + Vector2d{-52, 4}, decimal(value, step < 1 ? 2 : 0), faintText, 11);
  }
  const double timeStep = niceStep(axes.toTime - axes.fromTime);
  for (double time = std::ceil(axes.fromTime / timeStep) * timeStep; time <= axes.toTime;
       time += timeStep) {
    const Vector2d at = axes.of(time, axes.low);
    sheet.line(at, at - Vector2d{0, axes.size.y()}, grid);
    sheet.text(at + Vector2d{-8, 16}, decimal(time, timeStep < 1 ? 2 : 0) + " s", faintText, 11);
  }
}

class PlotView : public View {
 public:
  PlotView()
      : View{"plot", "what plot records, and the robot's plots; how many seconds back may follow"} {
  }

  Result<Sheet> show(const ViewSubject& subject, std::span<const double> numbers) const override {
    if (numbers.size() > 1 || (!numbers.empty() && !(numbers[0] > 0)))
      return Error{.field = name(), .what = "expected no number, or how many seconds back"};
    const std::vector<Curve> curves = curvesOf(subject);
    if (curves.empty())
      return Error{.field = name(), .what = "nothing was recorded; try plot VALUE on"};
    const Axes axes = axesOf(curves, numbers.empty() ? 1e9 : numbers[0], subject.now);
    Sheet sheet{800, 350 + static_cast<int>(std::min(curves.size(), mostInLegend)) * 16};
    paintGrid(sheet, axes);
    Drawing drawing;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      const Color color = curveColors[i % curveColors.size()];
      std::vector<Vector2d> points;
      for (const auto& [time, value] : curves[i].points)
        if (secondsOf(time) >= axes.fromTime) points.push_back(axes.of(secondsOf(time), value));
      drawing.elements.push_back({ElementType::path, std::move(points), 0, color, 1.5, ""});
      const Vector2d legend{axes.corner.x(),
                            axes.corner.y() + axes.size.y() + 36.0 + 16.0 * static_cast<double>(i)};
      sheet.box(legend - Vector2d{0, 9}, {12, 10}, color);
      sheet.text(legend + Vector2d{18, 0},
                 curves[i].name + "   now " + decimal(curves[i].points.back().value, 2));
    }
    sheet.paint(drawing);
    return sheet;
  }
};

}  // namespace

std::unique_ptr<View> makePlotView() {
  return std::make_unique<PlotView>();
}

}  // namespace gt
