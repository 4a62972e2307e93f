#include "network/RouterSettings.h"

#include <filesystem>

#include "base/File.h"
#include "base/UserFolder.h"
#include "streams/Config.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

Result<void> read(const std::string& file, std::optional<Keys>& keys) {
  if (file.empty()) return {};
  auto loaded = loadKeys(file);
  if (!loaded) return loaded.error();
  keys = std::move(*loaded);
  return {};
}

/// Means the same wherever the router is started the next time.
std::string absolute(const std::string& file) {
  std::error_code failed;
  return file.empty() ? file : fs::absolute(file, failed).string();
}

}  // namespace

RoutedRobot RouterSettings::wanted(RoutedRobot robot) const {
  if (release) robot.tools.clear();
  if (!team.empty()) robot.team = team;
  if (noTeams) robot.team.clear();
  return robot;
}

Result<RouterOptions> routerOptions(const RouterSettings& settings) {
  RouterOptions options;
  if (settings.gameManager) options.all = settings.endpoint(allRobotsPort);
  if (settings.routers) options.routers = settings.endpoint(routersPort);
  options.others = settings.join;
  if (auto done = read(settings.keys, options.listenKeys); !done) return done.error();
  if (auto done = read(settings.connectKeys, options.connectKeys); !done) return done.error();
  return options;
}

std::string lastSettingsFile() {
  const std::string folder = userFolder(UserFolder::state);
  return folder.empty() ? "" : folder + "/router.cfg";
}

Result<void> keepSettings(const RouterSettings& settings, const std::string& file) {
  RouterSettings kept = settings;
  for (std::string* path : {&kept.sockets, &kept.keys, &kept.connectKeys}) *path = absolute(*path);
  std::error_code failed;
  fs::create_directories(fs::path{file}.parent_path(), failed);
  if (failed) return Error{.file = file, .what = failed.message()};
  return writeFile(file, writeConfig(kept));
}

}  // namespace gt
