#pragma once
#include "match/Match.h"
#include "measure/Experiment.h"
#include "robot/TeamFolder.h"

namespace gt {

/// The team that plays in a color.
inline Parameter teamParameter(const std::string& color) {
  return {color,
          "team: of the folder teams or a path, @ its files' fingerprint if these must not differ",
          Parameter::Kind::text,
          {TeamFolder::ownTeam}};
}

/// A match as a job's parameters profile, fidelity, red and blue want it.
inline Result<MatchOptions> matchOptions(const Job& job, const DataRoot& root) {
  MatchOptions options{root};
  options.seed = job.seed;
  options.fidelity = job.parameter("fidelity");
  options.profile = job.parameter("profile");
  for (const auto& [color, team] : {std::pair{"red", &options.red}, {"blue", &options.blue}}) {
    auto folder = teamOfVersion(job.parameter(color), root);
    if (!folder) return folder.error();
    *team = *std::move(folder);
  }
  return options;
}

}  // namespace gt
