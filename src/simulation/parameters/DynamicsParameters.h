#pragma once
#include "streams/Reflection.h"

namespace gt {

/// Factors by which the bodies of the dynamic fidelity differ from their models. Element
/// `dynamics`.
struct DynamicsParameters {
  double friction = 1;
  double mass = 1;
  double strength = 1;

  bool operator==(const DynamicsParameters&) const = default;
  static constexpr auto fields() {
    using P = DynamicsParameters;
    constexpr Range factor{0.1, 10};
    return Fields{field<&P::friction>("factor on the sliding friction of robots", factor),
                  field<&P::mass>("factor on the masses of all parts of robots", factor),
                  field<&P::strength>("factor on the servos' torques and their P gains", factor)};
  }
};

}  // namespace gt
