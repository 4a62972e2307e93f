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

/// A scene of the root in the profile of a job.
inline Result<SceneDescription> loadScene(const Job& job, const DataRoot& root,
                                          const std::string& path = "scenes/match.scene") {
  auto scene = loadScene(root.path(path));
  if (scene) setProfile(*scene, profileOf(job));
  return scene;
}

}  // namespace gt
