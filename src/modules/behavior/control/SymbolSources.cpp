#include "modules/behavior/control/SymbolSources.h"

namespace gt {

/// XABSL has words of its own (`initial`), so its elements have another ending than ours.
soccer::GameState SoccerInputs::gameState() const {
  switch (w_.game.state) {
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

double SoccerInputs::ballKickAngle() const {
  return toDegrees(normalize(gt::kickDirection(w_) - w_.self.pose.rotation));
}

double SoccerInputs::ballAngleAround(double facing) const {
  return toDegrees(
      normalize(angleOf(w_.knownBall()) + w_.self.pose.rotation - fromDegrees(facing)));
}

SpecialAction SoccerInputs::motionSpecialAction() const {
  if (w_.motion.executed.type != MotionType::specialAction) return {};
  const std::string& name = w_.motion.executed.specialAction;
  if (w_.specialAction(action_).name != name)
    action_ = SpecialAction{w_.motions ? std::max(0, w_.motions->find(name)) : 0};
  return action_;
}

bool SoccerInputs::kickReaches(SpecialAction id, double astray, double margin) const {
  const auto spread = w_.specialAction(id).kick.spreadAt(w_.ball.position, margin);
  return spread && *spread <= astray;
}

}  // namespace gt
