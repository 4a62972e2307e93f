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

  /// Looks at the world after a tick. Returns whether it was time for an image; then the percept is
  /// filled.
  bool look(const World& world, CeilingCameraPercept& percept);
  const CeilingCameraParameters& parameters() const { return parameters_; }

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
