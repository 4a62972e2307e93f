#pragma once
#include <array>

#include "base/Random.h"
#include "simulation/parameters/NoiseParameters.h"

namespace gt {

/// The differences of one robot's real steps from those it believes to make, on a carpet that gives
/// and drags: normally distributed noise that keeps its direction for about a step. Used in both
/// fidelities.
class StepNoise {
 public:
  explicit StepNoise(const Random& random) : random_{random} {}

  /// The motion that the carpet adds in this tick, relative to the robot (rad, mm). `step` is the
  /// motion that the robot believes to make; a robot that does not walk is not moved.
  Pose2D next(const NoiseParameters& noise, const Pose2D& step);

 private:
  Random random_;
  std::array<double, 3> now_{};  ///< Ahead, sideways, in turns: of standard deviation 1.
};

}  // namespace gt
