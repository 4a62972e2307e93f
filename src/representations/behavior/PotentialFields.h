#pragma once
#include <vector>

#include "base/Geometry.h"
#include "streams/Reflection.h"

namespace gt {

/// Whether a rule draws the robot to its object or keeps it off.
enum class PotentialEffect { attract, repel };

/// What a rule is about.
enum class PotentialObject {
  target,  ///< The place to go to.
  ball,
  ownPenaltyArea,
  walls,
  goalEdges,  ///< The posts and side walls of both goals.
  teammates,
  opponents,
  obstacles  ///< What the obstacles model knows (report 3.5).
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

  /// The force at a distance (mm) from the object, in the direction of the effect. Attraction is
  /// full beyond its range, and falls to nothing at the object. Repulsion is full at the object and
  /// nothing beyond its range; an asymptotic one has no limit but `mostRepulsion`.
  double forceAt(double distance) const;

  static constexpr double mostRepulsion = 5;  ///< Of an asymptotic rule, in units of its strength.

  static constexpr auto fields() {
    using R = PotentialRule;
    return Fields{
        field<&R::effect>(), field<&R::object>(), field<&R::function>(),
        field<&R::strength>("greatest force; 1 walks at full speed", {0, 100}),
        field<&R::range>(Unit::mm,
                         "attract: nearer than that the force decreases; repel: farther than that "
                         "there is none",
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
    return Fields{field<&F::goToBall>("of go_to_ball_continuously"),
                  field<&F::goToOwnGoal>("of go_to_own_goal"),
                  field<&F::goToPoint>("of go_to_point_continuously")};
  }
};

}  // namespace gt
