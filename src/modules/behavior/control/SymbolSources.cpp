#include "modules/behavior/control/SymbolSources.h"

#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {

/// XABSL has words of its own (`initial`), so its elements have another ending than ours.
soccer::GameState SoccerInputs::gameState() const {
  switch (w().game.state) {
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

/// The tour is planned from where the robot is when it first asks for its beginning (report 4.2.1).
const Pose2D& SoccerInputs::target(double index) const {
  return tour_.at(static_cast<std::size_t>(std::max(0., index)), w());
}

bool SoccerInputs::kickReaches(SpecialAction id, double astray, double margin) const {
  const auto spread = motion(id).kick.spreadAt(w().ball.position, margin);
  return spread && *spread <= astray;
}

}  // namespace gt
