#pragma once
#include <cmath>
#include <optional>
#include <vector>

#include "representations/infrastructure/FieldDimensions.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// The difference between the seen and the expected elevation of an object. The expected elevation
/// of a flag, a goal or the ball follows from its distance, which its size gives. The difference
/// measures the error of the camera matrix.
struct SeenHeight {
  double azimuth = 0;    ///< rad, relative to the robot.
  double tooHigh = 0;    ///< Seen minus expected elevation, rad.
  double distance = 0;   ///< From the camera, along the ground, mm.
  double deviation = 0;  ///< Standard deviation of `tooHigh` caused by the percept alone, rad.

  /// The part of `tooHigh` that is corrected by turning the camera about the robot's x axis by 1
  /// rad, about its y axis by 1 rad, and by lifting it by 1 mm.
  Vector3d mended() const { return {-std::sin(azimuth), std::cos(azimuth), -1 / distance}; }
};

/// The SeenHeight of a flag; nothing if its upper or lower end is not seen.
std::optional<SeenHeight> heightOf(const FlagPercept& flag, const CameraMatrix& matrix,
                                   const FieldDimensions& field);

/// Replaces `heights` by those of all percepts of an image with a camera matrix.
void takeHeights(const CameraMatrix& matrix, const BallPercept& ball,
                 const LandmarksPercept& landmarks, const FieldDimensions& field,
                 std::vector<SeenHeight>& heights);

}  // namespace gt
