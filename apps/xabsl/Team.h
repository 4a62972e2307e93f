#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

#include "base/Result.h"
#include "xabsl/formats/Compile.h"

namespace xabsl::app {

/// A team's behavior: its files stand for those of a behavior with the same paths from the agents
/// file's folder on. As in a match, where nothing but files of the team differs.
class Team {
 public:
  /// A team that has nothing of its own.
  Team() = default;
  /// The team of a folder, or of that name in the root's folder teams.
  static gt::Result<Team> open(const std::string& name);

  /// Reads a behavior with the team's files. If its agents file lies in the team's folder, what is
  /// missing there is the root's.
  Compilation compile(const std::string& agents, Dialect dialect = Dialect::xabsl31) const;
  /// The agents file of the root.
  const std::string& agents() const { return agents_; }

 private:
  std::string folder_;  ///< Its folder behavior; empty if it has nothing of its own.
  std::string agents_;
};

/// Adds `--team` to a command.
void addTeam(CLI::App& command, std::string& name);
/// The team of that name; without one, a team that has nothing of its own. Prints an error and
/// returns nothing if there is no such team.
std::optional<Team> openTeam(const std::string& name);

}  // namespace xabsl::app
