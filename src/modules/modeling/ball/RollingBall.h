#pragma once
#include <Eigen/Core>

namespace gt {

/// A ball that rolls on carpet, with a constant deceleration until it rests, in a system that does
/// not move.
struct RollingBall {
  using State = Eigen::Vector4d;  ///< Position (mm), speed (mm/s).
  using Derivative = Eigen::Matrix4d;

  double deceleration;  ///< mm/s^2

  /// The state after a time (s).
  State after(double seconds, const State& state) const;
  /// The derivative of that state with respect to the one before. A ball without speed counts as
  /// one whose speed is not known, and not as one that rests.
  Derivative derivative(double seconds, const State& state) const;

 private:
  /// The time for which the ball rolls (s), and the share of its speed that is left then.
  struct Roll {
    double seconds, left;
  };
  Roll roll(double seconds, const State& state) const;
};

}  // namespace gt
