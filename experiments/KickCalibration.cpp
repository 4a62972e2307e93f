// Measures the table of kicks (docs/motion.md).
#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "Experiments.h"
#include "base/File.h"
#include "match/teams/TeamFolder.h"
#include "measure/worlds/KickTables.h"
#include "modules/motion/specialactions/MotionNetLoader.h"
#include "streams/Config.h"

namespace gt {

Result<void> calibrateKicks(const std::vector<std::string>& kicks, const std::string& team,
                            const DataRoot& root, unsigned threads) {
  ConfigurationPaths paths = ConfigurationPaths::in(root);
  const std::string folder = teamFolder(team, root);
  std::unique_ptr<TeamFolder> files;
  if (!folder.empty()) {
    auto opened = TeamFolder::open(folder, paths);
    if (!opened) return opened.error();
    files = std::move(*opened);
    paths = files->paths();
  }
  const auto net = loadMotionNet(paths.motions);
  if (!net) return files ? files->named(net.error()) : net.error();
  KickTable table;
  if (auto read = readConfig(paths.config + "/kicks.cfg", table); !read)
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
  const std::string file =
      folder.empty() ? root.path("config/kicks.cfg") : folder + "/config/kicks.cfg";
  std::error_code failed;  // then the file cannot be written, either
  std::filesystem::create_directories(std::filesystem::path{file}.parent_path(), failed);
  return writeFile(file, kickTableText(table));
}

}  // namespace gt
