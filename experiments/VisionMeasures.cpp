#include "VisionMeasures.h"

#include <algorithm>
#include <cmath>

#include "measure/Pairs.h"
#include "modules/perception/scanning/CameraImage.h"

namespace gt {
namespace {

using Thing = VisionTruth::Kind;

constexpr double widestMiss = fromDegrees(4);  ///< Up to which a direction counts as right.
constexpr int leastVisible = 4;  ///< Pixels below which a landmark does not count as seen.

std::string bandOf(double distance) {
  return distance < 500    ? "to500mm"
         : distance < 1000 ? "to1000mm"
         : distance < 1500 ? "to1500mm"
         : distance < 2500 ? "to2500mm"
                           : "farther";
}

/// Of a kind of things: counts for all of them and for those of a band of distances.
class Banded {
 public:
  Banded(Tally& tally, const std::string& name, double distance)
      : tally_(tally), all_(name + "."), band_(all_ + bandOf(distance) + ".") {}

  void count(const std::string& what, bool hit) {
    tally_.count(all_ + what, hit);
    tally_.count(band_ + what, hit);
  }
  void measure(const std::string& what, const char* unit, double error) {
    tally_.measure(all_ + what, unit, error);
    tally_.measure(band_ + what, unit, error);
  }

 private:
  Tally& tally_;
  std::string all_, band_;
};

Vector3d directionOf(const Vector2d& angles) {
  return {std::cos(angles.x()) * std::cos(angles.y()), std::sin(angles.x()) * std::cos(angles.y()),
          std::sin(angles.y())};
}

}  // namespace

double VisionMeasures::bearing(const Vector2d& place) const {
  return angleOf(place - truth_.camera().pose.translation.head<2>());
}
double VisionMeasures::distance(const Vector2d& place) const {
  return (place - truth_.camera().pose.translation.head<2>()).norm();
}

void VisionMeasures::comparePercepts(const FoundPercepts& percepts, const CameraMatrix& measured,
                                     Tally& tally) {
  compareBall(percepts.ball, tally);
  compareFlags(percepts.landmarks, tally);
  compareGoals(percepts.landmarks, tally);
  compareEdges(percepts.lines, measured, tally);
  comparePlayers(percepts.players, tally);
  compareObstacles(percepts.obstacles, tally);
}

void VisionMeasures::compareSensors(const RobotBody& body, const CameraMatrix& matrix,
                                    const BodyPercept& percept, Tally& tally) const {
  const Vector3d axis = truth_.camera().pose.rotation.col(0), seen = matrix.pose.rotation.col(0);
  tally.measure("camera.tilt", "deg", toDegrees(elevation(seen) - elevation(axis)));
  tally.measure("camera.pan", "deg", toDegrees(normalize(azimuth(seen) - azimuth(axis))));
  tally.measure("camera.height", "mm",
                matrix.pose.translation.z() - truth_.camera().pose.translation.z());
  tally.measure("body.tilt", "deg", toDegrees(percept.tilt - body.tilt));
  tally.measure("body.roll", "deg", toDegrees(percept.roll - body.roll));
}

// A ball counts with a radius of three pixels and half of it visible; one of which less is visible,
// or which the image's border cuts off, has figures of its own. A percept is at its place if both
// its direction and its place on the ground are the ball's.
void VisionMeasures::compareBall(const BallPercept& percept, Tally& tally) const {
  constexpr double smallest = 3;               // Pixels, the radius.
  constexpr int fewest = 12;                   // Pixels.
  constexpr double share = 0.25, least = 100;  // Of the distance, at least so many mm.
  const Vector2d place = truth_.ball();
  const Vector3d ray =
      Vector3d{place.x(), place.y(), field_.ballRadius} - truth_.camera().pose.translation;
  const double away = ray.norm(), angle = std::asin(std::min(1., field_.ballRadius / away));
  const double radius = truth_.camera().info.focalX * std::tan(angle);
  const double miss =
      std::acos(std::clamp(ray.normalized().dot(directionOf(percept.angle)), -1., 1.));
  const int visible = truth_.pixels(Thing::ball);
  const bool right = percept.seen && visible > 0 && miss < std::max(widestMiss, angle) &&
                     (percept.offset - place).norm() < std::max(least, share * place.norm());
  tally.count("ball.false", percept.seen && !right);
  if (radius < smallest || visible < fewest) return;
  const auto countAs = [&](const std::string& name) {
    Banded ball{tally, name, away};
    ball.count("found", right);
    if (!right) return;
    ball.measure("bearing", "deg", toDegrees(normalize(percept.angle.x() - azimuth(ray))));
    const double error = 100 * (percept.offset.norm() / place.norm() - 1);
    if (away < 1500) ball.measure("distance", "%", error);
  };
  const CameraInfo& info = truth_.camera().info;
  const Vector2d center = pointIn(truth_.camera(), ray);
  const bool whole = center.x() >= radius && center.x() <= info.width - radius &&
                     center.y() >= radius && center.y() <= info.height - radius;
  countAs(visible >= pi * radius * radius / 2 ? "ball" : "ball.partly");
  if (!whole) countAs("ball.rim");
}

// One percept is right for a flag; what is seen of a flag that is not seen as a whole lies anywhere
// within it.
void VisionMeasures::compareFlags(const LandmarksPercept& percept, Tally& tally) const {
  for (std::size_t type = 0; type < enumCount<FlagType>; ++type) {
    const Vector2d place = truth_.flag(static_cast<FlagType>(type));
    const double away = distance(place);
    const int visible = truth_.pixels(Thing::flag, type);
    const double whole = 2 * field_.flagRadius * (field_.flagTop - field_.flagBottom) *
                         std::pow(truth_.camera().info.focalX / away, 2);
    const bool isWhole = visible > 0.9 * whole;
    const double half = std::asin(std::min(1., field_.flagRadius / away));
    Banded flags{tally, "flags", away};
    bool found = false;
    for (int i = 0; i < percept.numberOfFlags; ++i) {
      const FlagPercept& flag = percept.flags[static_cast<std::size_t>(i)];
      if (flag.type != static_cast<FlagType>(type)) continue;
      const double error = normalize(flag.angle - angleOf(place));
      const bool right =
          !found && visible >= leastVisible && std::abs(error) < widestMiss + (isWhole ? 0 : half);
      tally.count("flags.false", !right);
      if (!right) continue;
      found = true;
      if (!isWhole) continue;
      flags.measure("bearing", "deg", toDegrees(error));
      if (flag.distance > 0)
        flags.measure("distance", "%", 100 * (flag.distance / place.norm() - 1));
    }
    if (away < 3000 && isWhole) {
      flags.count("found", found);
      tally.count("flags." + std::string{enumNames<FlagType>[type]} + ".found", found);
    }
  }
}

// The edges that the percept knows are at the posts; edges on the border of the image and the
// middle of what is seen are between them.
bool VisionMeasures::isAtGoal(const GoalPercept& goal) const {
  const Vector2d leftPost = truth_.post(goal.color, true);
  const Vector2d rightPost = truth_.post(goal.color, false);
  const auto isNear = [](double angle, double other) {
    return std::abs(normalize(angle - other)) < widestMiss;
  };
  const auto isBetween = [](double angle, double left, double right) {
    return normalize(angle - right) > -widestMiss && normalize(left - angle) > -widestMiss;
  };
  const double left = bearing(leftPost), right = bearing(rightPost);
  const ConditionalBoundary& b = goal.boundary;
  return (b.leftOnBorder ? isBetween(b.left, left, right) : isNear(b.left, left)) &&
         (b.rightOnBorder ? isBetween(b.right, left, right) : isNear(b.right, right)) &&
         isBetween(goal.angle, angleOf(leftPost), angleOf(rightPost));
}

// One percept is right for a goal.
void VisionMeasures::compareGoals(const LandmarksPercept& percept, Tally& tally) const {
  constexpr int well = 150;  // Pixels.
  for (const GoalColor color : {GoalColor::yellow, GoalColor::skyblue}) {
    const Vector2d leftPost = truth_.post(color, true), rightPost = truth_.post(color, false);
    const int visible = truth_.pixels(Thing::goal, static_cast<std::size_t>(color));
    Banded goals{tally, "goals", distance((leftPost + rightPost) / 2)};
    bool found = false;
    for (int i = 0; i < percept.numberOfGoals; ++i) {
      const GoalPercept& goal = percept.goals[static_cast<std::size_t>(i)];
      if (goal.color != color) continue;
      const bool right = !found && visible >= leastVisible && isAtGoal(goal);
      tally.count("goals.false", !right);
      if (!right) continue;
      found = true;
      const ConditionalBoundary& b = goal.boundary;
      if (!b.leftOnBorder)
        goals.measure("bearing", "deg", toDegrees(normalize(b.left - bearing(leftPost))));
      if (!b.rightOnBorder)
        goals.measure("bearing", "deg", toDegrees(normalize(b.right - bearing(rightPost))));
      const bool whole = !b.leftOnBorder && !b.rightOnBorder && !b.topOnBorder && !b.bottomOnBorder;
      if (whole && goal.distance > 0)
        goals.measure("distance", "%",
                      100 * (goal.distance / ((leftPost + rightPost) / 2).norm() - 1));
    }
    if (visible > well) {
      goals.count("found", found);
      tally.count("goals." + std::string{enumName(color)} + ".found", found);
    }
  }
}

void VisionMeasures::compareEdges(const LinesPercept& percept, const CameraMatrix& measured,
                                  Tally& tally) const {
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
    const auto type = static_cast<EdgeType>(t);
    const Thing kind = type == EdgeType::line     ? Thing::line
                       : type == EdgeType::border ? Thing::border
                                                  : Thing::goal;
    for (const Vector2d& point : percept.points[type]) {
      const Vector3d ray = Vector3d{point.x(), point.y(), 0} - measured.pose.translation;
      Banded edges{tally, "edges." + std::string{enumNames<EdgeType>[t]}, distance(point)};
      const bool right =
          truth_.shows(pointIn(measured, ray), kind, type == EdgeType::skyblueGoal ? 1 : 0);
      edges.count("right", right);
      const Vector2d onField = truth_.onField(point);
      if (right) edges.measure("error", "mm", (edges_.closest(type, onField) - onField).norm());
    }
  }
}

