#pragma once
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The roles that the team negotiates (report 3.8.2).
enum class DynamicRole { goalie, striker, offensiveSupporter, defensiveSupporter };

/// What one robot decided to send its teammates. Provided by BehaviorControl.
struct BehaviorTeamMessage {
  DynamicRole role = DynamicRole::defensiveSupporter;
  double estimatedTimeToReachBall = 1e6;
  int striker = 0;
  int handOver = 0;
  Vector2d kickTarget = Vector2d::Zero();

  static constexpr auto fields() {
    return Fields{
        field<&BehaviorTeamMessage::role>(),
        field<&BehaviorTeamMessage::estimatedTimeToReachBall>(Unit::ms),
        field<&BehaviorTeamMessage::striker>(
            "number of the player that the sender takes for the striker, 0 nobody", {0, 4}),
        field<&BehaviorTeamMessage::handOver>(
            "number of the decision that made it striker; the highest one counts", {0, 1000000}),
        field<&BehaviorTeamMessage::kickTarget>(
            Unit::mm,
            "where the kick that it performs or plans brings the ball if nothing is in its way, on "
            "the field")};
  }
};

/// An opponent as the sender of a message has seen it itself.
struct SeenOpponent {
  Vector2d position = Vector2d::Zero();
  Time lastSeen = never();
  double validity = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{field<&SeenOpponent::position>(Unit::mm, "on the field"),
                  field<&SeenOpponent::lastSeen>(Unit::ms, "by the sender's clock"),
                  field<&SeenOpponent::validity>("0: there is none", {0, 1}),
                  field<&SeenOpponent::standardDeviation>(Unit::mm, "of the position")};
  }
};

/// What a robot sends to its teammates by radio. Provided by the TeamMessageSender.
struct TeamMessage {
  int playerNumber = 0;
  Time timeSent = never();
  Pose2D robotPose;
  double robotPoseValidity = 0;
  Vector2d ballPosition = Vector2d::Zero();
  Vector2d ballSpeed = Vector2d::Zero();
  double ballStandardDeviation = 0;
  Time ballLastSeen = never();
  BehaviorTeamMessage behavior;
  std::array<SeenOpponent, 4> opponents;

  static constexpr auto fields() {
    return Fields{field<&TeamMessage::playerNumber>("1 to 4; 0 nobody", {0, 4}),
                  field<&TeamMessage::timeSent>(Unit::ms, "by the sender's clock"),
                  field<&TeamMessage::robotPose>(Unit::mmRad),
                  field<&TeamMessage::robotPoseValidity>({0, 1}),
                  field<&TeamMessage::ballPosition>(Unit::mm, "on the field"),
                  field<&TeamMessage::ballSpeed>(Unit::mmPerS, "on the field"),
                  field<&TeamMessage::ballStandardDeviation>(Unit::mm, "BallModel"),
                  field<&TeamMessage::ballLastSeen>(Unit::ms, "by the sender's clock"),
                  field<&TeamMessage::behavior>(),
                  field<&TeamMessage::opponents>()};
  }
};

/// The newest message of each teammate, with the time when it came in. Provided by the platform.
struct TeamMessages {
  struct Received {
    TeamMessage message;
    Time timeReceived = never();

    static constexpr auto fields() {
      return Fields{field<&Received::message>(),
                    field<&Received::timeReceived>(Unit::ms, "by the own clock")};
    }
  };
  std::array<Received, 4> byPlayer;

  static constexpr auto fields() {
    return Fields{field<&TeamMessages::byPlayer>("index is the player's number - 1")};
  }
};

}  // namespace gt
