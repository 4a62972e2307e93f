#pragma once
#include "base/Enum.h"
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

}  // namespace gt
