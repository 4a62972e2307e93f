#pragma once
#include <vector>

#include "base/Random.h"
#include "base/Result.h"
#include "environments/EnvironmentOptions.h"
#include "simulation/scene/Scene.h"

namespace gt {

/// Domain randomization: each episode draws numbers of the scene uniformly between two bounds. A
/// number is one of those that profiles set, such as `noise.joints` or `camera.brightness`
/// (docs/realism.md), or of the element `dynamics`, such as `dynamics.friction`.
class Randomization {
 public:
  Randomization() = default;
  /// Fails if there is no such number, or a bound is out of its range.
  static Result<Randomization> make(std::vector<RandomizedNumber> numbers,
                                    const SceneDescription& scene);

  /// Draws all numbers, each independently of the others; the same generator draws the same values.
  void apply(const Random& random, SceneDescription& scene) const;

 private:
  std::vector<RandomizedNumber> numbers_;
};

}  // namespace gt
