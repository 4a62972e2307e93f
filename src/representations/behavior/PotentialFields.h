#pragma once
#include <vector>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// Whether a rule attracts the robot to an object or repels it.
enum class PotentialEffect { attract, repel };

/// Object of a rule.
enum class PotentialObject {
  target,  ///< The robot's destination.
  ball,
  ownPenaltyArea,
  walls,
  goalEdges,  ///< The posts and side walls of both goals.
  teammates,
  opponents,
  obstacles  ///< The obstacles of the obstacles model (report 3.5).
};

/// How the force of a rule depends on the distance.
enum class PotentialFunction { linear, parabolic, asymptotic };

/// A simple potential field: one aspect of a continuous basic behavior (report 3.8.3).
struct PotentialRule {
  PotentialEffect effect = PotentialEffect::attract;
  PotentialObject object = PotentialObject::target;
  PotentialFunction function = PotentialFunction::linear;
  double strength = 1;
  double range = 300;

  /// The force at a distance (mm) from the object, in the direction of the effect. Attraction is at
  /// its maximum beyond the range and decreases to zero at the object. Repulsion is at its maximum
  /// at the object and zero beyond the range; asymptotic repulsion is limited by `mostRepulsion`
  /// only.
  double forceAt(double distance) const;

  static constexpr double mostRepulsion = 5;  ///< Greatest force of an asymptotic rule, as a
                                              ///< multiple of its strength.

  static constexpr auto fields() {
    using R = PotentialRule;
    return Fields{
        field<&R::effect>(), field<&R::object>(), field<&R::function>(),
        field<&R::strength>("greatest force; 1 walks at full speed", {0, 100}),
        field<&R::range>(
            Unit::mm,
            "attract: distance below which the force decreases; repel: distance beyond which "
            "there is no force",
            {1, 1e4})};
  }
};

/// The rules that are superposed for one continuous basic behavior.
struct PotentialField {
  std::vector<PotentialRule> rules;

  static constexpr auto fields() { return Fields{field<&PotentialField::rules>()}; }
};

/// The fields of all continuous basic behaviors. Configuration, from `potentialfields.cfg`.
struct PotentialFields {
  PotentialField goToBall, goToOwnGoal, goToPoint;

  static constexpr auto fields() {
    using F = PotentialFields;
    return Fields{field<&F::goToBall>("potential field of go_to_ball_continuously"),
                  field<&F::goToOwnGoal>("potential field of go_to_own_goal"),
                  field<&F::goToPoint>("potential field of go_to_point_continuously")};
  }
};

}  // namespace gt
