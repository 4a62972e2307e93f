#pragma once
#include "streams/Reflection.h"

namespace gt {

/// For each foul, the seconds that it lasts until the referee penalizes it; 0: never (facts, 2.2).
/// Also for how long robots are removed, and the penalty shoot-out. Element `rules`.
struct RuleParameters {
  double ballHolding = 3;
  double keeperBallHolding = 5;
  double keeperCharge = 3;
  double fieldPlayerCharge = 3;
  double illegalDefender = 3;
  double illegalDefense = 3;
  double obstruction = 3;
  double requestForPickup = 15;
  double removal = 30;
  double obstructionRemoval = 0;
  int shots = 5;
  double shotTime = 60;

  static constexpr auto fields() {
    constexpr Range seconds{0, 600};
    return Fields{
        field<&RuleParameters::ballHolding>(
            Unit::s, "a field player's, or the keeper's outside of its penalty area", seconds),
        field<&RuleParameters::keeperBallHolding>(Unit::s, "the keeper's in its penalty area",
                                                  seconds),
        field<&RuleParameters::keeperCharge>(
            Unit::s, "walking into the other keeper in its penalty area", seconds),
        field<&RuleParameters::fieldPlayerCharge>(
            Unit::s, "walking into any other robot of the other team", seconds),
        field<&RuleParameters::illegalDefender>(Unit::s, "a field player in the own penalty area",
                                                seconds),
        field<&RuleParameters::illegalDefense>(
            Unit::s, "in the center circle at the other team's kick-off", seconds),
        field<&RuleParameters::obstruction>(
            Unit::s, "standing in an opponent's path, far from the ball", seconds),
        field<&RuleParameters::requestForPickup>(Unit::s, "lying on the side without getting up",
                                                 seconds),
        field<&RuleParameters::removal>(Unit::s, "for all penalties but obstruction", seconds),
        field<&RuleParameters::obstructionRemoval>(Unit::s, seconds),
        field<&RuleParameters::shots>("of each team in a shoot-out", {1, 100}),
        field<&RuleParameters::shotTime>(Unit::s, "for one shot", {1, 600})};
  }
};

}  // namespace gt
