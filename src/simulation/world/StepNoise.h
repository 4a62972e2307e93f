#pragma once
#include <array>

#include "base/Random.h"
#include "simulation/parameters/NoiseParameters.h"

namespace gt {

/// By how much a robot's steps lead elsewhere than it believes, on a carpet that gives and drags:
/// normally distributed noise that keeps its direction for about a step. Of one robot, in both
/// fidelities.
class StepNoise {
 public:
  explicit StepNoise(const Random& random) : random_{random} {}

  /// What the carpet adds to the way of this tick, in the robot's system (rad, mm). `step` is what
  /// the robot believes to walk in it; who does not walk is not moved.
  Pose2D next(const NoiseParameters& noise, const Pose2D& step);

 private:
  Random random_;
  std::array<double, 3> now_{};  ///< Ahead, sideways, in turns: of standard deviation 1.
};

}  // namespace gt
