#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// How high something is seen, beside where it must be: how high a flag, a goal or the ball is seen
/// follows from its distance, which its size gives. It tells how wrong a camera matrix is.
struct SeenHeight {
  double azimuth = 0;    ///< rad
  double tooHigh = 0;    ///< rad
  double distance = 0;   ///< mm, on the ground, from the camera.
  double deviation = 0;  ///< rad: the standard deviation of `tooHigh` by the percept alone.

  /// What turns a camera about the robot's x and y axis by 1 rad, and lifts it by 1 mm, add to
  /// `tooHigh` that they mend.
  Vector3d mended() const { return {-std::sin(azimuth), std::cos(azimuth), -1 / distance}; }
};

/// That of a flag; nothing if its upper or lower end is not seen.
std::optional<SeenHeight> heightOf(const FlagPercept& flag, const CameraMatrix& matrix,
                                   const FieldDimensions& field);

/// Replaces `heights` by those of all that was perceived with a camera matrix.
void takeHeights(const CameraMatrix& matrix, const BallPercept& ball,
                 const LandmarksPercept& landmarks, const FieldDimensions& field,
                 std::vector<SeenHeight>& heights);

}  // namespace gt
