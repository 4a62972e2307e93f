#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// Where another robot is on the field.
struct LocatedPlayer {
  Vector2d position = Vector2d::Zero();
  Time lastSeen = never();
  double validity = 0;
  int number = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{
        field<&LocatedPlayer::position>(Unit::mm, "on the field"),
        field<&LocatedPlayer::lastSeen>(Unit::ms, "by this robot, or when it sent where it is"),
        field<&LocatedPlayer::validity>({0, 1}),
        field<&LocatedPlayer::number>("1 to 4 of a teammate that sent its pose; 0 if not known"),
        field<&LocatedPlayer::standardDeviation>(
            Unit::mm, "of the position, the mean of both axes; 0 if not known")};
  }
};

/// All other players recognized (report 3.7), the most distinct first. Provided by the
/// PlayersLocator.
struct PlayersCollection {
  Time time;
  std::vector<LocatedPlayer> ownTeam, opponents, seenOpponents;

  static constexpr auto fields() {
    return Fields{field<&PlayersCollection::time>(Unit::ms),
                  field<&PlayersCollection::ownTeam>("without the robot itself"),
                  field<&PlayersCollection::opponents>(),
                  field<&PlayersCollection::seenOpponents>(
                      "what the robot itself has seen of them, to be sent to its teammates")};
  }
};

}  // namespace gt
