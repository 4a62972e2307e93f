#pragma once
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// Corrects tilt and roll of a camera matrix by what an image shows. How high a flag, a goal or the
/// ball is seen follows from its distance, which its size gives: where it is seen higher or lower,
/// the body sways. What the errors of matrices have been lately weighs against the percepts' own.
class TiltCorrection {
 public:
  /// The matrix with which these percepts, made with `matrix`, are seen where they must be.
  const CameraMatrix& correct(const CameraMatrix& matrix, const BallPercept& ball,
                              const LandmarksPercept& landmarks, const FieldDimensions& field);

 private:
  static constexpr double usualVariance = fromDegrees(1) * fromDegrees(1);

  /// Something is seen so much too high in a direction; all in rad, with a standard deviation.
  void add(double azimuth, double tooHigh, double deviation);
  void addBall(const BallPercept& ball, double ballRadius);
  void addFlag(const FlagPercept& flag, const FieldDimensions& field);
  void addGoal(const GoalPercept& goal, const FieldDimensions& field);
  /// Something upright between two heights (mm); `error` is that of its middle's edges (pixels).
  void addStanding(const ConditionalBoundary& b, double low, double high, double error);

  CameraMatrix corrected_;
  Eigen::Matrix2d information_ = Eigen::Matrix2d::Zero();
  Vector2d weighted_ = Vector2d::Zero();
  double variance_ = usualVariance;  ///< rad^2: of the errors of matrices.
};

}  // namespace gt
