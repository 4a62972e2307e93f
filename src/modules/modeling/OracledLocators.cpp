#include "modules/modeling/OracledLocators.h"

namespace gt {

void OracledSelfLocator::update(const OracledWorldState& oracle, RobotPose& pose) {
  pose.pose = oracle.robotPose;
  pose.validity = 1;
}

void OracledBallLocator::update(const OracledWorldState& oracle, const FrameInfo& frame,
                                BallModel& ball) {
  if (first_ == never()) first_ = frame.time;
  ball.position = relative(oracle.robotPose, oracle.ballPosition);
  ball.speed = rotated(oracle.ballSpeed, -oracle.robotPose.rotation);
  ball.lastSeen = frame.time;
  ball.consecutiveTimeSeen = frame.time - first_;
}

}  // namespace gt
