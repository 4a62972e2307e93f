#pragma once
#include "modules/kinematics/BodyPosture.h"
#include "streams/Reflection.h"

namespace gt {

/// Corrects the body's tilt and roll that follow from the legs by the direction of gravity
/// (report 3.1). Two things are estimated for each axis from the angle between both:
///
/// - A constant: this robot's body leans more than its legs measure. Also the zero of its
///   acceleration sensors is off, so only the share of the mean angle counts by which the former
///   varies more than the latter: a Kalman filter of both, whose measurement is the mean.
/// - Swaying while the robot walks, by which the angle differs from its mean. Nearly all of that is
///   the acceleration of each step instead of gravity, so little of it counts.
class PostureFusion {
 public:
  struct Parameters {
    double lean = fromDegrees(0.35);
    double zero = 200;
    double disturbance = fromDegrees(10);
    double memory = 20000;
    double swayShare = 0.05;

    static constexpr auto fields() {
      return Fields{
          field("lean", &Parameters::lean, "rad",
                "standard deviation, from robot to robot, of how much the body leans more than its "
                "legs measure; 0: only the legs count",
                {0, 1}),
          field("zero", &Parameters::zero, "mm/s^2",
                "standard deviation, from robot to robot, of the acceleration sensors' zero",
                {1, 10000}),
          field("disturbance", &Parameters::disturbance, "rad",
                "standard deviation of the direction of acceleration during an image; three times "
                "as much is passed over",
                {0, 1}),
          field("memory", &Parameters::memory, "ms",
                "time constant of the mean angle between gravity and the legs' posture",
                {1000, 1e6}),
          field("swayShare", &Parameters::swayShare, "",
                "share of the angle's difference from its mean by which a walking body leans",
                {0, 1})};
    }
  };
  Parameters parameters;

  /// Takes what an image has: the posture by legs, the mean acceleration (mm/s^2, in the body's
  /// axes) and the time since the last one (ms). Acceleration 0 is passed over.
  void update(const BodyPosture& legs, const Vector3d& acceleration, double elapsed, bool walks);

  /// What to add to tilt and roll by legs (rad).
  double tilt() const { return correction_.x(); }
  double roll() const { return correction_.y(); }

 private:
  Vector2d mean_ = Vector2d::Zero();  ///< Of gravity's tilt and roll minus those by legs, rad.
  double variance_ = 0;               ///< Of the mean, rad^2, by the disturbance alone.
  int images_ = 0;
  Vector2d correction_ = Vector2d::Zero();
};

}  // namespace gt
