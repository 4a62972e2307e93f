#include "modules/behavior/control/SymbolSources.h"

#include <algorithm>

#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {

/// The names of the elements in XABSL differ from ours, because some of ours are keywords of XABSL
/// (`initial`).
soccer::GameState SoccerInputs::gameState() const {
  switch (tactics_.game().state()) {
    case GameState::initial:
      return soccer::GameState::initialState;
    case GameState::ready:
      return soccer::GameState::readyState;
    case GameState::set:
      return soccer::GameState::setState;
    case GameState::playing:
      return soccer::GameState::playingState;
    case GameState::penalized:
      return soccer::GameState::penalizedState;
    case GameState::finished:
      return soccer::GameState::finishedState;
  }
  return {};
}

double SoccerInputs::ballAngleAround(double facing) const {
  return toDegrees(
      normalize(angleOf(tactics_.knownBall()) + w().self.pose.rotation - fromDegrees(facing)));
}

SpecialAction SoccerInputs::motionSpecialAction() const {
  const MotionRequest& executed = w().motion.executed;
  if (executed.type != MotionType::specialAction) return {};
  if (motion(action_).name != executed.specialAction)
    action_ = SpecialAction{std::max(0, w().motions.find(executed.specialAction))};
  return action_;
}

double SoccerInputs::ballGoalDirection() const {
  const Vector2d goal{w().field.xGroundline, 0};
  return toDegrees(angleOf(goal - tactics_.knownBallOnField()));
}

double SoccerInputs::ballGoalAngle() const {
  return toDegrees(normalize(fromDegrees(ballGoalDirection()) - w().self.pose.rotation));
}

double SoccerInputs::ballOwnGoalBisector(double x, double most) const {
  const Vector2d ball = tactics_.knownBallOnField();
  const auto toPost = [&](double y) {
    return Vector2d{Vector2d{-w().field.xGroundline, y} - ball}.normalized();
  };
  const Vector2d bisector = toPost(w().field.yGoal) + toPost(-w().field.yGoal);
  // A ball that is not ahead of the line is beside it.
  const bool beside = ball.x() <= x || bisector.x() >= 0;
  const double y = beside ? ball.y() : ball.y() + bisector.y() / bisector.x() * (x - ball.x());
  return std::clamp(y, -most, most);
}

Vector2d SoccerInputs::place() const {
  if (w().values.empty()) return Vector2d::Zero();
  const Vector2d corner{w().field.xGroundline, w().field.ySideline};
  return tactics_.role() == DynamicRole::offensiveSupporter
             ? w().values.placeAhead(tactics_.knownBallOnField(), corner)
             : w().values.placeBehind(tactics_.knownBallOnField(), corner);
}

Vector2d SoccerInputs::nearest(const std::vector<LocatedPlayer>& players) const {
  Vector2d nearest{1e5, 0};
  for (const LocatedPlayer& player : players) {
    const Vector2d there = relative(w().self.pose, player.position);
    if (there.norm() < nearest.norm()) nearest = there;
  }
  return nearest;
}

double SoccerInputs::opponentsWithin(double distance) const {
  return static_cast<double>(
      std::ranges::count_if(w().players.opponents, [&](const LocatedPlayer& player) {
        return (player.position - w().self.pose.translation).norm() < distance;
      }));
}

double SoccerInputs::obstaclesFreeAhead(double angle, double width) const {
  return corridor(tactics_.obstacles(), fromDegrees(angle), width);
}

double SoccerInputs::obstaclesFreeDirection(double angle, double width, double length) const {
  const auto free = freeDirection(tactics_.obstacles(), fromDegrees(angle), width, length);
  return toDegrees(free.value_or(pi));
}

double SoccerInputs::obstaclesGap(double angle, double range) const {
  return nearestObstacle(tactics_.obstacles(), fromDegrees(angle), fromDegrees(range));
}

/// The tour is planned from the robot's position at the first request of its first place (report
/// 4.2.1).
const Pose2D& SoccerInputs::target(double index) const {
  return tour_.at(static_cast<std::size_t>(std::max(0., index)), w());
}

}  // namespace gt
