#pragma once
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The roles that the team negotiates (report 3.8.2).
enum class DynamicRole { goalie, striker, offensiveSupporter, defensiveSupporter };

/// The part of a robot's message to its teammates that the behavior decides. Provided by
/// BehaviorControl.
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
            "number of the player whom the sender considers the striker; 0: none", {0, 4}),
        field<&BehaviorTeamMessage::handOver>(
            "number of the decision that made this player the striker; the highest number is valid",
            {0, 1000000}),
        field<&BehaviorTeamMessage::kickTarget>(
            Unit::mm,
            "expected end position of the ball after the sender's present or planned kick, if "
            "nothing blocks the ball, on the field")};
  }
};

/// An opponent as seen by the sender of a message itself.
struct SeenOpponent {
  Vector2d position = Vector2d::Zero();
  Time lastSeen = never();
  double validity = 0;
  double standardDeviation = 0;

  static constexpr auto fields() {
    return Fields{
        field<&SeenOpponent::position>(Unit::mm, "position of the opponent on the field"),
        field<&SeenOpponent::lastSeen>(Unit::ms,
                                       "when the opponent was last seen, by the sender's clock"),
        field<&SeenOpponent::validity>("validity of the entry; 0: no opponent", {0, 1}),
        field<&SeenOpponent::standardDeviation>(Unit::mm, "standard deviation of the position")};
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
    return Fields{
        field<&TeamMessage::playerNumber>("number of the sender, 1 to 4; 0: none", {0, 4}),
        field<&TeamMessage::timeSent>(Unit::ms, "time of sending, by the sender's clock"),
        field<&TeamMessage::robotPose>(Unit::mmRad),
        field<&TeamMessage::robotPoseValidity>({0, 1}),
        field<&TeamMessage::ballPosition>(
            Unit::mm, "position of the ball on the field, as seen by the sender"),
        field<&TeamMessage::ballSpeed>(Unit::mmPerS,
                                       "velocity of the ball on the field, as seen by the sender"),
        field<&TeamMessage::ballStandardDeviation>(
            Unit::mm, "standard deviation of the ball's position, from BallModel"),
        field<&TeamMessage::ballLastSeen>(
            Unit::ms, "when the sender last saw the ball, by the sender's clock"),
        field<&TeamMessage::behavior>(),
        field<&TeamMessage::opponents>()};
  }
};

/// The newest message of each teammate, with the time of its arrival. Provided by the platform.
struct TeamMessages {
  struct Received {
    TeamMessage message;
    Time timeReceived = never();

    static constexpr auto fields() {
      return Fields{
          field<&Received::message>(),
          field<&Received::timeReceived>(Unit::ms, "time of arrival, by the receiver's clock")};
    }
  };
  std::array<Received, 4> byPlayer;

  static constexpr auto fields() {
    return Fields{field<&TeamMessages::byPlayer>(
        "newest message of each player; the index is the player's number - 1")};
  }
};

}  // namespace gt
