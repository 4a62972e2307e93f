#pragma once
#include "streams/Reflection.h"

namespace gt {

/// Effects of the carpet, which shortens walked distances and lets feet slip, and of obstacles that
/// a robot walks against. Kinematic fidelity only: in the dynamic fidelity friction and contacts
/// have these effects. Element `walking`.
struct WalkingParameters {
  double shortfall = 0;
  double gaitShortfall = 0;
  double bursts = 0;
  double burstTime = 0.5;
  double burstSlip = 0.5;
  double contactTurn = 0;
  double contactLag = 0;
  double contactShaking = 0;

  static constexpr auto fields() {
    using P = WalkingParameters;
    return Fields{
        field<&P::shortfall>("share by which all walked distances are shorter on this carpet",
                             {-0.5, 0.9}),
        field<&P::gaitShortfall>(
            "share that is added to it at 200 mm/s, in proportion to the speed", {-0.5, 0.9}),
        field<&P::bursts>(Unit::perMin, "how often a robot that walks begins to slip", {0, 1000}),
        field<&P::burstTime>(Unit::s, "mean time for which it slips", {0.01, 60}),
        field<&P::burstSlip>("share of the distance that is lost meanwhile", {0, 1}),
        field<&P::contactTurn>(
            Unit::degPerS,
            "at most, by which a robot is turned that walks against a wall or a robot", {0, 360}),
        field<&P::contactLag>(
            "share by which its legs move less than free ones would in the same time", {0, 0.9}),
        field<&P::contactShaking>(
            Unit::mmPerS2, "standard deviation of what its acceleration sensors feel of that",
            {0, 20000})};
  }
};

}  // namespace gt
