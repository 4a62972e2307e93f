#pragma once
#include "debug/Debug.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Test scene: a team whose robots send each other the ball's position, and the team ball locator
/// of one of them.
template <typename Locator>
struct TeamScene {
  TeamScene() {
    frame.time = {100000};
    player.role = PlayerRole::striker1;
    robotPose = {{pi / 2, 500, 0}, 0.95};
  }
  /// A message of player `n` arrives now: it saw the ball at `where` (mm, on the field) `age` ms
  /// before it sent the message.
  TeamMessages::Received& receive(int n, const Vector2d& where, std::int64_t age = 0,
                                  double validity = 0.95, const Vector2d& robot = {0, 0}) {
    TeamMessages::Received& received = messages.byPlayer[static_cast<std::size_t>(n - 1)];
    received.timeReceived = frame.time;
    TeamMessage& m = received.message;
    m.playerNumber = n;
    m.timeSent = {777777 * n};  // Each robot's clock is its own.
    m.ballLastSeen = m.timeSent - age;
    m.ballPosition = where;
    m.robotPose.translation = robot;
    m.robotPoseValidity = validity;
    return received;
  }
  void seeBall(const Vector2d& onField, std::int64_t ago = 0) {
    ball.position = relative(robotPose.pose, onField);
    ball.lastSeen = frame.time - ago;
  }
  TeamBallModel locate() {
    TeamBallModel result;
    locator.update(ball, robotPose, messages, frame, player, result, debug);
    return result;
  }

  Locator locator;
  BallModel ball;
  RobotPose robotPose;
  TeamMessages messages;
  FrameInfo frame;
  Player player;
  Debug debug{1024};
};

}  // namespace gt
