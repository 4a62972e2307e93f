#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The estimated position of another robot.
struct LocatedPlayer {
  Vector2d position = Vector2d::Zero();
  Time lastSeen = never();
  double validity = 0;
  int number = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{
        field<&LocatedPlayer::position>(Unit::mm, "position on the field"),
        field<&LocatedPlayer::lastSeen>(
            Unit::ms, "when the player was last seen by this robot, or sent its own pose"),
        field<&LocatedPlayer::validity>({0, 1}),
        field<&LocatedPlayer::number>(
            "number of a teammate that sent its pose, 1 to 4; 0 if unknown"),
        field<&LocatedPlayer::standardDeviation>(
            Unit::mm, "standard deviation of the position, the mean of both axes; 0 if unknown")};
  }
};

/// All other players (report 3.7), the most distinct first. Provided by the PlayersLocator.
struct PlayersCollection {
  Time time;
  std::vector<LocatedPlayer> ownTeam, opponents, seenOpponents;

  static constexpr auto fields() {
    return Fields{field<&PlayersCollection::time>(Unit::ms),
                  field<&PlayersCollection::ownTeam>("teammates, without the robot itself"),
                  field<&PlayersCollection::opponents>(),
                  field<&PlayersCollection::seenOpponents>(
                      "opponents that the robot itself has seen, to be sent to its teammates")};
  }
};

}  // namespace gt
