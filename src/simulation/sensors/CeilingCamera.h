#pragma once
#include <vector>

#include "base/Random.h"
#include "representations/infrastructure/CeilingCameraPercept.h"
#include "simulation/world/World.h"

namespace gt {

/// How well a camera at the ceiling measures.
struct CeilingCameraParameters {
  double positionNoise = 6;         ///< mm, of each coordinate in each picture
  double rotationNoise = 0.02;      ///< rad
  double scaleError = 0.002;        ///< Of the calibration: at most, in each direction
  double offsetError = 8;           ///< mm, likewise
  double overlooked = 0.02;         ///< Share of pictures in which a thing is missed
  double lowX = -1e9, highX = 1e9;  ///< mm: what it sees, such as one half
  std::int64_t period = 40;         ///< ms
};

/// A camera at the ceiling that measures where robots and ball are, with errors of its own
/// (report 6.2.2).
class CeilingCamera {
 public:
  CeilingCamera(const CeilingCameraParameters& parameters, const std::vector<Player>& players,
                const Random& random);

  /// Looks at the world after a tick. Whether it was time for a picture; the percept is filled
  /// then.
  bool look(const World& world, CeilingCameraPercept& percept);

 private:
  Vector2d measured(const Vector2d& place);
  bool sees(const Vector2d& place);

  CeilingCameraParameters parameters_;
  std::vector<Player> players_;
  Random random_;
  Vector2d scale_, offset_;  ///< Errors that stay the same.
  Time next_;
};

}  // namespace gt
