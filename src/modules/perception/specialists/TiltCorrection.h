#pragma once
#include "modules/perception/specialists/SeenHeights.h"

namespace gt {

/// Corrects tilt, roll and height of a camera matrix by what its own image shows, weighed against
/// what the matrix tells of its errors.
class TiltCorrection {
 public:
  /// The matrix with which these percepts, made with `matrix`, are seen where they must be.
  const CameraMatrix& correct(const CameraMatrix& matrix, const BallPercept& ball,
                              const LandmarksPercept& landmarks, const FieldDimensions& field);

 private:
  CameraMatrix corrected_;
  std::vector<SeenHeight> heights_;
};

}  // namespace gt
