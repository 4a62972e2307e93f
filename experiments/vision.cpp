// Looks at random moments of matches and compares what is found in the pictures with the truth.
#include <cmath>

#include "Experiments.h"
#include "base/Statistics.h"
#include "colortable/GameViews.h"
#include "modules/modeling/FieldEdges.h"
#include "modules/perception/ColorTableFile.h"
#include "modules/perception/DefaultSensorDataProcessor.h"
#include "modules/perception/GT2003ImageProcessor.h"

namespace gt {
namespace {

/// Errors of one kind.
class Errors {
 public:
  void add(double value) { values_.push_back(value); }
  std::size_t count() const { return values_.size(); }
  double mean() const { return gt::mean(values_); }
  /// The size that a part of the errors does not exceed.
  double quantile(double part) const {
    std::vector<double> sizes;
    for (const double v : values_) sizes.push_back(std::abs(v));
    return gt::quantile(std::move(sizes), part);
  }

 private:
  std::vector<double> values_;
};

/// How often something was found of how often it was there.
struct Rate {
  int hits = 0, all = 0;

  void count(bool hit) {
    hits += hit ? 1 : 0;
    ++all;
  }
  double percent() const { return all == 0 ? 0 : 100.0 * hits / all; }
};

/// One run's measurements.
struct Run {
  Rate ball, ballFalse, flags, flagsFalse, goals, goalsFalse;
  Errors ballBearing, ballDistance, flagBearing, flagDistance, goalBearing, cameraTilt, cameraPan;
  EnumArray<EdgeType, Rate> edges;
  EnumArray<EdgeType, Errors> edgeErrors;
  int pictures = 0;
  Rate players, playersFalse, playersColor, freeGround;
  Errors playerDistance, freeDistance;
};

/// What is true in one picture, in the robot's system.
class Truth {
 public:
  Truth(const GameViews& views, const GameView& view) : views_(views), view_(view) {}

  Vector2d onRobot(const Vector2d& onField) const {
    return relative(views_.world().robot(view_.robot).pose, onField);
  }
  double bearing(const Vector2d& onField) const {
    return angleOf(onRobot(onField) - view_.camera.translation.head<2>());
  }
  double distance(const Vector2d& onField) const {
    return (onRobot(onField) - view_.camera.translation.head<2>()).norm();
  }
  Vector2d onField(const Vector2d& onRobot) const {
    return views_.world().robot(view_.robot).pose * onRobot;
  }
  /// Pixels of a class on a robot.
  template <typename Accept>
  int pixelsOf(const RobotParts& parts, Accept accept) const {
    int count = 0;
    for (std::size_t i = 0; i < view_.truth.geoms.size(); ++i)
      count += view_.truth.geoms[i] >= parts.firstGeom && view_.truth.geoms[i] < parts.lastGeom &&
               accept(view_.truth.classes[i]);
    return count;
  }
  /// Whether something that stands on the ground hides a point of it.
  bool standsAt(const GameView& view, const Vector2d& onGround) const {
    const CameraInfo& info = view.image.info;
    const Vector3d ray = Vector3d{onGround.x(), onGround.y(), 0} - view.camera.translation;
    const Vector3d inCamera = view.camera.rotation.transpose() * ray;
    if (inCamera.x() <= 0) return false;
    const Vector2d p = info.project(inCamera);
    if (!info.contains(p.x(), p.y())) return false;
    const int geom = view.truth.geoms[static_cast<std::size_t>(
        static_cast<int>(p.y()) * info.width + static_cast<int>(p.x()))];
    return geom >= 0 && views_.world().model().geom_group[geom] >= 2;
  }
  /// Pixels of a class that belong to geoms around a point of the field.
  template <typename Accept>
  int pixels(const Vector2d& onField, double radius, Accept accept) const {
    int count = 0;
    const mjData& data = views_.world().data();
    for (std::size_t i = 0; i < view_.truth.geoms.size(); ++i) {
      const int geom = view_.truth.geoms[i];
      if (geom < 0 || !accept(view_.truth.classes[i])) continue;
      const Vector2d p{1000 * data.geom_xpos[3 * geom], 1000 * data.geom_xpos[3 * geom + 1]};
      if ((p - onField).norm() < radius) ++count;
    }
    return count;
  }

