#pragma once
#include "debug/Debug.h"
#include "modules/motion/collisions/CollisionFeatures.h"
#include "representations/perception/CollisionPercept.h"

namespace gt {

/// Solution *MotorModel* of CollisionDetector: a logistic regression for each walk type, by the
/// differences of the legs from the predictions of models of their motors, by the shaking of the
/// robot, and by its walk. It is better than report 3.6, whose comparison of command and sensor
/// distinguishes the lag of the motors from that of a held-up leg in slow, steady walks only.
class MotorModelCollisionDetector {
 public:
  /// Parameters of the regression for a walk type.
  struct Walk {
    LegMotors motors{};
    std::array<double, CollisionFeatures::count> weights{};
    double constant = -20;  ///< Without weights there is no collision.

    /// The log-odds of a collision; a collision is assumed above 0.
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

    /// The parameters for a walk type; null if it is not watched. The walk type backward uses those
    /// of fast.
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

  /// Provides the collisions of the legs; none during special actions, within half a second after
  /// them or after a change of the walk type, and in walk types that are not watched.
  void update(const SensorDataBuffer& sensors, const JointData& joints, const MotionInfo& motion,
              CollisionPercept& percept, Debug& debug);

 private:
  CollisionFeatures features_;
  int above_ = 0;
};

}  // namespace gt
