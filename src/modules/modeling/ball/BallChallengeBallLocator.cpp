#include "modules/modeling/ball/BallChallengeBallLocator.h"

#include <algorithm>

#include "modules/modeling/ball/BallDrawing.h"

namespace gt {

void BallChallengeBallLocator::Average::add(const Vector2d& value) {
  std::rotate(values_.begin(), values_.end() - 1, values_.end());
  values_[0] = value;
  count_ = std::min(count_ + 1, mostPercepts);
}

Vector2d BallChallengeBallLocator::Average::mean(int most) const {
  const int n = std::min(most, count_);
  if (n < 1) return Vector2d::Zero();
  Vector2d sum = Vector2d::Zero();
  for (int i = 0; i < n; ++i) sum += values_[static_cast<std::size_t>(i)];
  return sum / n;
}

void BallChallengeBallLocator::Average::move(const Pose2D& step) {
  for (int i = 0; i < count_; ++i) {
    Vector2d& value = values_[static_cast<std::size_t>(i)];
    value = relative(step, value);
  }
}

void BallChallengeBallLocator::Average::rotate(double angle) {
  for (int i = 0; i < count_; ++i) {
    Vector2d& value = values_[static_cast<std::size_t>(i)];
    value = rotated(value, angle);
  }
}

void BallChallengeBallLocator::update(const BallPercept& percept, const OdometryData& odometry,
                                      const FrameInfo& frame, BallModel& model, Debug& debug) {
  const Pose2D step = first_ ? Pose2D{} : odometry.pose.relativeTo(lastOdometry_.pose);
  first_ = false;
  lastOdometry_ = odometry;
  ball_.move(step);
  positions_.move(step);
  speeds_.rotate(-step.rotation);
  const bool gap = frame.time - ball_.lastSeen > parameters.longestGap;
  if (gap) {  // It may have moved, so nothing is averaged with what was.
    positions_.clear();
    speeds_.clear();
    ball_.speed = Vector2d::Zero();
  }
  if (percept.seen && percept.time > ball_.lastSeen) {
    if (positions_.count() > 0) {
      const double seconds = static_cast<double>(percept.time - ball_.lastSeen) / 1000;
      speeds_.add((percept.offset - positions_.newest()) / seconds);
    } else {
      ball_.seenSince = percept.time;
    }
    positions_.add(percept.offset);
    ball_.position = positions_.mean(parameters.positions);
    ball_.speed = speeds_.mean(parameters.speeds);
    ball_.lastSeen = percept.time;
  }
  model = ball_.model(frame.time, parameters.longestGap);
  draw(model, debug);
}

}  // namespace gt
