// Measures the table of kicks (docs/motion.md).
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "Experiments.h"
#include "base/File.h"
#include "match/teams/TeamFolder.h"
#include "match/teams/TeamProgram.h"
#include "measure/worlds/KickTables.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// The file of the table of a team's kicks. That of a commit's team is kept among the project's
/// files, since the commit cannot be changed.
Result<std::string> tableOf(const std::string& team, const std::string& folder,
                            const DataRoot& root) {
  if (!namesProgram(team))
    return (folder.empty() ? root.path("") : folder + "/") + "config/kicks.cfg";
  const auto named = resolvedTeam(team, root);
  if (!named) return named.error();
  constexpr std::string_view prefix = "commit:";
  if (!named->starts_with(prefix))
    return Error{.field = team, .what = "is neither a folder nor a commit"};
  return root.path("config/opponents/" + named->substr(prefix.size(), 12) + ".cfg");
}

}  // namespace

Result<void> calibrateKicks(const std::vector<std::string>& kicks, const std::string& team,
                            const DataRoot& root, unsigned threads) {
  ConfigurationPaths paths = ConfigurationPaths::in(root);
  const std::string folder = namesProgram(team) ? "" : teamFolder(team, root);
  const auto file = tableOf(team, folder, root);
  if (!file) return file.error();
  std::unique_ptr<TeamFolder> files;
  if (namesProgram(team)) {
    const auto program = teamProgram(team, root);
    if (!program) return program.error();
    paths = ConfigurationPaths::in(program->root);
  } else if (!folder.empty()) {
    auto opened = TeamFolder::open(folder, paths);
    if (!opened) return opened.error();
    files = std::move(*opened);
    paths = files->paths();
  }
  const auto net = loadMotionNet(paths.motions);
  if (!net) return files ? files->named(net.error()) : net.error();
  KickTable table;
  const std::string known = namesProgram(team) ? *file : paths.config + "/kicks.cfg";
  if (std::filesystem::exists(known) || !namesProgram(team))
    if (auto read = readConfig(known, table); !read)
      return files ? files->named(read.error()) : read.error();
  std::erase_if(table.kicks,
                [&](const KickDescription& kick) { return net->find(kick.motion) <= 0; });
  for (const std::string& name : kicks.empty() ? kicksIn(paths.motions) : kicks) {
    if (net->find(name) <= 0)
      return Error{.field = name, .what = "is no motion of " + paths.motions};
    const auto described = measureKick(name, *net, paths.motions, root, threads);
    if (!described) return described.error();
    fmt::print("{}: {}\n", name, described->why);
    std::fflush(stdout);
    std::erase_if(table.kicks, [&](const KickDescription& kick) { return kick.motion == name; });
    if (!described->kick.places.empty()) table.kicks.push_back(described->kick);
  }
  std::ranges::sort(table.kicks, {}, &KickDescription::motion);
  std::error_code failed;  // then the file cannot be written, either
  std::filesystem::create_directories(std::filesystem::path{*file}.parent_path(), failed);
  return writeFile(*file, kickTableText(table));
}

}  // namespace gt
