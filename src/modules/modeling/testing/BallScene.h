#pragma once
#include <algorithm>

#include "debug/Debug.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallModel.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"

namespace gt {

/// Test scene: a ball and a robot on the field, and the robot's ball locator. Lengths in mm, times
/// in ms, images every 40 ms.
template <typename Locator>
struct BallScene {
  void step(const Pose2D& walk = {}, const Vector2d& noise = {0, 0}, bool seen = true) {
    frame.time = frame.time + 40;
    const double v = ballSpeed.norm();
    ball += ballSpeed * 0.04;
    if (v > 0) ballSpeed *= std::max(0., 1 - deceleration * 0.04 / v);
    odometry.pose = odometry.pose * walk;
    percept.time = frame.time;
    percept.seen = seen;
    percept.offset = relative(odometry.pose, ball) + noise;
    update();
  }
  void update() {
    if constexpr (requires { locator.update(percept, camera, odometry, frame, model, debug); })
      locator.update(percept, camera, odometry, frame, model, debug);
    else
      locator.update(percept, odometry, frame, model, debug);
  }
  /// True position (mm) and speed (mm/s) of the ball relative to the robot.
  Vector2d truth() const { return relative(odometry.pose, ball); }
  Vector2d trueSpeed() const { return rotated(ballSpeed, -odometry.pose.rotation); }
  double error() const { return (model.position - truth()).norm(); }
  double speedError() const { return (model.speed - trueSpeed()).norm(); }

  Locator locator;
  Vector2d ball{800, 100}, ballSpeed{0, 0};
  double deceleration = 0;
  CameraMatrix camera;
  OdometryData odometry;
  BallPercept percept;
  FrameInfo frame;
  BallModel model;
  Debug debug{1024};
};

}  // namespace gt
