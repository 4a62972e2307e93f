#include "simulation/sensors/CeilingCamera.h"

namespace gt {
namespace {

/// The part of a robot that hides a ball below it, seen from above.
constexpr double bodyLength = 150, bodyWidth = 70;  // mm, from the middle

bool isUnderRobot(const Vector2d& ball, const Pose2D& robot) {
  const Vector2d p = relative(robot, ball);
  return std::abs(p.x()) < bodyLength && std::abs(p.y()) < bodyWidth;
}

}  // namespace

CeilingCamera::CeilingCamera(const CeilingCameraParameters& parameters,
                             const std::vector<Player>& players, const Random& random)
    : parameters_{parameters}, players_{players}, random_{random} {
  for (int k = 0; k < 2; ++k) {
    scale_[k] = 1 + parameters_.scaleError * random_.symmetric();
    offset_[k] = parameters_.offsetError * random_.symmetric();
  }
}

bool CeilingCamera::look(const World& world, CeilingCameraPercept& percept) {
  if (world.time() < next_) return false;
  next_ = world.time() + parameters_.period;
  percept.time = world.time();
  percept.robots.clear();
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    const Pose2D& pose = world.robot(i).pose;
    if (!sees(pose.translation)) continue;
    const Vector2d place = measured(pose.translation);
    const double angle = pose.rotation + parameters_.rotationNoise * random_.gaussian();
    percept.robots.push_back(
        {players_[i].teamColor, players_[i].number(), {normalize(angle), place}});
  }
  percept.ballSeen = world.ballCount() > 0 && sees(world.ball(0).position);
  for (std::size_t i = 0; i < world.robotCount() && percept.ballSeen; ++i)
    percept.ballSeen = !isUnderRobot(world.ball(0).position, world.robot(i).pose);
  if (percept.ballSeen) percept.ball = measured(world.ball(0).position);
  return true;
}

bool CeilingCamera::sees(const Vector2d& place) {
  return !random_.chance(parameters_.overlooked) && place.x() >= parameters_.lowX &&
         place.x() <= parameters_.highX;
}

Vector2d CeilingCamera::measured(const Vector2d& place) {
  const double x = parameters_.positionNoise * random_.gaussian();
  const double y = parameters_.positionNoise * random_.gaussian();
  return place.cwiseProduct(scale_) + offset_ + Vector2d{x, y};
}

}  // namespace gt
