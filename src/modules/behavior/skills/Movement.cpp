#include "modules/behavior/skills/Movement.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {
namespace {

/// The area that a robot avoids: its own penalty area with a margin (mm, on the field).
struct KeptArea {
  double front, side;  // mm

  KeptArea(const FieldDimensions& field, double distance)
      : front{distance - field.xPenaltyArea}, side{field.yPenaltyArea + distance} {}

  bool contains(const Vector2d& place) const {
    return place.x() < front && std::abs(place.y()) < side;
  }
  /// The place of the border that is nearest to a place in the area.
  Vector2d exit(const Vector2d& place) const {
    if (front - place.x() < side - std::abs(place.y())) return {front, place.y()};
    return {place.x(), std::copysign(side, place.y())};
  }
  /// Whether the straight way between two places outside leads through it.
  bool parts(const Vector2d& from, const Vector2d& to) const {
    if (from.x() >= front && to.x() >= front) return false;
    const auto yAtFront = [&] {
      return from.y() + (to.y() - from.y()) * (front - from.x()) / (to.x() - from.x());
    };
    if (from.x() < front && to.x() < front) return (from.y() > 0) != (to.y() > 0);
    return std::abs(yAtFront()) < side;
  }
  Vector2d corner(double y) const { return {front, std::copysign(side, y)}; }
};

}  // namespace

double Movement::maxSideways() const {
  return manner_.type == WalkType::fast ? parameters_.fastSideways : parameters_.maxSideways;
}

double Movement::maxTurn() const {
  return fromDegrees(manner_.type == WalkType::fast ? parameters_.fastTurn : parameters_.maxTurn);
}

void Movement::walk(const Vector2d& wanted, double turn) {
  const Vector2d fair = manner_.endPushes ? keptFromPushing(wanted) : wanted;
  const Vector2d speed = manner_.keepOffOwnArea ? keptFromOwnArea(fair) : fair;
  request(MotionType::walk);
  request_.walk = {std::clamp(turn, -maxTurn(), maxTurn()),
                   std::clamp(speed.x(), -maxSideways(), parameters_.maxForward),
                   std::clamp(speed.y(), -maxSideways(), maxSideways())};
}

Vector2d Movement::keptFromPushing(const Vector2d& speed) {
  constexpr std::int64_t felt = 100, memory = 500;  // ms
  const WorldState& world = tactics_.world();
  const double passed = static_cast<double>(std::min(felt, world.frame.time - walked_));
  walked_ = world.frame.time;
  if (back_ > 0) {
    back_ -= passed;
    return -parameters_.backSpeed * pushing_.normalized();
  }
  // Counts as a referee does: a push has ended after the robot was free for half as long as it
  // pushed.
  const bool isHeldUp = world.frame.time - world.collision.lastCollision < felt;
  pushed_ = std::max(0., pushed_ + (isHeldUp ? passed : -2 * passed));
  if (pushed_ == 0) pushing_.setZero();
  pushing_ += (speed - pushing_) * passed / memory;
  if (pushed_ > parameters_.pushTime) {
    pushed_ = 0;
    back_ = parameters_.backTime;
  }
  return speed;
}

Vector2d Movement::keptFromOwnArea(const Vector2d& speed) const {
  const WorldState& world = tactics_.world();
  const KeptArea area{world.field, parameters_.offOwnArea};
  const Pose2D& self = world.self.pose;
  const Vector2d& place = self.translation;
  if (area.contains(place)) {
    const Vector2d out = area.exit(place) - place;
    const double length = std::max(out.norm(), 1.);
    const Vector2d away = rotated(out / length, -self.rotation);
    return speed + std::max(0., parameters_.leaveOwnArea - speed.dot(away)) * away;
  }
  const Vector2d nearest{std::min(place.x(), area.front),
                         std::clamp(place.y(), -area.side, area.side)};
  const double room = (nearest - place).norm();
  if (room < 1) return speed;
  const Vector2d into = rotated((nearest - place) / room, -self.rotation);
  const double fastest = parameters_.braking * room;
  return speed - std::max(0., speed.dot(into) - fastest) * into;
}

Vector2d Movement::pastOwnArea(const Vector2d& offset) const {
  if (!manner_.keepOffOwnArea) return offset;
  const WorldState& world = tactics_.world();
  const KeptArea area{world.field, parameters_.offOwnArea};
  const KeptArea around{world.field, parameters_.offOwnArea + parameters_.pastOwnArea};
  const Pose2D& self = world.self.pose;
  Vector2d place = self * offset;
  if (area.contains(place)) place = around.exit(place);
  if (!area.contains(self.translation) && area.parts(self.translation, place))
    place = around.corner(self.translation.x() < area.front ? self.translation.y() : place.y());
  return relative(self, place);
}

