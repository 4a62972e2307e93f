#pragma once
#include <array>
#include <vector>

#include "modules/motion/walking/WalkParameters.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {

/// What a walk does not expect, found without a gyroscope. All steps of a walk are alike: for each
/// frame of the step cycle there is a mean of the acceleration and of each leg's lag behind its
/// target. What differs from the former was a push, whose speed follows by integration; what
/// differs from the latter is a foot that has met something.
class Balance {
 public:
  /// Takes what was measured in a frame of the step cycle, and the joints that were asked for.
  void update(const BalanceParameters& parameters, const SensorData& measured,
              const JointAngles& asked, int frame, int stepLen);
  /// The walk has ended, or is another one.
  void forget();

  /// The speed of the body that the walk did not mean (mm/s, in the robot's axes).
  Vector2d unexpectedSpeed() const;
  /// Whether a leg is held back.
  bool stumbles(Leg leg) const { return stumbles_[leg]; }

 private:
  struct Expected {
    Vector2d acceleration = Vector2d::Zero();  ///< mm/s^2
    EnumArray<Leg, double> lag;                ///< rad, of the first joint
    int cycles = 0;                            ///< From so many it is known.
  };

  std::vector<Expected> cycle_;
  Vector2d speed_ = Vector2d::Zero();
  double threshold_ = 0;
  EnumArray<Leg, bool> stumbles_;
};

}  // namespace gt
