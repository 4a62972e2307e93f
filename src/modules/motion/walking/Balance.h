#pragma once
#include <array>
#include <vector>

#include "modules/motion/walking/WalkParameters.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {

/// Detects pushes and stumbling without a gyroscope. All steps of a walk are alike: for each frame
/// of the step cycle the mean acceleration and the mean lag of each leg behind its target are
/// learned. A difference of the acceleration is a push, whose speed is computed by integration. A
/// difference of the lag is a foot that has met an obstacle.
class Balance {
 public:
  /// Adds the measurements and the requested joint angles of a frame of the step cycle, whose
  /// length is `stepLen` (frames).
  void update(const BalanceParameters& parameters, const SensorData& measured,
              const JointAngles& asked, int frame, int stepLen);
  /// Forgets all means, after the walk has ended or changed.
  void forget();

  /// The speed of the body caused by a push (mm/s, in the robot's axes), reduced by the threshold.
  Vector2d unexpectedSpeed() const;
  /// Whether a leg is held back by an obstacle.
  bool stumbles(Leg leg) const { return stumbles_[leg]; }

 private:
  struct Expected {
    Vector2d acceleration = Vector2d::Zero();  ///< mm/s^2
    EnumArray<Leg, double> lag;                ///< rad, of the first joint
    int cycles = 0;                            ///< Number of step cycles that were learned from.
  };

  std::vector<Expected> cycle_;
  Vector2d speed_ = Vector2d::Zero();
  double threshold_ = 0;
  EnumArray<Leg, bool> stumbles_;
};

}  // namespace gt