 private:
  const GameViews& views_;
  const GameView& view_;
};

constexpr double focal = 161;  // Pixels, of the ERS-210's camera.

void measureBall(const Truth& truth, const GameViews& views, const GameView& view,
                 const FieldDimensions& field, const BallPercept& percept, Run& run) {
  const Vector2d position = views.world().ball(0).position;
  const Vector2d relativePosition = truth.onRobot(position);
  const Vector3d center{relativePosition.x(), relativePosition.y(), field.ballRadius};
  const Vector3d ray = center - view.camera.translation;
  const double distance = ray.norm();
  const double radius = focal * field.ballRadius / distance;
  const int visible =
      truth.pixels(position, 10, [](ColorClass c) { return c == ColorClass::orange; });
  const double error = std::abs(normalize(percept.angle.x() - azimuth(ray)));
  // Where the ball's centre is below the camera the horizontal angle means little.
  const double miss = std::acos(std::clamp(
      ray.normalized().dot(Vector3d{std::cos(percept.angle.x()) * std::cos(percept.angle.y()),
                                    std::sin(percept.angle.x()) * std::cos(percept.angle.y()),
                                    std::sin(percept.angle.y())}),
      -1.0, 1.0));
  const bool right = percept.seen && miss < fromDegrees(4);
  run.ballFalse.count(percept.seen && !right);
  if (radius < 3 || visible < pi * radius * radius / 2) return;
  run.ball.count(right);
  if (!right) return;
  run.ballBearing.add(toDegrees(error));
  if (distance < 1500)
    run.ballDistance.add(100 * (percept.offset.norm() / relativePosition.norm() - 1));
}

void measureFlags(const Truth& truth, const FieldDimensions& field, const LandmarksPercept& percept,
                  Run& run) {
  for (std::size_t type = 0; type < enumCount<FlagType>; ++type) {
    const Vector2d position = positionOf(static_cast<FlagType>(type), TeamColor::red, field);
    const double distance = truth.distance(position);
    const int visible = truth.pixels(position, 30, [](ColorClass c) {
      return c == ColorClass::pink || c == ColorClass::yellow || c == ColorClass::skyblue ||
             c == ColorClass::green;
    });
    const double whole =
        2 * field.flagRadius * (field.flagTop - field.flagBottom) * std::pow(focal / distance, 2);
    const FlagPercept* found = nullptr;
    for (int i = 0; i < percept.numberOfFlags; ++i)
      if (percept.flags[static_cast<std::size_t>(i)].type == static_cast<FlagType>(type))
        found = &percept.flags[static_cast<std::size_t>(i)];
    run.flagsFalse.count(found && visible < 4);
    if (distance < 3000 && visible > 0.9 * whole) run.flags.count(found != nullptr);
    if (!found || visible < 4) continue;
    const double half = std::asin(field.flagRadius / distance);
    const double bearing = truth.bearing(position);
    const ConditionalBoundary& b = found->boundary;
    if (!b.leftOnBorder) run.flagBearing.add(toDegrees(normalize(b.left - bearing - half)));
    if (!b.rightOnBorder) run.flagBearing.add(toDegrees(normalize(b.right - bearing + half)));
    if (found->distance > 0)
      run.flagDistance.add(100 * (found->distance / truth.onRobot(position).norm() - 1));
  }
}

void measureGoals(const Truth& truth, const FieldDimensions& field, const LandmarksPercept& percept,
                  Run& run) {
  for (const GoalColor color : {GoalColor::yellow, GoalColor::skyblue}) {
    const double side = color == GoalColor::yellow ? -1 : 1;
    const auto colorClass = color == GoalColor::yellow ? ColorClass::yellow : ColorClass::skyblue;
    const int visible =
        truth.pixels({side * 2250, 0}, 400, [&](ColorClass c) { return c == colorClass; });
    const GoalPercept* found = nullptr;
    for (int i = 0; i < percept.numberOfGoals; ++i)
      if (percept.goals[static_cast<std::size_t>(i)].color == color)
        found = &percept.goals[static_cast<std::size_t>(i)];
    run.goalsFalse.count(found && visible < 4);
    if (visible > 150) run.goals.count(found != nullptr);
    if (!found || visible < 4) continue;
    // Seen from the field, the opponent's left post is at positive y.
    const double left = truth.bearing({side * field.xGroundline, side * field.yGoal});
    const double right = truth.bearing({side * field.xGroundline, -side * field.yGoal});
    if (!found->boundary.leftOnBorder)
      run.goalBearing.add(toDegrees(normalize(found->boundary.left - left)));
    if (!found->boundary.rightOnBorder)
      run.goalBearing.add(toDegrees(normalize(found->boundary.right - right)));
  }
}

/// An edge point is right if an edge of its type is near enough, for its distance.
void measureEdges(const Truth& truth, const FieldEdges& edges, const LinesPercept& percept,
                  Run& run) {
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
    const auto type = static_cast<EdgeType>(t);
    for (const Vector2d& point : percept.points[type]) {
      const Vector2d onField = truth.onField(point);
      const double error = (edges.closest(type, onField) - onField).norm();
      const bool right = error < std::max(60., 0.1 * point.norm());
      run.edges[type].count(right);
      if (right && point.norm() < 1500) run.edgeErrors[type].add(error);
    }
  }
}

void measurePlayers(const Truth& truth, const GameViews& views, const GameView& view,
                    const std::vector<Player>& players, const PlayersPercept& percept, Run& run) {
  const auto nearest = [&](const Vector2d& position, TeamColor team) {
    double least = 1e9;
    for (const Vector2d& p : percept.players[team]) least = std::min(least, (p - position).norm());
    return least;
  };
  for (std::size_t i = 0; i < views.world().robotCount(); ++i) {
    if (i == view.robot) continue;
    const Vector2d position = truth.onRobot(views.world().robot(i).pose.translation);
    const double tolerance = std::max(250., 0.25 * position.norm());
    const TeamColor team = players[i].teamColor;
    const int visible = truth.pixelsOf(views.world().parts(i), [](ColorClass c) {
      return c == ColorClass::red || c == ColorClass::blue;
    });
    if (position.norm() > 1200 || visible < 40) continue;
    const double error = nearest(position, team);
    run.players.count(error < tolerance);
    if (error < tolerance) {
      run.playerDistance.add(error);
      run.playersColor.count(nearest(position, opponent(team)) > error);
    }
  }
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const Vector2d& p : percept.players[team]) {
      double least = 1e9;
      for (std::size_t i = 0; i < views.world().robotCount(); ++i)
        if (i != view.robot && players[i].teamColor == team)
          least =
              std::min(least, (truth.onRobot(views.world().robot(i).pose.translation) - p).norm());
      run.playersFalse.count(least > std::max(400., 0.4 * p.norm()));
    }
}

