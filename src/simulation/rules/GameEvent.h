#pragma once
#include <string>

#include "base/Geometry.h"
#include "base/Time.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"
#include "streams/Reflection.h"

namespace gt {

enum class GameEventType {
  kickOff,
  goal,
  halfTime,
  stuckBall,
  ballOut,
  placedRobot,
  penalty,
  returnedRobot,
  shotGoal,
  shotMissed,
  gameOver
};

/// Something that the referee saw or did. Provided by the Referee.
struct GameEvent {
  GameEventType type = GameEventType::kickOff;
  Time time;
  TeamColor team = TeamColor::red;
  int number = 0;
  bool ownGoal = false;
  Penalty penalty = Penalty::none;
  Vector2d ballPosition = Vector2d::Zero();
  int scoreRed = 0;
  int scoreBlue = 0;

  static constexpr auto fields() {
    return Fields{
        field<&GameEvent::type>(),
        field<&GameEvent::time>(Unit::ms),
        field<&GameEvent::team>(
            "team that kicks off, scores or shoots, or whose robot was put by hand"),
        field<&GameEvent::number>(
            "number of the player concerned, 0 for none; for a goal: of the player that touched "
            "the ball last, who is of the other team if it is an own goal"),
        field<&GameEvent::ownGoal>(),
        field<&GameEvent::penalty>("penalty of a robot that is taken off the field"),
        field<&GameEvent::ballPosition>(Unit::mm, "position of the ball on the field"),
        field<&GameEvent::scoreRed>(
            "goals of the red team; in a shoot-out and at an end by it: of the shoot-out"),
        field<&GameEvent::scoreBlue>()};
  }
};

/// Describes an event in one line.
std::string describe(const GameEvent& event);

/// Minutes and seconds, as in 2:05.
std::string clockText(Time time);

}  // namespace gt
