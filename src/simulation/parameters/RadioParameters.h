#pragma once
#include "streams/Reflection.h"

namespace gt {

/// The wireless network between the robots of a team. Element `radio`.
struct RadioParameters {
  double delayMin = 40;
  double delayMax = 120;
  double loss = 0.05;
  bool out = false;
  double bursts = 0;
  double burstTime = 2;
  double burstLoss = 1;

  static constexpr auto fields() {
    return Fields{
        field<&RadioParameters::delayMin>(Unit::ms, {0, 10'000}),
        field<&RadioParameters::delayMax>(Unit::ms, {0, 10'000}),
        field<&RadioParameters::loss>("share of messages that never arrive", {0, 1}),
        field<&RadioParameters::out>("nothing gets through"),
        field<&RadioParameters::bursts>(Unit::perMin, "how often the network breaks down",
                                        {0, 1000}),
        field<&RadioParameters::burstTime>(Unit::s, "mean time until it works again", {0.01, 600}),
        field<&RadioParameters::burstLoss>("share of messages that are lost meanwhile", {0, 1})};
  }
};

}  // namespace gt
