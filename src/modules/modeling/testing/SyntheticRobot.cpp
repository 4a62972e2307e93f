#include "modules/modeling/testing/SyntheticRobot.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/Bearings.h"

namespace gt {
namespace {

constexpr double openingAngle = 57.6 * pi / 180;  // facts, 1.3
constexpr double headLimit = 89 * pi / 180;
constexpr double headSpeed = 2.2;  // rad/s while searching
constexpr double dt = SyntheticRobot::imagePeriod / 1000.0;

}  // namespace

SyntheticRobot::SyntheticRobot(std::uint64_t seed, const SyntheticWorld& world)
    : world_{world},
      random_{seed},
      seeing_{random_.fork("edges")},
      moving_{world.walks},
      edges_{field, TeamColor::red} {
  player.teamColor = random_.chance(0.5) ? TeamColor::red : TeamColor::blue;
  edges_ = FieldEdges{field, player.teamColor};
  Random places = random_.fork("flags");
  for (Vector2d& error : flagErrors_)
    error = world.misplacedFlags * direction(pi * places.symmetric());
  pose = placeOnField();
  headPan_ = random_.uniform(-headLimit, headLimit);
  chooseGoal();
}

Pose2D SyntheticRobot::placeOnField() {
  const double x = (field.xGroundline - 150) * random_.symmetric();
  const double y = (field.ySideline - 150) * random_.symmetric();
  return {pi * random_.symmetric(), x, y};
}

void SyntheticRobot::chooseGoal() {
  goal_ = placeOnField();
  const double slipX = world_.slip * random_.symmetric();
  const double slipY = world_.slip * random_.symmetric();
  slip_ = {world_.slip * random_.symmetric(), slipX, slipY};
}

void SyntheticRobot::kidnap() {
  pose = placeOnField();
  chooseGoal();
}

void SyntheticRobot::step() {
  time = time + imagePeriod;
  if (world_.walks) walk(towardsGoal());
  perceive();
}

void SyntheticRobot::step(const Pose2D& speed) {
  time = time + imagePeriod;
  moving_ = speed.translation.norm() + 200 * std::abs(speed.rotation) > 1;
  if (moving_) walk({speed.rotation * dt, speed.translation * dt});
  perceive();
}

void SyntheticRobot::perceive() {
  turnHead();
  see();
}

/// Turns towards the goal while walking, as go-to-point does.
Pose2D SyntheticRobot::towardsGoal() {
  const Vector2d toGoal = relative(pose, goal_.translation);
  if (toGoal.norm() < 100) chooseGoal();
  return {std::clamp(angleOf(toGoal), -1.0, 1.0) * dt,
          toGoal.normalized() * world_.walkingSpeed * dt};
}

void SyntheticRobot::walk(Pose2D step) {
  odometry.pose = odometry.pose * step;

  if (random_.chance(dt / world_.secondsBetweenBlocks))
    blockedUntil_ =
        time + static_cast<std::int64_t>(1000 * random_.uniform(0.3, 1) * world_.secondsBlocked);
  if (time < blockedUntil_) {  // Feet slip in place and turn the robot a little.
    step = {0.3 * step.rotation + 0.005 * random_.gaussian(), 0, 0};
  } else {
    step.rotation *= 1 + slip_.rotation + world_.stepNoise * random_.gaussian();
    step.translation.x() *= 1 + slip_.translation.x() + world_.stepNoise * random_.gaussian();
    step.translation.y() *= 1 + slip_.translation.y() + world_.stepNoise * random_.gaussian();
  }
  pose = pose * step;
  pose.translation.x() =
      std::clamp(pose.translation.x(), -field.xGroundline + 120, field.xGroundline - 120);
  pose.translation.y() =
      std::clamp(pose.translation.y(), -field.ySideline + 80, field.ySideline - 80);
}

void SyntheticRobot::turnHead() {
  if (time > modeUntil_) {
    tracksBall_ = !world_.turnsHeadAlways && random_.chance(0.5);
    ballPan_ = random_.uniform(-0.8, 0.8);
    modeUntil_ = time + static_cast<std::int64_t>(random_.uniform(1000, 4000));
  }
  if (tracksBall_) {
    headPan_ += std::clamp(ballPan_ - headPan_, -0.12, 0.12);
    return;
  }
  // From left to right and back.
  const double sweep = 4 * headLimit / headSpeed;
  const double phase = std::fmod(seconds() / sweep, 1);
  const double target = headLimit * (phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase);
  headPan_ += std::clamp(target - headPan_, -0.12, 0.12);
}

void SyntheticRobot::see() {
  percept = {};
  percept.time = time;
  lines.time = time;
  for (auto& points : lines.points) points.clear();
  percept.cameraOffset = {123 + 66.6 * std::cos(headPan_), 66.6 * std::sin(headPan_), 180};
  commonError_ = world_.commonNoise * random_.gaussian() +
                 (moving_ ? world_.sway * std::sin(seconds() * 2 * pi / 0.67) : 0);
  if (world_.hidden > 0) placeRobotsInTheWay();
  camera.time = time;
  camera.valid = true;
  camera.pose.translation = percept.cameraOffset;
  if (seeing_.chance(world_.lostPictures)) return;
  for (int i = world_.flags ? world_.missingFlags : 6; i < 6; ++i)
    seeFlag(static_cast<FlagType>(i));
  for (int i = 0; i < 2; ++i) seeGoal(static_cast<GoalColor>(i));
  seeEdges();
}

/// Places other robots around the robot for some time.
void SyntheticRobot::placeRobotsInTheWay() {
  if (time < robotsMoveAt_) return;
  robotsMoveAt_ = time + static_cast<std::int64_t>(seeing_.uniform(1000, 3000));
  for (bool& hidden : hiddenSectors_) hidden = seeing_.chance(world_.hidden);
}

bool SyntheticRobot::isHidden(double angle) const {
  const double sector = (normalize(angle) + pi) / (2 * pi) * hiddenSectors_.size();
  return hiddenSectors_[std::min(static_cast<std::size_t>(sector), hiddenSectors_.size() - 1)];
}

bool SyntheticRobot::cutToImage(ConditionalBoundary& boundary) {
  const double left = headPan_ + openingAngle / 2, right = headPan_ - openingAngle / 2;
  boundary.leftOnBorder = boundary.left > left;
  boundary.rightOnBorder = boundary.right < right;
  boundary.left = boundary.leftOnBorder
                      ? left
                      : boundary.left + commonError_ + world_.edgeNoise * random_.gaussian();
  boundary.right = boundary.rightOnBorder
                       ? right
                       : boundary.right + commonError_ + world_.edgeNoise * random_.gaussian();
  return boundary.left - boundary.right > 0.012;
}

void SyntheticRobot::seeFlag(FlagType type) {
  const Vector2d from = pose * percept.cameraOffset.head<2>();
  const Vector2d toFlag = positionOf(type, player.teamColor, field) +
                          flagErrors_[static_cast<std::size_t>(type)] - from;
  const double distance = toFlag.norm();
  if (distance > world_.range || distance < 2 * field.flagRadius) return;
  if (random_.chance(0.05 + 0.3 * distance / world_.range)) return;
  double center = normalize(angleOf(toFlag) - pose.rotation);
  if (random_.chance(world_.outliers)) {
    if (random_.chance(0.5))
      type = static_cast<FlagType>(random_.index(6));
    else
      center = headPan_ + random_.uniform(-0.5, 0.5);
  }
  if (isHidden(center)) return;
  const double half = std::asin(field.flagRadius / distance);
  FlagPercept flag;
  flag.type = type;
  flag.boundary.left = center + half;
  flag.boundary.right = center - half;
  if (!cutToImage(flag.boundary)) return;
  const double noise = 1 + (0.04 + 0.03 * distance / 1000) * random_.gaussian();
  const double middle = (flag.boundary.left + flag.boundary.right) / 2;
  const Vector2d seen =
      percept.cameraOffset.head<2>() + direction(middle) * std::max(distance * noise, 100.0);
  const bool cut = flag.boundary.leftOnBorder || flag.boundary.rightOnBorder;
  flag.angle = angleOf(seen);
  flag.distance = cut ? 0 : seen.norm();
  percept.flags[static_cast<std::size_t>(percept.numberOfFlags++)] = flag;
}

void SyntheticRobot::seeGoal(GoalColor color) {
  const Vector2d from = pose * percept.cameraOffset.head<2>();
  const Vector2d left = positionOfPost(color, true, player.teamColor, field) - from;
  const Vector2d right = positionOfPost(color, false, player.teamColor, field) - from;
  if (left.norm() > world_.range && right.norm() > world_.range) return;
  GoalPercept goal;
  goal.color = color;
  goal.boundary.right = normalize(angleOf(right) - pose.rotation);
  goal.boundary.left = goal.boundary.right + normalize(angleOf(left) - angleOf(right));
  if (goal.boundary.left <= goal.boundary.right) return;  // From behind.

  Hidden& hidden = hidden_[static_cast<std::size_t>(color)];
  if (time > hidden.until && random_.chance(world_.hiddenPosts * dt)) {
    hidden = {time + static_cast<std::int64_t>(random_.uniform(500, 1500)), 0, 0};
    (random_.chance(0.5) ? hidden.left : hidden.right) = random_.uniform(0.1, 0.5);
  }
  if (time < hidden.until) {
    const double width = goal.boundary.left - goal.boundary.right;
    goal.boundary.left -= hidden.left * width;
    goal.boundary.right += hidden.right * width;
  }
  if (random_.chance(world_.outliers)) goal.boundary.left += random_.uniform(-0.3, 0.3);
  if (goal.boundary.left <= goal.boundary.right || !cutToImage(goal.boundary)) return;
  if (isHidden((goal.boundary.left + goal.boundary.right) / 2)) return;
  goal.angle = (goal.boundary.left + goal.boundary.right) / 2;
  percept.goals[static_cast<std::size_t>(percept.numberOfGoals++)] = goal;
}

void SyntheticRobot::seeEdges() {
  constexpr double step = openingAngle / 14;
  const double tiltError = world_.tiltNoise * seeing_.gaussian();
  for (double angle = headPan_ - openingAngle / 2 + step / 2; angle < headPan_ + openingAngle / 2;
       angle += step)
    if (!isHidden(angle)) seeEdges(angle, tiltError);
}

/// Finds the edges along one scan line of the image, up to the border or, in a goal's mouth, up to
/// the goal.
void SyntheticRobot::seeEdges(double angle, double tiltError) {
  constexpr double nearest = 220;  // mm; what is nearer lies below the image
  const double height = percept.cameraOffset.z();
  const Vector2d offset = percept.cameraOffset.head<2>();
  const Vector2d from = pose * offset, ray = direction(pose.rotation + angle);
  double wall = 1e9;
  for (const EdgeType type :
       {EdgeType::border, EdgeType::yellowGoal, EdgeType::skyblueGoal, EdgeType::line}) {
    crossings_.clear();
    edges_.crossings(type, from, ray, crossings_);
    for (const double distance : crossings_) {
      if (type != EdgeType::line) wall = std::min(wall, distance);
      const double range = type == EdgeType::line ? world_.lineRange : world_.edgeRange;
      if (distance < nearest || distance > range || distance > wall) continue;
      if (seeing_.chance(0.1 + 0.4 * distance / range)) continue;
      const double below =
          std::atan2(height, distance) + tiltError + world_.pointNoise * seeing_.gaussian();
      if (below < 0.02) continue;
      double beside = angle + commonError_ + world_.edgeNoise * seeing_.gaussian();
      EdgeType seen = type;
      if (seeing_.chance(world_.outliers)) {
        beside += seeing_.uniform(-0.3, 0.3);
        seen = static_cast<EdgeType>(seeing_.index(enumCount<EdgeType>));
      }
      lines.points[seen].push_back(offset + direction(beside) * (height / std::tan(below)));
    }
  }
}

}  // namespace gt