/// Free ground is overestimated where something stands on it, 15 cm before its far point or nearer.
void measureFreeGround(const Truth& truth, const GameView& view, const ObstaclesPercept& percept,
                       Run& run) {
  for (const FreeGround& line : percept.lines) {
    const Vector2d way = line.farPoint - line.nearPoint;
    const double length = way.norm();
    double free = length;
    for (double s = 0; s < length; s += 10)
      if (truth.standsAt(view, line.nearPoint + s / length * way)) {
        free = s;
        break;
      }
    run.freeGround.count(length - free <= 150);
    run.freeDistance.add(length - free);
  }
}

Result<Run> measure(const std::string& scene, const ColorTable64& colors, std::uint64_t seed,
                    const ExperimentOptions& options) {
  auto views = GameViews::make(scene, seed);
  if (!views) return views.error();
  const FieldDimensions field;
  const RobotDimensions dimensions;
  const FieldEdges edges{field, TeamColor::red};
  std::vector<Player> players;
  for (const auto* group : {&views->scene().robots, &views->scene().extras})
    for (const SceneRobot& robot : *group) players.push_back(robot.player());
  Run run;
  Debug debug;
  GT2003ImageProcessor imageProcessor;
  for (int i = 0; i < options.moments; ++i) {
    views->shuffle();
    for (std::size_t robot = 0; robot < views->world().activeRobots(); ++robot) {
      const GameView& view = views->look(robot, views->scene().camera);
      DefaultSensorDataProcessor sensorDataProcessor;
      CameraMatrix matrix;
      BodyPercept body;
      PsdPercept psd;
      sensorDataProcessor.update({view.image.time}, view.sensors, view.image, dimensions,
                                 RobotCalibration{}, MotionInfo{}, matrix, body, psd);
      const Vector3d axis = view.camera.rotation.col(0), seen = matrix.pose.rotation.col(0);
      run.cameraTilt.add(toDegrees(elevation(seen) - elevation(axis)));
      run.cameraPan.add(toDegrees(normalize(azimuth(seen) - azimuth(axis))));
      if (options.trueCamera) matrix.pose = view.camera;
      BallPercept ball;
      LandmarksPercept landmarks;
      LinesPercept lines;
      PlayersPercept others;
      ObstaclesPercept obstacles;
      imageProcessor.update(view.image, matrix, colors, field, ball, landmarks, lines, others,
                            obstacles, debug);
      const Truth truth{*views, view};
      ++run.pictures;
      measureBall(truth, *views, view, field, ball, run);
      measureFlags(truth, field, landmarks, run);
      measureGoals(truth, field, landmarks, run);
      measureEdges(truth, edges, lines, run);
      measurePlayers(truth, *views, view, players, others, run);
      measureFreeGround(truth, view, obstacles, run);
    }
  }
  return run;
}

