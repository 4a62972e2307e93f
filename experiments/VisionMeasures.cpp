#include "VisionMeasures.h"

#include <algorithm>
#include <cmath>

#include "modules/perception/scanning/CameraImage.h"

namespace gt {
namespace {

using Thing = VisionTruth::Kind;

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

// A ball counts with a radius of three pixels and half of it visible. It is a false one if what was
// found lies elsewhere.
void VisionMeasures::compareBall(const BallPercept& percept, Tally& tally) const {
  const Vector2d place = truth_.ball();
  const Vector3d ray =
      Vector3d{place.x(), place.y(), field_.ballRadius} - truth_.camera().pose.translation;
  const double away = ray.norm(), angle = std::asin(std::min(1., field_.ballRadius / away));
  const double radius = truth_.camera().info.focalX * std::tan(angle);
  const double miss =
      std::acos(std::clamp(ray.normalized().dot(directionOf(percept.angle)), -1., 1.));
  const bool right = percept.seen && miss < std::max(fromDegrees(4), angle);
  tally.count("ball.false", percept.seen && !right);
  if (radius < 3 || truth_.pixels(Thing::ball) < pi * radius * radius / 2) return;
  Banded ball{tally, "ball", away};
  ball.count("found", right);
  if (!right) return;
  ball.measure("bearing", "deg", toDegrees(normalize(percept.angle.x() - azimuth(ray))));
  const double error = 100 * (percept.offset.norm() / place.norm() - 1);
  if (away < 1500) ball.measure("distance", "%", error);
}

void VisionMeasures::compareFlags(const LandmarksPercept& percept, Tally& tally) const {
  constexpr int least = 4;  // Pixels, below which a thing does not count as seen.
  constexpr double elsewhere = fromDegrees(4);
  for (std::size_t type = 0; type < enumCount<FlagType>; ++type) {
    const Vector2d place = truth_.flag(static_cast<FlagType>(type));
    const double away = distance(place);
    const int visible = truth_.pixels(Thing::flag, type);
    const double whole = 2 * field_.flagRadius * (field_.flagTop - field_.flagBottom) *
                         std::pow(truth_.camera().info.focalX / away, 2);
    const auto end = percept.flags.begin() + percept.numberOfFlags;
    const auto found = std::find_if(percept.flags.begin(), end, [&](const FlagPercept& flag) {
      return flag.type == static_cast<FlagType>(type);
    });
    Banded flags{tally, "flags", away};
    const bool isWhole = visible > 0.9 * whole;
    if (away < 3000 && isWhole) {
      flags.count("found", found != end);
      tally.count("flags." + std::string{enumNames<FlagType>[type]} + ".found", found != end);
    }
    if (found == end) continue;
    const double error = normalize(found->angle - angleOf(place));
    // What is seen of a flag that the image cuts off lies anywhere within it.
    const double half = std::asin(std::min(1., field_.flagRadius / away));
    const bool wrong = visible < least || std::abs(error) > elsewhere + half;
    tally.count("flags.false", wrong);
    if (wrong || !isWhole) continue;
    flags.measure("bearing", "deg", toDegrees(error));
    if (found->distance > 0)
      flags.measure("distance", "%", 100 * (found->distance / place.norm() - 1));
  }
}

void VisionMeasures::compareGoals(const LandmarksPercept& percept, Tally& tally) const {
  constexpr int least = 4, well = 150;  // Pixels.
  for (const GoalColor color : {GoalColor::yellow, GoalColor::skyblue}) {
    const Vector2d leftPost = truth_.post(color, true), rightPost = truth_.post(color, false);
    const int visible = truth_.pixels(Thing::goal, static_cast<std::size_t>(color));
    const auto end = percept.goals.begin() + percept.numberOfGoals;
    const auto found = std::find_if(percept.goals.begin(), end,
                                    [&](const GoalPercept& goal) { return goal.color == color; });
    Banded goals{tally, "goals", distance((leftPost + rightPost) / 2)};
    if (visible > well) {
      goals.count("found", found != end);
      tally.count("goals." + std::string{enumName(color)} + ".found", found != end);
    }
    if (found == end) continue;
    tally.count("goals.false", visible < least);
    if (visible < least) continue;
    const ConditionalBoundary& b = found->boundary;
    if (!b.leftOnBorder)
      goals.measure("bearing", "deg", toDegrees(normalize(b.left - bearing(leftPost))));
    if (!b.rightOnBorder)
      goals.measure("bearing", "deg", toDegrees(normalize(b.right - bearing(rightPost))));
    const bool whole = !b.leftOnBorder && !b.rightOnBorder && !b.topOnBorder && !b.bottomOnBorder;
    if (whole && found->distance > 0)
      goals.measure("distance", "%",
                    100 * (found->distance / ((leftPost + rightPost) / 2).norm() - 1));
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

// A percept belongs to a robot of its color whose tricot is seen in that direction, if there is
// one.
void VisionMeasures::comparePlayers(const PlayersPercept& percept, Tally& tally) const {
  constexpr int least = 40;  // Pixels of tricot.
  for (std::size_t i = 0; i < truth_.robots(); ++i) {
    const Vector2d place = truth_.robot(i);
    if (truth_.isOwn(i) || truth_.pixels(Thing::tricot, i) < least) continue;
    double error = 1e9, range = 0;
    for (const Vector2d& p : percept.players[truth_.team(i)]) {
      if ((p - place).norm() >= error) continue;
      error = (p - place).norm();
      range = p.norm() - place.norm();
    }
    const bool found = error < std::max(250., 0.25 * place.norm());
    Banded players{tally, place.norm() < 1200 ? "players" : "players.distant", place.norm()};
    players.count("found", found);
    players.count(std::string{enumName(truth_.team(i))} + ".found", found);
    if (found) players.measure("error", "mm", error);
    if (found) players.measure("range", "mm", range);
  }
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    for (const Vector2d& p : percept.players[team]) {
      bool any = false, right = false;
      for (std::size_t i = 0; i < truth_.robots(); ++i) {
        if (truth_.isOwn(i) || truth_.pixels(Thing::tricot, i) == 0) continue;
        const double wide = std::max(fromDegrees(5), std::atan2(200, distance(truth_.robot(i))));
        if (std::abs(normalize(bearing(truth_.robot(i)) - bearing(p))) > wide) continue;
        any = true;
        right = right || truth_.team(i) == team;
      }
      tally.count("players.false", !any);
      if (any) tally.count("players.color", right);
    }
}

// Free ground is overestimated where something stands on it, 15 cm before its far point or nearer.
void VisionMeasures::compareObstacles(const ObstaclesPercept& percept, Tally& tally) const {
  constexpr double step = 20, tolerance = 150;  // mm
  for (const FreeGround& line : percept.lines) {
    const Vector2d way = line.farPoint - line.nearPoint;
    const double length = way.norm();
    double free = length;
    for (double s = 0; s < length; s += step) {
      const auto kind = truth_.at(line.nearPoint + s / length * way);
      if (!kind || *kind == Thing::ground || *kind == Thing::line || *kind == Thing::background)
        continue;
      free = s;
      break;
    }
    Banded ground{tally, "freeGround", line.nearPoint.norm() + free};
    ground.count("notOverestimated", length - free <= tolerance);
  }
}

}  // namespace gt
