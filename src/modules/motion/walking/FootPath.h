#pragma once
#include "modules/motion/walking/WalkParameters.h"

namespace gt {

/// The path of one foot through a step cycle (report, figures 3.20 and 3.22), independent of the
/// speed.
///
/// A cycle begins when the foot is lifted. Lengths along the walk are in units of half the distance
/// that the foot moves on the ground: it lands at 1 and is lifted at -1, unless parameters define
/// otherwise (FootMode::freeFormQuad).
class FootPath {
 public:
  FootPath(const WalkParameters& parameters, Leg leg);

  /// The position of the foot relative to its center. `along` is in units of the path.
  struct Point {
    double along = 0;
    double beyond = 0;  ///< mm, ahead, added to `along`.
    double aside = 0;   ///< mm away from the body.
    double height = 0;  ///< mm
  };

  /// The point at a phase: the share of the cycle that has passed since the foot was lifted, in [0,
  /// 1).
  Point at(double phase) const;
  bool inAir(double phase) const { return phase < air_; }
  double airPhase() const { return air_; }
  double groundPhase() const { return 1 - air_; }
  /// The points where the foot lands and where it is lifted.
  Point landing() const { return onGround(0); }
  Point lifting() const { return onGround(1); }

 private:
  Point onGround(double share) const;
  /// The point in the air by the progress: lifting (0 to 1), moving ahead (1 to 2) and lowering (2
  /// to 3).
  Point inFlight(double progress) const;

  FootMode mode_;
  double air_, lift_, lowering_, height_;
  WalkParameters::Quadruple quadruple_;
};

}  // namespace gt
