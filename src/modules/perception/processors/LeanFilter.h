#pragma once
#include <cmath>
#include <span>

#include "modules/kinematics/BodyPosture.h"
#include "modules/perception/specialists/RobustEstimate.h"
#include "modules/perception/specialists/SeenHeights.h"
#include "streams/Reflection.h"

namespace gt {

/// Learns in play by how much the camera's inclination differs from the joint measurements, from
/// the elevation at which objects are seen. A Kalman filter estimates the constant errors of this
/// robot (inclination and height of body and neck, roll of the head), by how much the legs give
/// way, as a share of a model's prediction (PostureModel), and the swaying of the body, which lasts
/// for a part of a step.
class LeanFilter {
 public:
  struct Parameters {
    bool learns = true;
    double lean = fromDegrees(0.6);
    double headRoll = fromDegrees(0.4);
    double height = 3;
    double giving = 0.3;
    double drift = fromDegrees(0.02);
    double swayWalking = fromDegrees(0.8);
    double swayStanding = fromDegrees(0.3);
    double swayHeight = 1.2;
    double swayTime = 100;

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::learns>("whether the filter learns while the robot plays"),
          field<&Parameters::lean>(
              Unit::rad,
              "standard deviation, from robot to robot, of the body's tilt and roll relative to "
              "the joint measurements",
              {0, 1}),
          field<&Parameters::headRoll>(
              Unit::rad, "standard deviation, from robot to robot, of the head's roll", {0, 1}),
          field<&Parameters::height>(
              Unit::mm, "standard deviation, from robot to robot, of the body's height", {0, 100}),
          field<&Parameters::giving>(
              "standard deviation of how much the legs give way, as a share of the model", {0, 10}),
          field<&Parameters::drift>(
              Unit::rad, "standard deviation of the change of constant tilt and roll in a second",
              {0, 1}),
          field<&Parameters::swayWalking>(
              Unit::rad,
              "standard deviation of a walking body's tilt and roll, until more is known", {0, 1}),
          field<&Parameters::swayStanding>(
              Unit::rad,
              "standard deviation of a standing body's tilt and roll, until more is known", {0, 1}),
          field<&Parameters::swayHeight>(Unit::mm, "standard deviation of a walking body's height",
                                         {0, 100}),
          field<&Parameters::swayTime>(Unit::ms, "time for which swaying lasts", {1, 10000})};
    }
  };
  Parameters parameters;

  /// Predicts the state for the next image, `elapsed` (ms) after the last one.
  void predict(double elapsed, bool walks);
  /// Learns from the elevations of objects seen with the last camera matrix. The camera had the
  /// azimuth `cameraAzimuth` (rad, relative to the robot), and `giving` was the correction of the
  /// PostureModel.
  void learn(std::span<const SeenHeight> heights, double cameraAzimuth, const BodyPosture& giving);

  /// The correction of the body's posture, including its current swaying, if the PostureModel
  /// predicts `giving`.
  BodyPosture posture(const BodyPosture& giving) const;
  /// The correction of the head's roll (rad).
  double headRoll() const { return state_.value[ofHead]; }
  /// By how much the legs give way, as a share of the model.
  double legsGive() const { return 1 + state_.value[share]; }
  /// The covariance of the camera matrix (CameraMatrix.h).
  Matrix3d covariance(double cameraAzimuth, const BodyPosture& giving) const;
  /// The constant part of the correction of the body's posture.
  BodyPosture built() const;
  /// The standard deviations of the constant part.
  BodyPosture deviation() const;
  double headRollDeviation() const { return std::sqrt(state_.covariance(ofHead, ofHead)); }

 private:
  /// Rotations about the robot's x and y axis and about the camera's optical axis (rad); height
  /// (mm); share of the model minus 1; rotations by swaying (rad).
  enum { leanX, leanY, ofHead, height, share, swayX, swayY, size };
  using State = RobustEstimate<size>;
  using Shares = Eigen::Matrix<double, 3, size>;
  /// The derivative of the camera matrix's rotations (rad) and height (mm) with respect to the
  /// state.
  static Shares shares(double cameraAzimuth, const BodyPosture& giving);

  /// Adapts the variance of swaying until the innovations have the size that it predicts.
  void adaptSwaying(double surprise);

  State state_;
  double walkingVariance_ = 0;  ///< Variance of the swaying while the robot walks, rad^2.
  bool begun_ = false, walks_ = false;
};

}  // namespace gt
