#pragma once
#include "debug/Debug.h"
#include "modules/motion/collisions/CollisionFeatures.h"
#include "representations/perception/CollisionPercept.h"

namespace gt {

/// Solution *MotorModel* of CollisionDetector: a logistic decision by how far the legs are from
/// where models of their motors expect them, by how the robot shakes, and by how it walks, for each
/// walk type. Better than report 3.6, whose comparison of command and sensor tells the motors' lag
/// from that of a leg that is held up in slow, steady walks only.
class MotorModelCollisionDetector {
 public:
  /// How a walk type looks while nothing holds the robot up, and how while something does.
  struct Walk {
    LegMotors motors{};
    std::array<double, CollisionFeatures::count> weights{};
    double constant = -20;  ///< Without weights there is no collision.

    /// The logarithm of how much more likely a collision is than where it is told.
    double score(const CollisionFeatures::Values& features) const;

    static constexpr auto fields() {
      return Fields{
          field<&Walk::motors>(
              Unit::oneRad,
              "of the legs' joints from legFR1 on: shares of the last commands, newest first, "
              "and a constant"),
          field<&Walk::weights>("of the features of CollisionFeatures.h"),
          field<&Walk::constant>("added to them: a collision is above 0")};
    }
  };

  struct Parameters {
    Walk normal, fast, dribble;
    int inARow = 12;

    /// That of a walk type; null if it is not watched. Walking back is as fast.
    const Walk* of(WalkType type) const;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{field<&P::normal>(), field<&P::fast>(), field<&P::dribble>(),
                    field<&P::inARow>(Unit::frames,
                                      "number of frames above the threshold that make a collision",
                                      {1, 100})};
    }
  };
  Parameters parameters;

  /// Provides what the legs bump into; nothing during special actions, within half a second after
  /// them or after a change of the walk type, and in walk types that are not watched.
  void update(const SensorDataBuffer& sensors, const JointData& joints, const MotionInfo& motion,
              CollisionPercept& percept, Debug& debug);

 private:
  CollisionFeatures features_;
  int above_ = 0;
};

}  // namespace gt
