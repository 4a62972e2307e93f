#pragma once
#include <array>

#include "base/Random.h"
#include "simulation/parameters/BodyParameters.h"
#include "simulation/parameters/WalkingParameters.h"

namespace gt {

/// How far a body is from where stiff legs would hold it.
struct Sway {
  double tilt = 0, roll = 0;  ///< rad, + nose up, + right side down
  double height = 0;          ///< mm
};

/// What a robot's legs do to its way and to its body beside what it believes: they give at each
/// step, so that the body sways, and slip on the carpet. Of one robot, in the kinematic fidelity.
class Gait {
 public:
  explicit Gait(const Random& random) : random_{random} {}

  /// How the body sways in this tick: with the lifted feet, and without rule. `lifts` are the
  /// feet's heights above the lowest one (mm), in the order of Leg; `height` is where stiff legs
  /// hold the body (mm); `speed` is the robot's (mm/s, a turn of 1 rad/s counts as 100 mm/s), and
  /// `ahead` the share of it that is straight ahead (-1 to 1).
  const Sway& sway(const BodyParameters& body, const std::array<double, 4>& lifts, double height,
                   double speed, double ahead);
  /// How it sways now.
  const Sway& sway() const { return now_; }

  /// The share of its path that a robot really goes which believes to have this speed (mm/s).
  double progress(const WalkingParameters& walking, double speed);
  /// By how much the robot turns in this tick because something is in its way (rad).
  double contactTurn(const WalkingParameters& walking, bool blocked);
  /// What the body feels of something in its way beside gravity (mm/s^2): its feet slip and bump.
  Vector3d contactShaking(const WalkingParameters& walking, bool blocked);

 private:
  /// Goes on for a tick; `uneven` is how much higher one side or diagonal is lifted (mm).
  void follow(double uneven, double height);
  /// Notices which feet stand and for how long.
  void stand(const std::array<double, 4>& lifts);

  Random random_;
  Sway now_;
  double sides_ = 0, diagonals_ = 0;   ///< mm: how far they are lifted on average.
  double rolls_ = 0;                   ///< -1 to 1, to the side with less below it.
  std::array<double, 4> nods_{};       ///< mm: follow one another and how high feet are lifted.
  double level_ = 0, meanLevel_ = 0;   ///< 0 to 1: how far one side is lifted.
  std::array<double, 4> stands_{};     ///< s: for how long each foot has stood.
  double stance_ = 0;                  ///< s: for which feet stand between two steps.
  double walks_ = 0, walksAhead_ = 0;  ///< 0 to 1, -1 to 1
  double height_ = -1;                 ///< mm, as legs that give carry it; below 0: not yet known.
  double wanderTilt_ = 0, wanderRoll_ = 0, wanderHeight_ = 0;  ///< Standard deviation 1.
  double slipsFor_ = 0;                                        ///< s
  double turning_ = 0;  ///< -1 to 1; 0: nothing is in the way.
};

}  // namespace gt
