#pragma once
#include "representations/infrastructure/Player.h"
#include "streams/Reflection.h"

namespace gt {

/// When there is a penalty shoot-out.
enum class ShootOutMode { none, afterDraw, only };

/// The game that the referee leads. Element `game`.
struct GameParameters {
  bool referee = true;
  double minutes = 10;
  TeamColor kickOff = TeamColor::red;
  double readyTime = 20;
  double setTime = 3;
  double stuckTime = 20;
  bool penalties = false;
  ShootOutMode shootOut = ShootOutMode::none;
  double leaveTime = 0;

  static constexpr auto fields() {
    return Fields{
        field<&GameParameters::referee>("false: all robots play, nobody counts"),
        field<&GameParameters::minutes>(Unit::min, "both halves together", {0.01, 1e4}),
        field<&GameParameters::kickOff>("the team that begins"),
        field<&GameParameters::readyTime>(Unit::s, "at most, for walking to the kick-off positions",
                                          {0, 600}),
        field<&GameParameters::setTime>(Unit::s, "standing before the whistle", {0, 600}),
        field<&GameParameters::stuckTime>(
            Unit::s, "after which a ball that does not move is put elsewhere", {1, 600}),
        field<&GameParameters::penalties>(
            "whether the referee penalizes robots, by the element rules"),
        field<&GameParameters::shootOut>(
            "a penalty shoot-out: none, after a draw, or as the whole game"),
        field<&GameParameters::leaveTime>(
            Unit::s, "that robots have to leave the field after the game, before all stands still",
            {0, 600})};
  }
};

}  // namespace gt
