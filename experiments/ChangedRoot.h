#pragma once
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/DataRoot.h"
#include "base/TemporaryFolder.h"
#include "match/teams/TeamFolder.h"
#include "measure/Experiment.h"

namespace gt {

/// A data root like another one, but with other solutions and parameters in its configuration, and
/// other values in its motions. It lies in a temporary folder with links to the other one's files,
/// and to those of a team before these.
class ChangedRoot {
 public:
  /// `values` as the parameter below describes them, `team` as `teamOfVersion` takes it. A task,
  /// solution, parameter or value that does not exist is an error, as is a parameter out of its
  /// range.
  static Result<std::unique_ptr<ChangedRoot>> make(const DataRoot& root, const std::string& values,
                                                   const std::string& team = TeamFolder::ownTeam);

  DataRoot root() const { return DataRoot{folder_.path().string()}; }
  /// The changed files, relative to the root.
  const std::vector<std::string>& files() const { return files_; }
  /// An error about one of the root's files with the name of the file behind it.
  Error named(Error error) const;

 private:
  Result<void> link(const DataRoot& root, const std::string& team);

  std::unique_ptr<TeamFolder> team_;  ///< Null: none.
  TemporaryFolder folder_;
  std::vector<std::string> files_;
};

/// The parameter for what the robots' configuration has otherwise.
inline Parameter valuesParameter() {
  return {"values",
          "of the configuration: SelfLocator=GT2003,WalkingEngine.InvKin.normal.stepLen=40; or of "
          "motions: motions.pushStrong.lean-frames=9",
          Parameter::Kind::text,
          {"none"}};
}

/// Measures with the values of a job in the root: for experiments that have the parameter. If they
/// also have the parameter `team`, the values are those of the team's files.
template <Result<Measurement> (*measure)(const Job&, const DataRoot&)>
Result<Measurement> withValues(const Job& job, const DataRoot& root) {
  const std::string& values = job.parameter("values");
  if (values == "none") return measure(job, root);
  Job within = job;
  std::string team = TeamFolder::ownTeam;
  if (const auto named = within.parameters.find("team"); named != within.parameters.end())
    std::swap(team, named->second);
  const auto changed = ChangedRoot::make(root, values, team);
  if (!changed) return changed.error();
  auto measured = measure(within, (*changed)->root());
  if (!measured) return (*changed)->named(measured.error());
  return measured;
}

}  // namespace gt
