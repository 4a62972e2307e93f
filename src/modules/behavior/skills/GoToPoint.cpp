#include "modules/behavior/skills/GoToPoint.h"

#include <algorithm>
#include <cmath>

namespace gt {

void GoToPoint::execute() {
  const Pose2D& pose = movement_.tactics().world().self.pose;
  const Vector2d offset = relative(pose, {x, y});
  const double distance = offset.norm();
  const double finalTurn = normalize(fromDegrees(angle) - pose.rotation);
  arrived_ = distance < (arrived_ ? 60 : 25) && std::abs(finalTurn) < fromDegrees(arrived_ ? 8 : 4);
  if (arrived_) return movement_.stand();
  const bool isFar = distance > 400;
  const double turn = isFar ? angleOf(offset) : finalTurn;
  // Without a speed, as from a person who does not care (report I.5.3: xbb), as fast as it can.
  const double limit = maxSpeed > 0 ? maxSpeed : movement_.parameters().maxForward;
  // Far away the robot walks in the direction that it faces, so it turns first.
  const double speed =
      isFar ? limit * std::max(0.2, std::cos(std::min(std::abs(turn), pi / 2))) : limit;
  if (isFar) return movement_.approachAvoiding(offset, turn, speed);
  movement_.approach(offset, turn, speed);
}

}  // namespace gt