bool VisionMeasures::isTowardsRobot(const Vector2d& place) const {
  constexpr double half = 140;  // mm, of a robot's length
  for (std::size_t i = 0; i < truth_.robots(); ++i) {
    if (truth_.isOwn(i) || truth_.pixels(Thing::tricot, i) == 0) continue;
    const Vector2d robot = truth_.robot(i);
    const double wide = widestMiss + std::asin(std::min(1., half / distance(robot)));
    if (std::abs(normalize(bearing(place) - bearing(robot))) < wide) return true;
  }
  return false;
}

// Percepts belong one to one to robots whose tricot is seen: first to those of their color, then to
// those of the other one.
void VisionMeasures::comparePlayers(const PlayersPercept& percept, Tally& tally) const {
  constexpr int least = 40;         // Pixels of tricot.
  constexpr double farthest = 250;  // mm, from a robot to its percept.
  EnumArray<TeamColor, std::vector<Vector2d>> missed, left;
  const auto countFalse = [&](const Vector2d& place, bool misplaced, bool nothing) {
    Banded players{tally, "players", place.norm()};
    players.count("misplaced", misplaced);
    players.count("nothing", nothing);
  };
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    std::vector<std::size_t> robots;
    std::vector<Vector2d> places;
    for (std::size_t i = 0; i < truth_.robots(); ++i) {
      if (truth_.isOwn(i) || truth_.team(i) != team || truth_.pixels(Thing::tricot, i) == 0)
        continue;
      robots.push_back(i);
      places.push_back(truth_.robot(i));
    }
    const std::vector<Vector2d>& percepts = percept.players[team];
    const auto assigned = pairNearest(places, percepts, farthest);
    std::vector<bool> used(percepts.size());
    for (std::size_t k = 0; k < places.size(); ++k) {
      if (assigned[k])
        used[*assigned[k]] = true;
      else
        missed[team].push_back(places[k]);
      if (truth_.pixels(Thing::tricot, robots[k]) < least) continue;
      const double away = places[k].norm();
      Banded players{tally, away < 1200 ? "players" : "players.distant", away};
      players.count("found", assigned[k].has_value());
      players.count(std::string{enumName(team)} + ".found", assigned[k].has_value());
      if (!assigned[k]) continue;
      const Vector2d& p = percepts[*assigned[k]];
      players.measure("error", "mm", (p - places[k]).norm());
      players.measure("range", "mm", p.norm() - away);
    }
    for (std::size_t k = 0; k < percepts.size(); ++k) {
      if (!used[k]) {
        left[team].push_back(percepts[k]);
        continue;
      }
      countFalse(percepts[k], false, false);
      tally.count("players.color", true);
    }
  }
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    const auto robotOf = pairNearest(left[team], missed[opponent(team)], farthest);
    for (std::size_t k = 0; k < left[team].size(); ++k) {
      const bool misplaced = !robotOf[k] && isTowardsRobot(left[team][k]);
      countFalse(left[team][k], misplaced, !robotOf[k] && !misplaced);
      if (robotOf[k]) tally.count("players.color", false);
    }
  }
}

