#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>

#include "match/MatchSetup.h"
#include "match/teams/TeamFolder.h"
#include "match/teams/TeamProgram.h"
#include "representations/behavior/TargetPoints.h"
#include "robot/Configuration.h"
#include "simulation/scene/Scene.h"

namespace gt {

/// The files, and where it has one the program, of the team of a color.
struct MatchTeam {
  std::unique_ptr<TeamFolder> folder;  ///< Null if it has no files of its own.
  ConfigurationPaths paths;
  std::shared_ptr<const Configuration> configuration;  ///< Null if it has a program.
  std::optional<TeamProgram> program;

  /// An error about its files, with the names of the original files instead of the links.
  Error named(Error error) const { return folder ? folder->named(std::move(error)) : error; }
  /// Overrides the paths by a team's folder.
  Result<void> open(const std::string& name);
};

/// The two teams of a match.
class MatchTeams {
 public:
  /// Reads the files of both teams. Resolves the setup's names of teams, so that they always denote
  /// the same versions afterwards.
  static Result<MatchTeams> load(MatchSetup& setup, const DataRoot& root,
                                 const SceneDescription& scene);

  const MatchTeam& of(TeamColor color) const { return teams_[static_cast<std::size_t>(color)]; }
  /// The project's own configuration, which also applies to the field.
  const std::shared_ptr<const Configuration>& configuration() const { return configuration_; }
  /// Sets the places that both teams visit in a challenge.
  void setTargets(const TargetPoints& targets);

 private:
  std::shared_ptr<const Configuration> configuration_;
  std::array<MatchTeam, 2> teams_;  ///< By color.
};

}  // namespace gt
