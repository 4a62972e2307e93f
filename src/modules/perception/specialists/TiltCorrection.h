#pragma once
#include "modules/perception/specialists/SeenHeights.h"

namespace gt {

/// Corrects tilt, roll and height of a camera matrix by the percepts of its own image, weighted
/// against the matrix's covariance.
class TiltCorrection {
 public:
  /// The corrected matrix, with which the percepts computed with `matrix` have the expected
  /// elevations.
  const CameraMatrix& correct(const CameraMatrix& matrix, const BallPercept& ball,
                              const LandmarksPercept& landmarks, const FieldDimensions& field);

 private:
  CameraMatrix corrected_;
  std::vector<SeenHeight> heights_;
};

}  // namespace gt
