#include "robot/SetupFiles.h"

#include <algorithm>
#include <filesystem>

#include "base/File.h"
#include "base/TemporaryFolder.h"
#include "robot/Commit.h"
#include "robot/FileNames.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Files beyond this are no configuration.
constexpr std::uintmax_t largestFile = 4u << 20;

Result<void> addFile(const fs::path& file, const std::string& name, RecordedSetup& setup) {
  const auto content = readFile(file.string());
  if (!content) return content.error();
  setup.files.push_back({name, {content->begin(), content->end()}});
  return {};
}

Result<void> addFolder(const fs::path& folder, const std::string& name, RecordedSetup& setup) {
  std::error_code failure;
  std::vector<fs::path> files;
  for (fs::recursive_directory_iterator at{folder, failure}, end; !failure && at != end;
       at.increment(failure))
    if (at->is_regular_file() && at->file_size() <= largestFile) files.push_back(at->path());
  if (failure) return Error{.file = folder.string(), .what = failure.message()};
  std::sort(files.begin(), files.end());
  // By their names alone: a team's folder links to files that lie elsewhere.
  for (const fs::path& file : files) {
    const std::string within = file.lexically_relative(folder).generic_string();
    if (auto done = addFile(file, name + "/" + within, setup); !done) return done;
  }
  return {};
}

Result<void> unpack(const RecordedSetup& setup, const fs::path& folder) {
  if (folder.empty()) return Error{.what = "there is no temporary folder"};
  for (const SetupFile& file : setup.files) {
    const fs::path path = folder / file.name;
    std::error_code failure;
    fs::create_directories(path.parent_path(), failure);
    if (auto done = writeFile(path.string(), {reinterpret_cast<const char*>(file.content.data()),
                                              file.content.size()});
        !done)
      return done;
  }
  return {};
}

/// The name that an unpacked file has in the log; the same of any other file.
std::string nameInLog(const std::string& file, const fs::path& folder) {
  const fs::path within = fs::path{file}.lexically_relative(folder);
  return within.empty() || *within.begin() == ".." ? file : within.generic_string();
}

Error named(const Error& error, const fs::path& folder) {
  return withFileNames(error, folder,
                       [&](const std::string& file) { return nameInLog(file, folder); });
}

/// What is wrong with a configuration may be found when a robot is made of it.
std::shared_ptr<const Configuration> named(const Configuration& unpacked, const fs::path& folder) {
  auto configuration = std::make_shared<Configuration>(unpacked);
  for (Configuration::SolutionChoice& choice : configuration->solutions)
    choice.file = nameInLog(choice.file, folder);
  for (Configuration::ParameterFile& file : configuration->parameters)
    file.path = nameInLog(file.path, folder);
  configuration->log.file = nameInLog(configuration->log.file, folder);
  return configuration;
}

}  // namespace

Result<RecordedSetup> recordSetup(const SetupFiles& files) {
  const fs::path behavior{files.paths.behavior};
  RecordedSetup setup{files.player,
                      files.address,
                      files.seed,
                      fs::path{files.layout}.filename().string(),
                      behavior.filename().string(),
                      commit(),
                      {}};
  const fs::path folder = behavior.has_parent_path() ? behavior.parent_path() : fs::path{"."};
  if (auto done = addFolder(files.paths.config, "config", setup); !done) return done.error();
  if (auto done = addFolder(files.paths.motions, "motions", setup); !done) return done.error();
  if (auto done = addFolder(folder, "behavior", setup); !done) return done.error();
  if (auto done = addFile(files.layout, "robot.layout", setup); !done) return done.error();
  return setup;
}

Result<RobotSetup> readSetup(const RecordedSetup& recorded, const RobotModules& modules) {
  const TemporaryFolder folder;
  if (auto done = unpack(recorded, folder.path()); !done) return done.error();
  ConfigurationPaths paths;
  paths.config = (folder.path() / "config").string();
  paths.motions = (folder.path() / "motions").string();
  paths.behavior = (folder.path() / "behavior" / recorded.behavior).string();
  auto configuration = loadConfiguration(paths, modules);
  if (!configuration) return named(configuration.error(), folder.path());
  auto layout = loadLayout((folder.path() / "robot.layout").string());
  if (!layout) return named(layout.error(), folder.path());
  RobotSetup setup;
  setup.configuration = named(**configuration, folder.path());
  setup.layout = std::move(*layout);
  setup.player = recorded.player;
  setup.seed = recorded.seed;
  setup.address = recorded.address;
  return setup;
}

std::vector<std::string> perceptsOfImages(const SolutionTable& table) {
  std::vector<std::string> names;
  if (const Task* task = table.find(imageTask))
    for (const RepresentationType* output : task->outputs) names.emplace_back(output->name);
  return names;
}

std::string commit() {
  return builtCommit;
}

}  // namespace gt
