#pragma once
#include <array>

#include "base/Random.h"
#include "simulation/parameters/BodyParameters.h"
#include "simulation/parameters/WalkingParameters.h"

namespace gt {

/// Deviation of a body from the pose in which stiff legs would hold it.
struct Sway {
  double tilt = 0, roll = 0;  ///< rad, + nose up, + right side down
  double height = 0;          ///< mm
};

/// Effects of one robot's legs on its path and its body that the robot does not know of: the legs
/// give at each step, so that the body sways, and they slip on the carpet. Kinematic fidelity only.
class Gait {
 public:
  explicit Gait(const Random& random) : random_{random} {}

  /// Computes the sway of the body in this tick, which has a part that follows the lifted feet and
  /// an irregular one. `lifts` are the feet's heights above the lowest one (mm), in the order of
  /// Leg; `height` is the height at which stiff legs hold the body (mm); `speed` is the robot's
  /// (mm/s, a turn of 1 rad/s counts as 100 mm/s), and `ahead` the share of it that is straight
  /// ahead (-1 to 1).
  const Sway& sway(const BodyParameters& body, const std::array<double, 4>& lifts, double height,
                   double speed, double ahead);
  /// The present sway.
  const Sway& sway() const { return now_; }

  /// The share of its path that a robot really walks if it believes to have `speed` (mm/s).
  double progress(const WalkingParameters& walking, double speed);
  /// The turn of the robot in this tick (rad) caused by something in its way.
  double contactTurn(const WalkingParameters& walking, bool blocked);
  /// The acceleration that the body feels beside gravity (mm/s^2) when something is in its way,
  /// because its feet slip and bump.
  Vector3d contactShaking(const WalkingParameters& walking, bool blocked);

 private:
  /// Advances by a tick; `uneven` is how much higher one side or diagonal is lifted (mm).
  void follow(double uneven, double height);
  /// Updates which feet stand and for how long.
  void stand(const std::array<double, 4>& lifts);

  Random random_;
  Sway now_;
  double sides_ = 0, diagonals_ = 0;   ///< mm: mean lift of a side or diagonal.
  double rolls_ = 0;                   ///< -1 to 1, to the side with less below it.
  std::array<double, 4> nods_{};       ///< mm: a chain of filters that follows the feet's lift.
  double level_ = 0, meanLevel_ = 0;   ///< 0 to 1: how far one side is lifted.
  std::array<double, 4> stands_{};     ///< s: for how long each foot has stood.
  double stance_ = 0;                  ///< s: time for which feet stand between two steps.
  double walks_ = 0, walksAhead_ = 0;  ///< 0 to 1, -1 to 1
  double height_ = -1;                 ///< mm, as legs that give carry it; below 0: not yet known.
  double wanderTilt_ = 0, wanderRoll_ = 0, wanderHeight_ = 0;  ///< Standard deviation 1.
  double slipsFor_ = 0;                                        ///< s
  double turning_ = 0;  ///< -1 to 1; 0: nothing is in the way.
};

}  // namespace gt
