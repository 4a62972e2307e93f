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

/// What the robots of a color play with.
struct MatchTeam {
  std::unique_ptr<TeamFolder> folder;  ///< Null if it has nothing of its own.
  ConfigurationPaths paths;
  std::shared_ptr<const Configuration> configuration;  ///< Null if it has a program.
  std::optional<TeamProgram> program;

  /// An error about its files with the name of the file behind it.
  Error named(Error error) const { return folder ? folder->named(std::move(error)) : error; }
  /// Lays a team's folder over the paths.
  Result<void> open(const std::string& name);
};

/// The two teams of a match.
class MatchTeams {
 public:
  /// Reads the files of both. The setup's names of teams mean the same for ever afterwards.
  static Result<MatchTeams> load(MatchSetup& setup, const DataRoot& root,
                                 const SceneDescription& scene);

  const MatchTeam& of(TeamColor color) const { return teams_[static_cast<std::size_t>(color)]; }
  /// The project's own, which also holds for the field.
  const std::shared_ptr<const Configuration>& configuration() const { return configuration_; }
  /// Has both visit other places in a challenge.
  void setTargets(const TargetPoints& targets);

 private:
  std::shared_ptr<const Configuration> configuration_;
  std::array<MatchTeam, 2> teams_;  ///< By color.
};

}  // namespace gt
