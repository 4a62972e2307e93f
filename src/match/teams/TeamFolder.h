#pragma once
#include <memory>
#include <string>

#include "base/DataRoot.h"
#include "base/TemporaryFolder.h"
#include "robot/Configuration.h"

namespace gt {

/// A team: a folder with files of its own in `config`, `behavior` and `motions`. Each file replaces
/// the project's file of that name, or is added to the others; all other files are the project's.
class TeamFolder {
 public:
  /// The name of the team that has no files of its own.
  static constexpr const char* ownTeam = "GT2003";

  /// Overrides files by those of a team's folder. Fails if it is no folder, if it has none of the
  /// three folders, or if it has others.
  static Result<std::unique_ptr<TeamFolder>> open(const std::string& folder,
                                                  const ConfigurationPaths& base);

  /// The paths from which the team's robots read: a temporary folder with links to the files, which
  /// exists as long as this object.
  const ConfigurationPaths& paths() const { return paths_; }
  /// An error about one of these files, with the name of the original file instead of the link.
  Error named(Error error) const;

 private:
  std::string folder_;
  TemporaryFolder links_;
  ConfigurationPaths paths_;
};

/// The folder of a team: NAME in the root's folder teams, or the folder of that path. Empty for the
/// team that has no files of its own.
std::string teamFolder(const std::string& team, const DataRoot& root);

/// Names a team for jobs: its folder and a fingerprint of all files in it, NAME@FINGERPRINT, where
/// NAME is short for a folder of the root's teams, and otherwise absolute; commit:HASH[:TEAM] if it
/// has programs of its own. Fails if there is no such team, or if its path cannot be a word of a
/// job.
Result<std::string> teamVersion(const std::string& team, const DataRoot& root);

/// The folder of a team that `teamVersion` has named. Fails if the files have changed since;
/// without a fingerprint they are not checked.
Result<std::string> teamOfVersion(const std::string& version, const DataRoot& root);

}  // namespace gt
