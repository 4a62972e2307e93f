#include "modules/modeling/team/DefaultTeamBallLocator.h"

#include "modules/modeling/ball/BallDrawing.h"

namespace gt {

void DefaultTeamBallLocator::update(const BallModel& ball, const RobotPose& robotPose,
                                    const TeamMessages& messages, const FrameInfo& frame,
                                    const Player& player, TeamBallModel& teamBall, Debug& debug) {
  // One's own ball moves with oneself and suffers from no localization error: while it is fresh,
  // nobody else's counts; and an old one is better than none.
  teamBall = {};
  if (ball.lastSeen != never())
    teamBall = {robotPose.pose * ball.position, ball.lastSeen, player.number(),
                ball.standardDeviation};
  const auto ownAge = frame.time - ball.lastSeen;
  if (ownAge > parameters.ownBallTime) {
    double best = badness(static_cast<double>(ownAge), robotPose.validity);
    for (const TeamMessages::Received& received : messages.byPlayer) {
      const TeamMessage& message = received.message;
      if (message.playerNumber == 0 || message.playerNumber == player.number()) continue;
      const auto silence = frame.time - received.timeReceived;
      // Ages are differences within one clock each: the robots' clocks do not agree.
      const auto age = silence + (message.timeSent - message.ballLastSeen);
      if (silence > parameters.silence || age > parameters.oldestBall) continue;
      const double bad = badness(static_cast<double>(age), message.robotPoseValidity);
      if (bad >= best) continue;
      best = bad;
      teamBall = {message.ballPosition, frame.time - age, message.playerNumber,
                  message.ballStandardDeviation};
    }
  }
  if (teamBall.seenBy == 0) return;
  draw(teamBall, debug);
}

}  // namespace gt
