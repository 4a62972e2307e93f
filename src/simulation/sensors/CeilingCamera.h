#pragma once
#include <vector>

#include "base/Random.h"
#include "representations/infrastructure/CeilingCameraPercept.h"
#include "simulation/parameters/CeilingCameraParameters.h"
#include "simulation/world/World.h"

namespace gt {

/// A camera at the ceiling that measures where robots and ball are, with errors of its own
/// (report 6.2.2).
class CeilingCamera {
 public:
  CeilingCamera(const CeilingCameraParameters& parameters, const std::vector<Player>& players,
                const Random& random);

  /// Takes an image of the world after a tick if one is due. Returns whether it did; only then the
  /// percept is filled.
  bool look(const World& world, CeilingCameraPercept& percept);
  const CeilingCameraParameters& parameters() const { return parameters_; }

 private:
  Vector2d measured(const Vector2d& place);
  bool sees(const Vector2d& place);

  CeilingCameraParameters parameters_;
  std::vector<Player> players_;
  Random random_;
  Vector2d scale_, offset_;  ///< Constant errors of the calibration.
  Time next_;
};

}  // namespace gt
