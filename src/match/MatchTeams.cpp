#include "match/MatchTeams.h"

#include <filesystem>
#include <utility>

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Loads a team with a program. Its robots read the files of the program's own tree that have the
/// same relative paths as those of this tree.
Result<void> loadProgram(const std::string& name, const DataRoot& ours, MatchTeam& team) {
  auto program = teamProgram(name, ours);
  if (!program) return program.error();
  const DataRoot& root = program->root;
  const auto there = [&](const std::string& path, const std::string& byDefault) {
    const auto relative = fs::absolute(path).lexically_normal().lexically_relative(
        fs::absolute(ours.path(".")).lexically_normal());
    const bool within = !relative.empty() && *relative.begin() != "..";
    return root.path(within ? relative.string() : byDefault);
  };
  team.configuration = nullptr;
  team.paths.config = there(team.paths.config, "config");
  team.paths.motions = there(team.paths.motions, "motions");
  team.paths.behavior = there(team.paths.behavior, "behavior/GT2003.xabsl");
  team.program = std::move(*program);
  const std::string folder = teamFolder(team.program->team, root);
  return folder.empty() ? Result<void>{} : team.open(folder);
}

}  // namespace

Result<void> MatchTeam::open(const std::string& name) {
  auto opened = TeamFolder::open(name, paths);
  if (!opened) return opened.error();
  folder = std::move(*opened);
  paths = folder->paths();
  return {};
}

Result<MatchTeams> MatchTeams::load(MatchSetup& setup, const DataRoot& root,
                                    const SceneDescription& scene) {
  MatchTeams teams;
  const ConfigurationPaths paths{scene.resolve(scene.config), setup.motions, setup.behavior};
  auto configuration = loadConfiguration(paths);
  if (!configuration) return configuration.error();
  teams.configuration_ = std::move(*configuration);
  for (std::string* team : {&setup.red, &setup.blue}) {
    auto resolved = resolvedTeam(*team, root);
    if (!resolved) return resolved.error();
    *team = *std::move(resolved);
  }
  const auto nameOf = [&](const std::string& given, const std::string& ofScene) {
    return given.empty() && !ofScene.empty() ? scene.resolve(ofScene) : given;
  };
  for (const auto& [color, name] : {std::pair{TeamColor::red, nameOf(setup.red, scene.red)},
                                    {TeamColor::blue, nameOf(setup.blue, scene.blue)}}) {
    MatchTeam& team = teams.teams_[static_cast<std::size_t>(color)];
    team.paths = paths;
    team.configuration = teams.configuration_;
    if (namesProgram(name)) {
      if (scene.challenge)
        return Error{.field = name, .what = "plays soccer only: a challenge is for this program"};
      if (auto done = loadProgram(name, root, team); !done) return done.error();
      continue;
    }
    const std::string folder = teamFolder(name, root);
    if (folder.empty()) continue;
    if (auto done = team.open(folder); !done) return done.error();
    auto own = loadConfiguration(team.paths);
    if (!own) return team.named(own.error());
    team.configuration = std::move(*own);
  }
  return teams;
}

void MatchTeams::setTargets(const TargetPoints& targets) {
  for (MatchTeam& team : teams_) {
    auto configuration = std::make_shared<Configuration>(*team.configuration);
    configuration->set(targets);
    team.configuration = std::move(configuration);
  }
}

}  // namespace gt
