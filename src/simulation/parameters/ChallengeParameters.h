#pragma once
#include "streams/Reflection.h"

namespace gt {

/// The technical challenges of 2003 (report, chapter 4).
enum class ChallengeKind { ball, localization, obstacles };

/// The challenge of a scene, which is started and scored automatically (simulation/Challenge.h).
/// Element `challenge`.
struct ChallengeParameters {
  ChallengeKind kind = ChallengeKind::obstacles;
  bool random = false;
  double start = 1;
  double precise = 50;
  double near = 100;

  static constexpr auto fields() {
    using P = ChallengeParameters;
    return Fields{
        field<&P::kind>(),
        field<&P::random>("whether the seed decides where all stand, or which places are visited"),
        field<&P::start>(Unit::s, "when the back switch is pressed", {0, 600}),
        field<&P::precise>(Unit::mm, "from a place to be visited, so near a stop gets all points",
                           {1, 1000}),
        field<&P::near>(Unit::mm, "so near it gets one", {1, 1000})};
  }
};

}  // namespace gt
