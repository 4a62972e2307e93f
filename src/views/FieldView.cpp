#include <algorithm>
#include <cmath>
#include <cstdio>

#include "representations/infrastructure/Player.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/LandmarksPercept.h"
#include "simulation/world/Oracle.h"
#include "views/ViewText.h"
#include "views/Views.h"

namespace gt {
namespace {

constexpr Color grass{30, 110, 50}, lineColor{235, 235, 235};
constexpr double marginAround = 150;  // mm

void addPolygon(Drawing& drawing, std::vector<Vector2d> corners, Color color, bool filled) {
  drawing.elements.push_back(
      {filled ? ElementType::area : ElementType::polygon, std::move(corners), 0, color, 1.5, ""});
}

std::vector<Vector2d> rectangle(double left, double right, double low, double high) {
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

/// The report's fieldPolygons, as a team sees them: it defends the goal on the left.
Drawing fieldPolygons(const FieldDimensions& f, TeamColor team) {
  Drawing drawing;
  const double x = f.xGroundline, y = f.ySideline;
  const bool red = team == TeamColor::red;
  addPolygon(drawing, rectangle(-x, x, -y, y), grass, true);
  addPolygon(drawing, rectangle(-f.xGoalBack, -x, -f.yGoal, f.yGoal),
             red ? colors::yellow : colors::skyblue, true);
  addPolygon(drawing, rectangle(x, f.xGoalBack, -f.yGoal, f.yGoal),
             red ? colors::skyblue : colors::yellow, true);
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0})
      addPolygon(drawing,
                 {{sx * x, sy * y}, {sx * f.xSideCorner, sy * y}, {sx * x, sy * f.ySideCorner}},
                 colors::white, true);
  return drawing;
}

/// The report's fieldLines.
Drawing fieldLines(const FieldDimensions& f) {
  Drawing drawing;
  const double x = f.xGroundline, y = f.ySideline;
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

/// The upper and the lower color of a flag.
std::pair<Color, Color> colorsOf(FlagType type) {
  switch (type) {
    case FlagType::pinkAboveYellow:
      return {colors::pink, colors::yellow};
    case FlagType::pinkAboveGreen:
      return {colors::pink, colors::green};
    case FlagType::pinkAboveSkyblue:
      return {colors::pink, colors::skyblue};
    case FlagType::yellowAbovePink:
      return {colors::yellow, colors::pink};
    case FlagType::greenAbovePink:
      return {colors::green, colors::pink};
    case FlagType::skyblueAbovePink:
      return {colors::skyblue, colors::pink};
  }
  return {};
}

/// The flags from above: the lower color around the upper one.
Drawing flags(const FieldDimensions& f, TeamColor team) {
  Drawing drawing;
  for (std::size_t i = 0; i < enumCount<FlagType>; ++i) {
    const auto type = static_cast<FlagType>(i);
    const Vector2d at = positionOf(type, team, f);
    const auto [upper, lower] = colorsOf(type);
    drawing.elements.push_back({ElementType::disk, {at}, f.flagRadius, lower, 1, ""});
    drawing.elements.push_back({ElementType::disk, {at}, 0.55 * f.flagRadius, upper, 1, ""});
  }
  return drawing;
}

/// The true places of robots and balls, as a team sees them.
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

/// A drawing around a robot, moved to the robot's believed pose.
Drawing onField(Drawing drawing, const Pose2D& pose) {
  for (DrawingElement& element : drawing.elements)
    for (Vector2d& point : element.points) point = pose * point;
  return drawing;
}

class FieldView : public View {
 public:
  FieldView(std::string name, std::string help, std::vector<std::string> elements)
      : View{std::move(name), std::move(help)}, elements_{std::move(elements)} {}

  Result<Sheet> show(const ViewSubject& subject, std::span<const double>) const override {
    const FieldDimensions& f = subject.field;
    const int width = static_cast<int>(2 * (f.xGoalBack + marginAround) * fieldViewScale);
    const int height = static_cast<int>(2 * (f.ySideline + marginAround) * fieldViewScale);
    Sheet sheet{width, height, {70, 70, 75}};
    const Placement placement{{width / 2.0, height / 2.0}, fieldViewScale, true};
    ObservedRobot* first = subject.robots.empty() ? nullptr : subject.robots.front();
    const TeamColor team = first ? teamOf(*first) : TeamColor::red;
    for (const std::string& element : elements_) {
      if (element == "fieldPolygons")
        sheet.paint(fieldPolygons(f, team), placement);
      else if (element == "fieldLines")
        sheet.paint(fieldLines(f), placement);
      else if (element == "flags")
        sheet.paint(flags(f, team), placement);
      else if (element == "truth" && subject.simulation)
        sheet.paint(truthDrawing(*subject.simulation, team), placement);
      else
        for (ObservedRobot* robot : subject.robots)
          if (teamOf(*robot) == team) paintDrawings(sheet, placement, *robot, element);
    }
    sheet.text({8, 16},
               clockText(first ? first->time() : subject.now) +
                   (first ? "  drawings of " + first->name() : "") +
                   (subject.robots.size() > 1 ? " and its selected teammates" : ""),
               colors::white);
    return sheet;
  }

 private:
  static void paintDrawings(Sheet& sheet, const Placement& placement, ObservedRobot& robot,
                            const std::string& element) {
    const auto known = robot.value<RobotPose>();
    const Pose2D pose = known ? (*known)->pose : Pose2D{};
    for (const auto& [key, drawing] : robot.drawings()) {
      if (key != element && element != "drawings") continue;
      if (drawing.space == DrawingSpace::field)
        sheet.paint(drawing, placement);
      else if (drawing.space == DrawingSpace::robot && known)
        sheet.paint(onField(drawing, pose), placement);
    }
  }

  std::vector<std::string> elements_;
};

}  // namespace

const std::vector<std::string> fieldViewElements{"fieldPolygons", "fieldLines", "flags", "truth",
                                                 "drawings"};

std::unique_ptr<View> makeFieldView(std::string name, std::string help,
                                    std::vector<std::string> elements) {
  return std::make_unique<FieldView>(std::move(name), std::move(help), std::move(elements));
}

}  // namespace gt
