#pragma once
#include <sstream>

#include "match/Match.h"
#include "match/teams/TeamFolder.h"
#include "measure/Experiment.h"

namespace gt {

/// The team that plays in a color.
inline Parameter teamParameter(const std::string& color) {
  return {color,
          "team: of the folder teams or a path, @ its files' fingerprint if these must not differ",
          Parameter::Kind::text,
          {TeamFolder::ownTeam}};
}

/// Who plays with the truth, for solutions Oracled.
inline Parameter oracledParameter() {
  return {"oracled",
          "robots and teams that are given the truth, such as red or red1,blue3",
          Parameter::Kind::text,
          {"none"}};
}

/// The names in that parameter.
inline std::vector<std::string> oracled(const Job& job) {
  std::vector<std::string> names;
  std::istringstream list{job.parameter("oracled")};
  for (std::string name; std::getline(list, name, ',');)
    if (name != "none") names.push_back(name);
  return names;
}

/// A match as a job's parameters profile, fidelity, red, blue and oracled want it.
inline Result<MatchOptions> matchOptions(const Job& job, const DataRoot& root) {
  MatchOptions options{root};
  options.seed = job.seed;
  options.fidelity = job.parameter("fidelity");
  options.profile = job.parameter("profile");
  options.truth = oracled(job);
  for (const auto& [color, team] : {std::pair{"red", &options.red}, {"blue", &options.blue}}) {
    auto folder = teamOfVersion(job.parameter(color), root);
    if (!folder) return folder.error();
    *team = *std::move(folder);
  }
  return options;
}

}  // namespace gt
