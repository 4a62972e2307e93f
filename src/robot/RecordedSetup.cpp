#include "robot/RecordedSetup.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>

#include "robot/Commit.h"
#include "streams/File.h"
#include "streams/TemporaryFolder.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

constexpr const char* metadataName = "gt2003 robot";
/// Files beyond this are no configuration.
constexpr std::uintmax_t largestFile = 4u << 20;

Result<void> attachFile(const fs::path& file, const std::string& name, McapWriter& log) {
  const auto content = readFile(file.string());
  if (!content) return content.error();
  log.attachment(name, "application/octet-stream", Time{}, std::as_bytes(std::span{*content}));
  return {};
}

Result<void> attachFolder(const fs::path& folder, const std::string& name, McapWriter& log) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at{folder, failure}, end; !failure && at != end;
       at.increment(failure))
    if (at->is_regular_file() && at->file_size() <= largestFile) files.push_back(at->path());
  if (failure) return Error{folder.string(), 0, "", failure.message()};
  std::sort(files.begin(), files.end());
  for (const fs::path& file : files)
    if (auto done = attachFile(file, name + "/" + fs::relative(file, folder).generic_string(), log);
        !done)
      return done;
  return {};
}

/// Whether a name stays in the folder that it is unpacked to.
bool staysInside(const fs::path& name) {
  return name.is_relative() &&
         std::none_of(name.begin(), name.end(), [](const fs::path& part) { return part == ".."; });
}

Result<void> unpack(const McapReader& log, const fs::path& folder, const std::string& file) {
  if (folder.empty()) return Error{"", 0, "", "there is no temporary folder"};
  for (const McapReader::Attachment& attachment : log.attachments()) {
    if (!staysInside(attachment.name) || attachment.name.empty())
      return Error{file, 0, attachment.name, "this attachment's name leads out of its folder"};
    const fs::path path = folder / attachment.name;
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    if (auto done = writeFile(path.string(), {reinterpret_cast<const char*>(attachment.data.data()),
                                              attachment.data.size()});
        !done)
      return done;
  }
  return {};
}

template <typename E>
std::optional<E> enumOf(const std::string& name) {
  for (std::size_t i = 0; i < enumCount<E>; ++i)
    if (enumNames<E>[i] == name) return static_cast<E>(i);
  return std::nullopt;
}

/// Reads the metadata into a setup; returns the agents file's name.
Result<std::string> readRobot(const std::map<std::string, std::string>& entries, RobotSetup& setup,
                              const std::string& file) {
  const auto entry = [&](const char* name) {
    const auto at = entries.find(name);
    return at == entries.end() ? std::string{} : at->second;
  };
  const auto team = enumOf<TeamColor>(entry("team"));
  const auto role = enumOf<PlayerRole>(entry("role"));
  const std::string seed = entry("seed");
  const auto [end, failure] = std::from_chars(seed.data(), seed.data() + seed.size(), setup.seed);
  if (!team || !role || failure != std::errc{} || end != seed.data() + seed.size())
    return Error{file, 0, metadataName, "does not tell team, role and seed"};
  setup.player = {*team, *role};
  setup.address = entry("address");
  const std::string agents = entry("behavior");
  if (!staysInside(agents)) return Error{file, 0, metadataName, "has a wrong behavior"};
  return agents;
}

}  // namespace

Result<void> attachSetup(const RecordedSetup& setup, McapWriter& log) {
  const fs::path behavior{setup.paths.behavior};
  log.metadata(metadataName, {{"team", std::string{enumName(setup.player.teamColor)}},
                              {"role", std::string{enumName(setup.player.role)}},
                              {"seed", std::to_string(setup.seed)},
                              {"address", setup.address},
                              {"layout", fs::path{setup.layout}.filename().string()},
                              {"behavior", behavior.filename().string()},
                              {"commit", commit()}});
  if (auto done = attachFolder(setup.paths.config, "config", log); !done) return done;
  if (auto done = attachFolder(setup.paths.motions, "motions", log); !done) return done;
  const fs::path folder = behavior.has_parent_path() ? behavior.parent_path() : fs::path{"."};
  if (auto done = attachFolder(folder, "behavior", log); !done) return done;
  return attachFile(setup.layout, "robot.layout", log);
}

Result<RobotSetup> readSetup(const McapReader& log, const std::string& file,
                             const RobotModules& modules) {
  const auto& all = log.metadata();
  const auto metadata = std::find_if(
      all.begin(), all.end(), [](const McapReader::Metadata& m) { return m.name == metadataName; });
  if (metadata == all.end())
    return Error{file, 0, metadataName, "the log does not tell how its robot was made"};
  RobotSetup setup;
  const auto agents = readRobot(metadata->entries, setup, file);
  if (!agents) return agents.error();
  const TemporaryFolder folder;
  if (auto done = unpack(log, folder.path(), file); !done) return done.error();
  ConfigurationPaths paths;
  paths.config = (folder.path() / "config").string();
  paths.motions = (folder.path() / "motions").string();
  paths.behavior = (folder.path() / "behavior" / *agents).string();
  auto configuration = loadConfiguration(paths, modules);
  if (!configuration) return configuration.error();
  auto layout = loadLayout((folder.path() / "robot.layout").string());
  if (!layout) return layout.error();
  setup.configuration = std::move(*configuration);
  setup.layout = std::move(*layout);
  return setup;
}

std::string commit() {
  return builtCommit;
}

}  // namespace gt
