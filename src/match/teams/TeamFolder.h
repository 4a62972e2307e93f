#pragma once
#include <memory>
#include <string>

#include "base/DataRoot.h"
#include "base/TemporaryFolder.h"
#include "robot/Configuration.h"

namespace gt {

/// A team: a folder with files of its own in `config`, `behavior` and `motions`. Each stands for
/// the project's file of that name, or joins the others; what is not there is the project's.
class TeamFolder {
 public:
  /// The name of the team that has nothing of its own.
  static constexpr const char* ownTeam = "GT2003";

  /// Lays a team's folder over files. Fails if it is no folder, has none of the three, or others.
  static Result<std::unique_ptr<TeamFolder>> open(const std::string& folder,
                                                  const ConfigurationPaths& base);

  /// What the team's robots read, for as long as this object exists: in a temporary folder with
  /// links to the files.
  const ConfigurationPaths& paths() const { return paths_; }
  /// An error about one of these files with the name of the file behind it.
  Error named(Error error) const;

 private:
  std::string folder_;
  TemporaryFolder links_;
  ConfigurationPaths paths_;
};

/// The folder of a team: NAME of the root's folder teams, or the folder of that path. Empty for the
/// team that has nothing of its own.
std::string teamFolder(const std::string& team, const DataRoot& root);

/// Names a team for jobs: its folder and a fingerprint of all files in it, NAME@FINGERPRINT, where
/// NAME is short for a folder of the root's teams, and otherwise absolute; commit:HASH[:TEAM] if it
/// has programs of its own. Fails if there is no such team, or if its path cannot be a word of a
/// job.
Result<std::string> teamVersion(const std::string& team, const DataRoot& root);

/// The folder of a team that `teamVersion` has named. Fails if the files are others now; without a
/// fingerprint they may be any.
Result<std::string> teamOfVersion(const std::string& version, const DataRoot& root);

}  // namespace gt
