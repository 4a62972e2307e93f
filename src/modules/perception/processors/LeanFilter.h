#pragma once
#include <cmath>
#include <span>

#include "modules/kinematics/BodyPosture.h"
#include "modules/perception/specialists/RobustEstimate.h"
#include "modules/perception/specialists/SeenHeights.h"
#include "streams/Reflection.h"

namespace gt {

/// Learns in play by how much a camera leans otherwise than the joints measure, from how high
/// things are seen. A Kalman filter of what stays as the robot was built (the body's lean and
/// height, with the neck's, and the head's roll), of how much the legs give, as a share of what a
/// model says (PostureModel), and of swaying, which lasts for a part of a step.
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
          field<&Parameters::learns>("while the robot plays"),
          field<&Parameters::lean>(
              Unit::rad,
              "standard deviation, from robot to robot, of tilt and roll of the body beside what "
              "its legs measure",
              {0, 1}),
          field<&Parameters::headRoll>(Unit::rad, "of the head's roll", {0, 1}),
          field<&Parameters::height>(Unit::mm, "of the body's height", {0, 100}),
          field<&Parameters::giving>("of how much the legs give, as a share of the model", {0, 10}),
          field<&Parameters::drift>(Unit::rad, "of what these angles change by in a second",
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

  /// Goes on to the next image, some time later (ms).
  void predict(double elapsed, bool walks);
  /// Learns from what was seen with the camera matrix that was last made, which had this azimuth
  /// (rad) and for which the model said `giving`.
  void learn(std::span<const SeenHeight> heights, double cameraAzimuth, const BodyPosture& giving);

  /// What to add to the body's posture, as it sways now, where the model says `giving`, and to the
  /// head's roll (rad).
  BodyPosture posture(const BodyPosture& giving) const;
  double headRoll() const { return state_.value[ofHead]; }
  /// How much the legs give, as a share of the model.
  double legsGive() const { return 1 + state_.value[share]; }
  /// That of the camera matrix (CameraMatrix.h).
  Matrix3d covariance(double cameraAzimuth, const BodyPosture& giving) const;
  /// What of that stays, and its standard deviations.
  BodyPosture built() const;
  BodyPosture deviation() const;
  double headRollDeviation() const { return std::sqrt(state_.covariance(ofHead, ofHead)); }

 private:
  /// Rotations about the robot's x and y axis, and about the camera's; mm; a share beside 1; then
  /// the rotations of swaying.
  enum { leanX, leanY, ofHead, height, share, swayX, swayY, size };
  using State = RobustEstimate<size>;
  using Shares = Eigen::Matrix<double, 3, size>;
  /// What the state does to a camera matrix.
  static Shares shares(double cameraAzimuth, const BodyPosture& giving);

  /// Makes measurements as surprising as they should be.
  void adaptSwaying(double surprise);

  State state_;
  double walkingVariance_ = 0;  ///< rad^2: of the swaying while it walks.
  bool begun_ = false, walks_ = false;
};

}  // namespace gt
