#include "modules/behavior/tactics/ButtonControl.h"

#include <cmath>

namespace gt {

void ButtonControl::update(const WorldState& world) {
  managed_ |= world.game.state != GameState::initial;
  if (managed_) {
    state_ = world.game.state;
    ownKickOff_ = world.game.kickOff == KickOff::own;
    return;
  }
  pressBack(static_cast<double>(world.body.pressedFor[Switch::back]));
  const double tail = toDegrees(world.body.tailPan);
  if (state_ == GameState::ready && std::abs(tail) > p_.tailPush) ownKickOff_ = tail > 0;
}

void ButtonControl::pressBack(double pressedFor) {
  if (pressedFor > p_.longPress) {
    if (state_ == GameState::playing) state_ = GameState::ready;
  } else if (pressedFor == 0 && backPressedFor_ > 0 && backPressedFor_ <= p_.longPress) {
    state_ = state_ == GameState::initial ? GameState::ready : GameState::playing;
  }
  backPressedFor_ = pressedFor;
}

}  // namespace gt
