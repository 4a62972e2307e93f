#include "Tournament.h"

#include <algorithm>

#include "Experiments.h"
#include "match/teams/TeamFolder.h"
#include "robot/ProjectVersion.h"

namespace gt {

Result<std::vector<Job>> listTournament(const std::vector<std::string>& teams,
                                        const std::vector<std::uint64_t>& seeds,
                                        std::vector<std::string> settings, const DataRoot& root) {
  if (teams.size() < 2) return Error{.field = "tournament", .what = "expected two teams or more"};
  std::vector<std::string> versions;
  for (const std::string& team : teams) {
    auto version = teamVersion(team, root);
    if (!version) return version.error();
    if (std::ranges::find(versions, *version) != versions.end())
      return Error{.field = team, .what = "is given twice"};
    versions.push_back(*std::move(version));
  }
  for (const std::string& setting : settings)
    if (setting.starts_with("red=") || setting.starts_with("blue="))
      return Error{.field = setting, .what = "is what the tournament sets"};
    else if (setting.starts_with("oracled="))
      return Error{.field = setting, .what = "no team of a tournament is given the truth"};
  const auto isProfile = [](const std::string& setting) { return setting.starts_with("profile="); };
  if (std::ranges::none_of(settings, isProfile)) settings.emplace_back("profile=padova");
  const auto version = projectVersion(root);
  if (!version) return version.error();
  const auto matches = listJobs(experiments(), {seeds, {"match"}, settings}, *version);
  if (!matches) return matches;
  std::vector<Job> jobs;
  for (Job job : *matches)
    for (const std::string& red : versions)
      for (const std::string& blue : versions) {
        if (red == blue) continue;
        job.parameters["red"] = red;
        job.parameters["blue"] = blue;
        jobs.push_back(job);
      }
  return jobs;
}

}  // namespace gt
