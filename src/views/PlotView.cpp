#include <algorithm>
#include <cmath>
#include <limits>

#include "console/Views.h"
#include "match/SimulatedRobot.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {
namespace {

constexpr Color faint{120, 120, 120}, bar{90, 140, 210}, grid{225, 225, 225};
constexpr std::array lineColors{colors::red,    colors::blue, colors::green,
                                colors::orange, colors::pink, colors::skyblue};

std::string decimal(double value, int digits = 1) {
  char text[48];
  std::snprintf(text, sizeof text, "%.*f", digits, value);
  return text;
}

/// Text in lines and columns, from the top.
class Lines {
 public:
  Lines(Sheet& sheet, double left) : sheet_{sheet}, left_{left} {}
  void add(const std::vector<std::pair<double, std::string>>& columns,
           Color color = colors::black) {
    y_ += 18;
    for (const auto& [x, text] : columns) sheet_.text({left_ + x, y_}, text, color);
  }
  void heading(const std::string& text) {
    y_ += 6;
    add({{0, text}}, faint);
  }

 private:
  Sheet& sheet_;
  double left_;
  double y_ = 10;
};

int heightOf(std::size_t lines) {
  return static_cast<int>(std::min<std::size_t>(lines, 200)) * 18 + 60;
}

/// The symbols that were asked for, of one kind.
void addSymbols(Lines& lines, const BehaviorState& state) {
  for (const BehaviorValue& symbol : state.symbols)
    lines.add({{12, symbol.name}, {330, symbol.value}});
}

/// A round step that divides a range into about five.
double niceStep(double range) {
  const double rough = range / 5, power = std::pow(10, std::floor(std::log10(rough)));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= rough) return factor * power;
  return 10 * power;
}

struct Curve {
  std::string name;
  std::vector<RobotMemory::Sample> samples;
};

/// Axes of a plot: which times and values lie where.
struct Axes {
  double fromTime, toTime, low, high;
  Vector2d corner{60, 20}, size{720, 300};

  Vector2d of(double seconds, double value) const {
    return corner + Vector2d{(seconds - fromTime) / (toTime - fromTime) * size.x(),
                             (high - value) / (high - low) * size.y()};
  }
};

double secondsOf(Time time) {
  return static_cast<double>(time.ms) / 1000;
}

Axes axesOf(const std::vector<Curve>& curves, double seconds, Time now) {
  const double infinity = std::numeric_limits<double>::infinity();
  Axes axes{infinity, secondsOf(now), infinity, -infinity};
  for (const Curve& curve : curves)
    for (const auto& [time, value] : curve.samples) {
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
    sheet.text(at + Vector2d{-52, 4}, decimal(value, step < 1 ? 2 : 0), faint, 11);
  }
  const double timeStep = niceStep(axes.toTime - axes.fromTime);
  for (double time = std::ceil(axes.fromTime / timeStep) * timeStep; time <= axes.toTime;
       time += timeStep) {
    const Vector2d at = axes.of(time, axes.low);
    sheet.line(at, at - Vector2d{0, axes.size.y()}, grid);
    sheet.text(at + Vector2d{-8, 16}, decimal(time, timeStep < 1 ? 2 : 0) + " s", faint, 11);
  }
}

std::vector<Curve> curvesOf(Console& console) {
  std::vector<Curve> curves;
  for (const auto& [name, samples] : console.recording().series())
    curves.push_back({name, samples});
  for (ConsoleRobot* robot : console.selected())
    for (const auto& [key, samples] : robot->memory().plots())
      curves.push_back({robot->name() + " " + key, {samples.begin(), samples.end()}});
  std::erase_if(curves, [](const Curve& curve) { return curve.samples.empty(); });
  return curves;
}

}  // namespace

Result<Sheet> xabslView(Console& console, const std::vector<double>&) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const BehaviorState& state = (*robot)->memory().behavior();
  std::size_t parameters = 0;
  for (const auto& activation : state.activations) parameters += activation.parameters.size();
  Sheet sheet{640, heightOf(state.activations.size() + parameters + state.symbols.size() + 3)};
  Lines lines{sheet, 16};
  lines.add({{0, (*robot)->name() + "   Agent: " + state.agent}});
  lines.heading("Option Activation Path");
  for (const auto& a : state.activations) {
    if (a.state.empty()) lines.heading("Active Basic Behavior");
    lines.add(
        {{12.0 + 12 * a.depth, a.name},
         {250, a.state.empty() ? "" : decimal(static_cast<double>(a.optionTime) / 1000) + " s"},
         {330, a.state},
         {520, a.state.empty() ? "" : decimal(static_cast<double>(a.stateTime) / 1000) + " s"}});
    for (const BehaviorValue& p : a.parameters)
      lines.add({{36.0 + 12 * a.depth, p.name + " = " + p.value}}, faint);
  }
  lines.heading("Symbols");
  addSymbols(lines, state);
  if (state.activations.empty()) lines.add({{12, "nothing yet: dk sendXabsl2DebugMessages on"}});
  return sheet;
}

