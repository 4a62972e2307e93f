#include "modules/modeling/ball/PIDSmoothedBallLocator.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/ball/BallDrawing.h"

namespace gt {

void PIDSmoothedBallLocator::update(const BallPercept& percept, const OdometryData& odometry,
                                    const FrameInfo& frame, BallModel& model, Debug& debug) {
  const bool first = lastUpdate_ == never();
  const Pose2D step = first ? Pose2D{} : odometry.pose.relativeTo(lastOdometry_.pose);
  const double seconds = first ? 0 : static_cast<double>(frame.time - lastUpdate_) / 1000;
  lastOdometry_ = odometry;
  lastUpdate_ = frame.time;

  const bool seen = percept.seen && percept.time != lastPercept_;
  predict(step, seconds, seen);
  if (seen) {
    const bool forgotten = frame.time - ball_.lastSeen > parameters.forgetPosition;
    if (forgotten && percept.offset.norm() < parameters.believedAtOnce) {
      restart(percept.offset);
    } else if (forgotten || isFar(percept.offset, ball_.position)) {
      doubt(percept);
    } else {
      follow(percept.offset, static_cast<double>(percept.time - lastPercept_) / 1000);
    }
    if (outliers_ == 0) {
      lastPercept_ = percept.time;
      if (percept.time - ball_.lastSeen > parameters.longestGap) ball_.seenSince = percept.time;
      ball_.lastSeen = percept.time;
    }
  }
  model = ball_.model(frame.time, parameters.longestGap);
  draw(model, debug);
}

void PIDSmoothedBallLocator::predict(const Pose2D& step, double seconds, bool seen) {
  ball_.move(step);
  doubted_ = relative(step, doubted_);
  ball_.roll(seconds);
  ball_.speed *= std::exp(-(seen ? parameters.slowDown : parameters.slowDownUnseen) * seconds);
}

bool PIDSmoothedBallLocator::isFar(const Vector2d& offset, const Vector2d& expected) const {
  const double allowed = parameters.outlierDistance + parameters.outlierShare * expected.norm();
  return (offset - expected).norm() > allowed;
}

void PIDSmoothedBallLocator::doubt(const BallPercept& percept) {
  // Wrong percepts lie here and there; a ball that was moved is seen again where it is now.
  const bool agrees =
      percept.time - lastDoubted_ <= parameters.longestGap && !isFar(percept.offset, doubted_);
  outliers_ = outliers_ > 0 && agrees ? outliers_ + 1 : 1;
  doubted_ = percept.offset;
  lastDoubted_ = percept.time;
  if (outliers_ >= parameters.outliersBelieved) restart(percept.offset);
}

void PIDSmoothedBallLocator::follow(const Vector2d& offset, double seconds) {
  outliers_ = 0;
  // A small error of the camera's tilt is a large one of the distance, the more the farther the
  // ball lies; its direction is always measured well.
  const double distance = std::max(offset.norm(), 1.0);
  const double far = distance / parameters.trustedDistance;
  const double trust = 1 / (1 + far * far);
  const Vector2d away = offset / distance, difference = offset - ball_.position;
  const Vector2d along = away * away.dot(difference), across = difference - along;
  ball_.position += parameters.proportional * (across + trust * along);
  if (seconds <= 0) return;
  ball_.speed += parameters.integral / seconds * (across + trust * trust * along);
  const double length = ball_.speed.norm();
  if (length > parameters.fastestBall) ball_.speed *= parameters.fastestBall / length;
}

void PIDSmoothedBallLocator::restart(const Vector2d& offset) {
  outliers_ = 0;
  ball_.position = offset;
  ball_.speed = Vector2d::Zero();
}

}  // namespace gt