void Movement::approach(const Vector2d& wanted, double turn, double maxSpeed) {
  const Vector2d offset = pastOwnArea(wanted);
  // Braking: ever slower, but never so slowly that the robot does not arrive.
  const double distance = offset.norm();
  const double speed = std::min(maxSpeed, parameters_.slowest + parameters_.braking * distance);
  Vector2d v = distance < 1 ? Vector2d::Zero() : Vector2d{offset / distance * speed};
  v = keptFromPlayers(v);
  // The same direction at the speed that the slower of the two axes allows.
  const double maxX = v.x() > 0 ? parameters_.maxForward : maxSideways();
  const double over = std::max(std::abs(v.x()) / maxX, std::abs(v.y()) / maxSideways());
  if (over > 1) v /= over;
  walk(v, parameters_.turning * turn);
}

Vector2d Movement::keptFromPlayers(Vector2d speed) const {
  // Walking into a robot moves neither of both and is a foul: the component of the speed that
  // points at a near robot is removed. A robot that gives way steps back by the missing distance in
  // a second.
  const double keptOff = manner_.giveWay ? parameters_.giveWay : parameters_.keepOff;
  const double leastRoom = std::min(0., parameters_.keepOff - keptOff);
  const WorldState& world = tactics_.world();
  const PlayersCollection& players = world.players;
  for (const auto* team : {&players.opponents, &players.ownTeam})
    for (const LocatedPlayer& player : *team) {
      const Vector2d to = relative(world.self.pose, player.position);
      const double distance = to.norm(), room = distance - keptOff;
      if (room > 150 || distance < 1) continue;
      const double closing = to.dot(speed) / distance;
      speed -= std::max(0., closing - std::max(leastRoom, room)) * to / distance;
    }
  return speed;
}

void Movement::approachAvoiding(const Vector2d& wanted, double turn, double maxSpeed) {
  const Vector2d offset = pastOwnArea(wanted);
  const ObstaclesModel& obstacles = tactics_.obstacles();
  const double width = parameters_.clearance;
  const double heading = angleOf(offset), needed = std::min(offset.norm(), parameters_.freeWay);
  // Move freely.
  if (corridor(obstacles, heading, width) >= needed) return approach(offset, turn, maxSpeed);
  // Avoid the obstacle: turn to a free direction, and walk as fast as the room allows.
  auto way = freeDirection(obstacles, heading, width, needed);
  if (!way) way = freeDirection(obstacles, heading, width, needed / 2);
  const double room = corridor(obstacles, 0, width) - parameters_.stopBefore;
  const double speed = std::clamp(room, -50., maxSpeed);
  walk({way ? speed * std::max(0., std::cos(*way)) : std::min(speed, 0.), 0},
       parameters_.turning * way.value_or(heading));
}

void Movement::followField(const PotentialField& field, const Pose2D& target, double maxSpeed) {
  const WorldState& world = tactics_.world();
  PotentialScene scene =
      PotentialScene::of(world, tactics_.obstacles(), tactics_.knownBallOnField());
  scene.setTarget(target.translation);
  const Pose2D& self = world.self.pose;
  const Vector2d force =
      pilot_.update(field, std::move(scene), self.translation, parameters_.pilot);
  piloted_ = true;
  const double fastest = maxSpeed > 0 ? maxSpeed : parameters_.maxForward;
  const double finalTurn = normalize(target.rotation - self.rotation);
  if ((target.translation - self.translation).norm() < parameters_.pilot.arrival)
    return approach(relative(self, target.translation), finalTurn, fastest);
  const double strength = force.norm();
  const Vector2d ahead =
      strength > 0 ? rotated(force / strength, -self.rotation) : Vector2d::Zero();
  const bool near = (target.translation - self.translation).norm() < parameters_.faceTarget;
  const double turn = near ? finalTurn : angleOf(ahead);
  double speed = fastest * std::min(1., strength);
  // Far away the robot walks in the direction that it faces, so it turns first.
  if (!near) speed *= std::max(0.2, std::cos(std::min(std::abs(turn), pi / 2)));
  const double over = std::abs(ahead.y()) * speed / maxSideways();
  walk(ahead * speed / std::max(1., over), parameters_.turning * turn);
}

}  // namespace gt