Result<Sheet> sensorView(Console& console, const std::vector<double>&) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  const auto value =
      (*robot)->robot() ? (*robot)->robot()->value("SensorDataBuffer") : std::nullopt;
  if (!value) return Error{"", 0, (*robot)->name(), "has no sensor data here"};
  const SensorData& data = static_cast<const SensorDataBuffer*>(value->data())->newest();
  Sheet sheet{640, 470};
  Lines lines{sheet, 16};
  lines.add({{0, (*robot)->name() + " at " + clockText(data.time)}});
  lines.heading("Joints, degrees");
  constexpr double zero = 240, perDegree = 1;
  for (std::size_t i = 0; i < enumCount<Joint>; ++i) {
    const double degrees = toDegrees(data.joints.values[i]);
    const double y = 58 + 18 * static_cast<double>(i);
    sheet.box({zero + std::min(0.0, degrees * perDegree), y + 3},
              {std::abs(degrees) * perDegree, 10}, bar);
    lines.add({{0, std::string{enumNames<Joint>[i]}}, {90, decimal(degrees)}});
  }
  Lines right{sheet, 400};
  right.heading("");
  right.heading("Acceleration, m/s2");
  constexpr std::array axes{"ahead", "left", "up"};
  for (int i = 0; i < 3; ++i)
    right.add(
        {{0, axes[static_cast<std::size_t>(i)]}, {90, decimal(data.acceleration[i] / 1000, 2)}});
  right.heading("Distance, mm");
  right.add({{0, "psd"}, {90, decimal(data.psd, 0)}});
  right.heading("Switches");
  for (std::size_t i = 0; i < enumCount<Switch>; ++i)
    right.add(
        {{0, std::string{enumNames<Switch>[i]}}, {90, data.switches.values[i] ? "pressed" : "-"}},
        data.switches.values[i] ? colors::red : faint);
  return sheet;
}

Result<Sheet> timeView(Console& console, const std::vector<double>&) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  if (!(*robot)->robot()) return Error{"", 0, (*robot)->name(), "runs elsewhere"};
  std::vector<const Stopwatch*> watches;
  for (const auto& process : (*robot)->robot()->processes())
    for (const Stopwatch& watch : process->times()) watches.push_back(&watch);
  double longest = 1e-9;
  const auto mean = [](const Stopwatch& watch) {
    return watch.count > 0 ? watch.totalMs / static_cast<double>(watch.count) : 0;
  };
  for (const Stopwatch* watch : watches) longest = std::max(longest, mean(*watch));
  Sheet sheet{720, heightOf(watches.size() + 1)};
  Lines lines{sheet, 16};
  lines.add({{0, (*robot)->name() + ": mean time of each module, times a second"}});
  const double seconds = std::max(secondsOf(console.session().time()), 1e-3);
  double y = 37;
  for (const Stopwatch* watch : watches) {
    sheet.box({190, y}, {std::max(1.0, 260 * mean(*watch) / longest), 11}, bar);
    lines.add({{0, watch->name},
               {450, decimal(mean(*watch), 3) + " ms"},
               {560, decimal(static_cast<double>(watch->count) / seconds) + " /s"}});
    y += 18;
  }
  return sheet;
}

Result<Sheet> plotView(Console& console, const std::vector<double>& numbers) {
  if (numbers.size() > 1 || (!numbers.empty() && !(numbers[0] > 0)))
    return Error{"", 0, "plot", "expected no number, or how many seconds back"};
  const std::vector<Curve> curves = curvesOf(console);
  if (curves.empty()) return Error{"", 0, "plot", "nothing was recorded; try plot VALUE on"};
  const Axes axes = axesOf(curves, numbers.empty() ? 1e9 : numbers[0], console.session().time());
  Sheet sheet{800, 350 + static_cast<int>(std::min<std::size_t>(curves.size(), 100)) * 16};
  paintGrid(sheet, axes);
  Drawing drawing;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    const Color color = lineColors[i % lineColors.size()];
    std::vector<Vector2d> points;
    for (const auto& [time, value] : curves[i].samples)
      if (secondsOf(time) >= axes.fromTime) points.push_back(axes.of(secondsOf(time), value));
    drawing.elements.push_back({ElementType::path, std::move(points), 0, color, 1.5, ""});
    const Vector2d legend{axes.corner.x(),
                          axes.corner.y() + axes.size.y() + 36.0 + 16.0 * static_cast<double>(i)};
    sheet.box(legend - Vector2d{0, 9}, {12, 10}, color);
    sheet.text(legend + Vector2d{18, 0},
               curves[i].name + "   now " + decimal(curves[i].samples.back().value, 2));
  }
  sheet.paint(drawing);
  return sheet;
}

}  // namespace gt