VisionMeasures::Free VisionMeasures::freeGround(const FreeGround& line) const {
  constexpr double step = 20, longest = 6000;  // mm; that is longer than the field.
  const double length = (line.farPoint - line.nearPoint).norm();
  const Vector2d towards = length > 0 ? Vector2d{line.farPoint - line.nearPoint}
                                      : line.nearPoint - truth_.camera().pose.translation.head<2>();
  const Vector2d along = towards.normalized();
  double s = 0;
  for (; s < std::max(length, longest); s += step) {
    const auto kind = truth_.at(line.nearPoint + s * along);
    if (!kind && s > length) break;  // the border of the image
    if (kind && *kind != Thing::ground && *kind != Thing::line && *kind != Thing::background) break;
  }
  return {along, s};
}

// 15 cm or one and a half pixels, whichever is more: at 2 m a pixel is 11 cm, at 3 m 25.
bool VisionMeasures::isSameEnd(const Vector2d& a, const Vector2d& b) const {
  constexpr double tolerance = 150, pixels = 1.5;  // mm, pixels
  if ((a - b).norm() <= tolerance) return true;
  const auto inImage = [&](const Vector2d& place) {
    const Vector3d ray = Vector3d{place.x(), place.y(), 0} - truth_.camera().pose.translation;
    return pointIn(truth_.camera(), ray);
  };
  return (inImage(a) - inImage(b)).norm() <= pixels;
}

// Free ground is overestimated where something stands clearly before its far point, underestimated
// where nothing does up to clearly behind it.
void VisionMeasures::compareObstacles(const ObstaclesPercept& percept, Tally& tally) const {
  for (const FreeGround& line : percept.lines) {
    const auto [along, free] = freeGround(line);
    const double length = (line.farPoint - line.nearPoint).norm();
    const bool same = isSameEnd(line.farPoint, line.nearPoint + free * along);
    Banded ground{tally, "freeGround", line.nearPoint.norm() + std::min(length, free)};
    ground.count("notOverestimated", length <= free || same);
    ground.count("notUnderestimated", length >= free || same);
  }
}

}  // namespace gt
