#pragma once
#include <memory>

#include "base/Enum.h"
#include "match/Match.h"
#include "measure/Experiment.h"
#include "simulation/scene/ProfileTable.h"

namespace gt {

/// The parameter of what depends on how far simulated robots are from perfect (docs/realism.md).
inline Parameter profileParameter() {
  return {
      "profile", "how far all is from perfect", Parameter::Kind::each, {"padova", "benign"}, true};
}
inline Profile profileOf(const Job& job) {
  return *enumValue<Profile>(job.parameter("profile"));
}

/// The parameter that changes single numbers of the profile.
inline Parameter changeParameter() {
  return {"change",
          "numbers of the profile to change: body/tilt=1,noise/slip=0,audience=0",
          Parameter::Kind::text,
          {"none"}};
}
/// Changes numbers of a scene as that parameter tells.
Result<void> changeNumbers(SceneDescription& scene, const std::string& changes);

/// A scene of the root in the profile of a job, changed if the job has that parameter.
Result<SceneDescription> loadScene(const Job& job, const DataRoot& root,
                                   const std::string& path = "scenes/match.scene");

/// The parameter of what moves bodies, in the dynamic fidelity first.
inline Parameter fidelityParameter() {
  return {"fidelity", "of the body", Parameter::Kind::choice, {"dynamic", "kinematic"}, true};
}
/// The parameter of how far friction, masses and the servos' strength are from the model's.
inline Parameter varietyParameter() {
  return {"variety",
          "share by which friction, masses and strength differ at most",
          Parameter::Kind::number,
          {"0.1"}};
}
/// A scene of the root as a job asks for it, with so many of its robots and no ball. In the dynamic
/// fidelity friction, masses and the servos' strength differ from the model's by up to the job's
/// variety, or a tenth, each seed otherwise.
Result<SceneDescription> dynamicScene(const Job& job, const DataRoot& root, std::size_t robots = 1);

/// A match of the root's match scene in the profile of a job, as many minutes as the job has.
Result<std::unique_ptr<Match>> makeMatch(const Job& job, const DataRoot& root);

}  // namespace gt