void report(const std::vector<Run>& runs, Figures& figures) {
  const auto add = [&](const std::string& name, const char* unit, auto value, Aim aim = {}) {
    std::vector<double> values;
    for (const Run& run : runs) values.push_back(value(run));
    figures.add(name, unit, values, aim);
  };
  add(
      "vision.ball.found", "%", [](const Run& r) { return r.ball.percent(); }, Aim::atLeast(98));
  add(
      "vision.ball.false", "%", [](const Run& r) { return r.ballFalse.percent(); },
      Aim::atMost(0.1));
  add("vision.ball.bearing.median", "deg",
      [](const Run& r) { return r.ballBearing.quantile(0.5); });
  add("vision.ball.bearing.p95", "deg", [](const Run& r) { return r.ballBearing.quantile(0.95); });
  add("vision.ball.distance.mean", "%", [](const Run& r) { return r.ballDistance.mean(); });
  add(
      "vision.ball.distance.median", "%", [](const Run& r) { return r.ballDistance.quantile(0.5); },
      Aim::atMost(5));
  add("vision.ball.distance.p95", "%", [](const Run& r) { return r.ballDistance.quantile(0.95); });
  add(
      "vision.flags.found", "%", [](const Run& r) { return r.flags.percent(); }, Aim::atLeast(97));
  add(
      "vision.flags.false", "%", [](const Run& r) { return r.flagsFalse.percent(); },
      Aim::atMost(0.1));
  add("vision.flags.bearing.mean", "deg", [](const Run& r) { return r.flagBearing.mean(); });
  add("vision.flags.bearing.median", "deg",
      [](const Run& r) { return r.flagBearing.quantile(0.5); });
  add(
      "vision.flags.bearing.p95", "deg", [](const Run& r) { return r.flagBearing.quantile(0.95); },
      Aim::atMost(1));
  add("vision.flags.distance.median", "%",
      [](const Run& r) { return r.flagDistance.quantile(0.5); });
  add(
      "vision.goals.found", "%", [](const Run& r) { return r.goals.percent(); }, Aim::atLeast(97));
  add(
      "vision.goals.false", "%", [](const Run& r) { return r.goalsFalse.percent(); },
      Aim::atMost(0.1));
  add("vision.goals.bearing.mean", "deg", [](const Run& r) { return r.goalBearing.mean(); });
  add("vision.goals.bearing.median", "deg",
      [](const Run& r) { return r.goalBearing.quantile(0.5); });
  add("vision.goals.bearing.p95", "deg", [](const Run& r) { return r.goalBearing.quantile(0.95); });
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
    const auto type = static_cast<EdgeType>(t);
    const std::string name = "vision.edges." + std::string{enumNames<EdgeType>[t]};
    add(
        name + ".right", "%", [=](const Run& r) { return r.edges[type].percent(); },
        Aim::atLeast(97));
    add(name + ".perPicture", "points",
        [=](const Run& r) { return static_cast<double>(r.edges[type].all) / r.pictures; });
    add(name + ".error.median", "mm",
        [=](const Run& r) { return r.edgeErrors[type].quantile(0.5); });
  }
  add(
      "vision.players.found", "%", [](const Run& r) { return r.players.percent(); },
      Aim::atLeast(90));
  add(
      "vision.players.color", "%", [](const Run& r) { return r.playersColor.percent(); },
      Aim::atLeast(99));
  add("vision.players.false", "%", [](const Run& r) { return r.playersFalse.percent(); });
  add("vision.players.error.median", "mm",
      [](const Run& r) { return r.playerDistance.quantile(0.5); });
  add(
      "vision.freeGround.notOverestimated", "%",
      [](const Run& r) { return r.freeGround.percent(); }, Aim::atLeast(99));
  add("vision.camera.tilt.p95", "deg", [](const Run& r) { return r.cameraTilt.quantile(0.95); });
  add("vision.camera.pan.p95", "deg", [](const Run& r) { return r.cameraPan.quantile(0.95); });
}

}  // namespace

Result<void> measureVision(Figures& figures, const ExperimentOptions& options) {
  const auto colors = readColorTable("config/coltable.c64");
  if (!colors) return colors.error();
  std::vector<Run> runs;
  for (const std::uint64_t seed : options.seeds) {
    auto run = measure("scenes/match.scene", *colors, seed, options);
    if (!run) return run.error();
    runs.push_back(*std::move(run));
  }
  report(runs, figures);
  return {};
}

}  // namespace gt
