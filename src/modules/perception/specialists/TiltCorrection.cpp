#include "modules/perception/specialists/TiltCorrection.h"

#include "modules/perception/specialists/RobustEstimate.h"

namespace gt {

const CameraMatrix& TiltCorrection::correct(const CameraMatrix& matrix, const BallPercept& ball,
                                            const LandmarksPercept& landmarks,
                                            const FieldDimensions& field) {
  constexpr double mostOff = 3;  // Standard deviations: what is off by more is something else.
  corrected_ = matrix;
  RobustEstimate<3> error;
  error.covariance = matrix.covariance;
  takeHeights(matrix, ball, landmarks, field, heights_);
  for (const SeenHeight& height : heights_) {
    const double variance = height.deviation * height.deviation;
    if (error.surprise(height.mended(), height.tooHigh, variance) < mostOff)
      error.add(height.mended(), height.tooHigh, variance);
  }
  corrected_.pose.rotation =
      rotationY(error.value.y()) * rotationX(error.value.x()) * corrected_.pose.rotation;
  corrected_.pose.translation.z() += error.value.z();
  corrected_.covariance = error.covariance;
  return corrected_;
}

}  // namespace gt
