#pragma once
#include <span>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// The precision with which a robot can know its pose on the field from the landmarks that it has
/// looked at: the covariance of an extended Kalman filter whose mean is assumed to be right. It
/// predicts the gain of information from looking at landmarks before they are seen.
class PoseUncertainty {
 public:
  struct Parameters {
    double walking = 100;
    double turning = 0.15;
    double bearing = 0.04;
    double distance = 0.12;
    double neededPosition = 60;
    double neededRotation = 0.05;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::walking>(
              Unit::mm, "growth of the standard deviation of the position in a second", {1, 1000}),
          field<&P::turning>(
              Unit::rad, "growth of the standard deviation of the rotation in a second", {0.01, 3}),
          field<&P::bearing>(Unit::rad,
                             "standard deviation of the direction of a landmark that is seen",
                             {0.001, 1}),
          field<&P::distance>(
              "standard deviation of the distance of a landmark, as a share of the distance",
              {0.01, 1}),
          field<&P::neededPosition>(
              Unit::mm,
              "standard deviation of the position below which more precision is hardly of use",
              {1, 1000}),
          field<&P::neededRotation>(
              Unit::rad,
              "standard deviation of the rotation below which more precision is hardly of use",
              {0.001, 1})};
    }
  };

  /// Increases the covariance for a time (s) in which the robot moves.
  void pass(double seconds, const Parameters& parameters);
  /// Reduces the covariance: the robot looks at a landmark (mm, on the field).
  void see(const Pose2D& robot, const Vector2d& landmark, const Parameters& parameters);
  /// The information that looking at landmarks would add (nats): half the logarithm of the ratio of
  /// the covariances' determinants, before and after, each increased by the needed precision.
  double gain(const Pose2D& robot, std::span<const Vector2d> landmarks,
              const Parameters& parameters) const;
  /// Standard deviation of the position (mm), the larger one of both axes.
  double position() const;

 private:
  static constexpr double lostPosition = 1000, lostRotation = 1;  // mm, rad: nothing is known

  Eigen::Matrix3d covariance_ =
      Eigen::Vector3d{lostPosition * lostPosition, lostPosition* lostPosition,
                      lostRotation* lostRotation}
          .asDiagonal();
};

}  // namespace gt
