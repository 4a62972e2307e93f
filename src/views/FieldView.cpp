#include <cmath>

#include "console/Views.h"
#include "representations/modeling/BallModel.h"
#include "simulation/Oracle.h"

namespace gt {
namespace {

constexpr Color grass{30, 110, 50}, lineColor{235, 235, 235};
constexpr double fieldScale = 0.18;  // pixels a mm

void addPolygon(Drawing& drawing, std::vector<Vector2d> corners, Color color, bool filled) {
  drawing.elements.push_back(
      {filled ? ElementType::area : ElementType::polygon, std::move(corners), 0, color, 1.5, ""});
}

std::vector<Vector2d> rectangle(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// fieldPolygons and fieldLines of the report.
Drawing fieldDrawing(const FieldDimensions& f) {
  Drawing drawing;
  const double x = f.xGroundline, y = f.ySideline;
  addPolygon(drawing, rectangle(-x, x, -y, y), grass, true);
  addPolygon(drawing, rectangle(-f.xGoalBack, -x, -f.yGoal, f.yGoal), colors::yellow, true);
  addPolygon(drawing, rectangle(x, f.xGoalBack, -f.yGoal, f.yGoal), colors::skyblue, true);
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0})
      addPolygon(drawing,
                 {{sx * x, sy * y}, {sx * f.xSideCorner, sy * y}, {sx * x, sy * f.ySideCorner}},
                 colors::white, true);
  addPolygon(drawing, rectangle(-x, x, -y, y), lineColor, false);
  addPolygon(drawing, rectangle(-x, -f.xPenaltyArea, -f.yPenaltyArea, f.yPenaltyArea), lineColor,
             false);
  addPolygon(drawing, rectangle(f.xPenaltyArea, x, -f.yPenaltyArea, f.yPenaltyArea), lineColor,
             false);
  drawing.elements.push_back({ElementType::line, {{0, -y}, {0, y}}, 0, lineColor, 1.5, ""});
  drawing.elements.push_back(
      {ElementType::circle, {{0, 0}}, f.centerCircleRadius, lineColor, 1.5, ""});
  return drawing;
}

/// Where robots and balls truly are, as a team sees it.
Drawing truthDrawing(Simulation& simulation, TeamColor team) {
  Drawing drawing;
  const World& world = simulation.world();
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    const Pose2D pose = toTeam(team, world.robot(i).pose);
    const Player& player = simulation.players()[i];
    const Color color = player.teamColor == TeamColor::red ? colors::red : colors::blue;
    addPolygon(drawing,
               {pose * Vector2d{130, -60}, pose * Vector2d{130, 60}, pose * Vector2d{-130, 60},
                pose * Vector2d{-130, -60}},
               color, true);
    drawing.elements.push_back(
        {ElementType::arrow, {pose.translation, pose * Vector2d{200, 0}}, 0, colors::white, 2, ""});
    drawing.elements.push_back({ElementType::text,
                                {pose.translation + Vector2d{-140, 150}},
                                70,
                                color,
                                1,
                                std::to_string(player.number())});
  }
  for (std::size_t i = 0; i < world.ballCount(); ++i)
    drawing.elements.push_back({ElementType::disk,
                                {toTeam(team, world.ball(i).position)},
                                world.ballRadius(i),
                                colors::orange,
                                1,
                                ""});
  return drawing;
}

TeamColor teamOf(ConsoleRobot* robot) {
  return robot && robot->robot() ? robot->robot()->setup().player.teamColor : TeamColor::red;
}

}  // namespace

Result<Sheet> fieldView(Console& console, const std::vector<double>&) {
  const FieldDimensions& field = *console.session().match().configuration().field;
  const int width = static_cast<int>(2 * (field.xGoalBack + 150) * fieldScale);
  const int height = static_cast<int>(2 * (field.ySideline + 150) * fieldScale);
  Sheet sheet{width, height, {70, 70, 75}};
  const Placement placement{{width / 2.0, height / 2.0}, fieldScale, true};
  sheet.paint(fieldDrawing(field), placement);
  const auto robots = console.selected();
  ConsoleRobot* first = robots.empty() ? nullptr : robots.front();
  sheet.paint(truthDrawing(console.session().simulation(), teamOf(first)), placement);
  for (ConsoleRobot* robot : robots) {
    if (teamOf(robot) != teamOf(first)) continue;
    const auto pose = robot->robot() ? robot->robot()->value("RobotPose") : std::nullopt;
    for (const auto& [key, drawing] : robot->memory().drawings())
      if (drawing.space == DrawingSpace::field) {
        sheet.paint(drawing, placement);
      } else if (drawing.space == DrawingSpace::robot && pose) {
        const Pose2D at = static_cast<const RobotPose*>(pose->data())->pose;
        Drawing onField = drawing;
        for (DrawingElement& element : onField.elements)
          for (Vector2d& point : element.points) point = at * point;
        sheet.paint(onField, placement);
      }
  }
  sheet.text({8, 16},
             clockText(console.session().time()) + (first ? "  drawings of " + first->name() : "") +
                 (robots.size() > 1 ? " and its selected mates" : ""),
             colors::white);
  return sheet;
}

Result<Sheet> radarView(Console& console, const std::vector<double>& numbers) {
  const auto robot = console.firstRobot();
  if (!robot) return robot.error();
  if (numbers.size() > 1 || (!numbers.empty() && !(numbers[0] >= 100 && numbers[0] <= 10000)))
    return Error{"", 0, "radar", "expected no number, or how far it looks: 100 to 10000 mm"};
  const double range = numbers.empty() ? 2400 : numbers[0];
  constexpr int size = 480;
  Sheet sheet{size, size, {20, 40, 25}};
  const Placement placement{{size / 2.0, size / 2.0}, size / 2.0 / range, true};
  Drawing rings;
  for (int i = 1; i <= 3; ++i)
    rings.elements.push_back({ElementType::circle, {{0, 0}}, i * range / 3, {70, 120, 80}, 1, ""});
  rings.elements.push_back({ElementType::line, {{0, 0}, {range, 0}}, 0, {70, 120, 80}, 1, ""});
  rings.elements.push_back({ElementType::area,
                            rectangle(-range / 14, range / 14, -range / 28, range / 28), 0,
                            teamOf(*robot) == TeamColor::red ? colors::red : colors::blue, 1, ""});
  if (Robot* here = (*robot)->robot())
    if (const auto ball = here->value("BallModel")) {
      const auto& model = *static_cast<const BallModel*>(ball->data());
      rings.elements.push_back({ElementType::disk, {model.position}, 43, colors::orange, 1, ""});
    }
  sheet.paint(rings, placement);
  for (const auto& [key, drawing] : (*robot)->memory().drawings())
    if (drawing.space == DrawingSpace::robot) sheet.paint(drawing, placement);
  sheet.text({8, 16}, (*robot)->name() + " looks to the right", colors::white);
  return sheet;
}

}  // namespace gt
