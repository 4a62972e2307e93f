#include "Check.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "framework/LayoutCheck.h"
#include "robot/Robot.h"
#include "robot/Solutions.h"
#include "robot/logs/LogPlatform.h"
#include "simulation/scene/SceneModel.h"
#include "streams/File.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Whether a line of the file begins with `agent`; other files are included by such.
bool isAgentsFile(const std::string& file) {
  const auto text = readFile(file);
  return text && (text->starts_with("agent ") || text->find("\nagent ") != text->npos);
}

/// Looks through a tree and collects what is wrong.
class TreeCheck {
 public:
  explicit TreeCheck(std::string root) : root_{std::move(root)} {}

  void check() {
    checkConfigurations();
    checkLayouts();
    checkScenes();
  }
  /// Sorted by file and line, each once.
  std::vector<Error> errors() const {
    const auto key = [](const Error& e) { return std::tie(e.file, e.line, e.field, e.what); };
    std::vector<Error> sorted = errors_;
    std::sort(sorted.begin(), sorted.end(),
              [&](const Error& a, const Error& b) { return key(a) < key(b); });
    sorted.erase(std::unique(sorted.begin(), sorted.end(),
                             [&](const Error& a, const Error& b) { return key(a) == key(b); }),
                 sorted.end());
    return sorted;
  }
  /// How many there were of what.
  const std::map<std::string, int>& counts() const { return counts_; }

 private:
  std::string path(const std::string& name) const {
    return root_ == "." ? name : (fs::path{root_} / name).lexically_normal().string();
  }

  void collect(const Error& error) { errors_.push_back(error); }
  template <typename T>
  void collect(const Result<T>& result) {
    if (!result) errors_.push_back(result.error());
  }

  /// The files of a folder with an extension, in order; a folder without any is an error.
  std::vector<std::string> files(const std::string& folder, const std::string& extension) {
    std::vector<std::string> found;
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator{path(folder), failed})
      if (entry.path().extension() == extension) found.push_back(entry.path().string());
    if (root_ == ".")
      for (std::string& file : found) file = fs::path{file}.lexically_normal().string();
    std::sort(found.begin(), found.end());
    if (found.empty())
      collect({path(folder), 0, "", "there is no folder with files *" + extension});
    return found;
  }

  /// The configuration as it is chosen, with each behavior; then each location's.
  void checkConfigurations() {
    const std::string config = path("config");
    counts_["motions"] = static_cast<int>(files("motions", ".mof").size());
    for (const std::string& behavior : files("behavior", ".xabsl")) {
      if (!isAgentsFile(behavior)) continue;
      ++counts_["behaviors"];
      checkConfiguration(config, behavior, "");
    }
    ++counts_["configurations"];
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator{config, failed}) {
      if (!entry.is_directory() || entry.path().filename() == "modules") continue;
      ++counts_["configurations"];
      checkConfiguration(config, path("behavior/GT2003.xabsl"), entry.path().filename().string());
    }
  }

  void checkConfiguration(const std::string& config, const std::string& behavior,
                          const std::string& location) {
    ConfigurationPaths paths;
    paths.config = config;
    paths.motions = path("motions");
    paths.behavior = behavior;
    paths.location = location;
    for (const Error& error : gt::checkConfiguration(paths, solutions())) collect(error);
  }

  void checkLayouts() {
    for (const std::string& file : files("layouts", ".layout")) checkLayout(file);
  }

  void checkLayout(const std::string& file) {
    if (!layouts_.insert(fs::weakly_canonical(file)).second) return;
    ++counts_["layouts"];
    const auto text = readFile(file);
    if (!text) return collect(text.error());
    // A robot on a log gets from it what others work out for themselves.
    const auto errorsOn = [&](const std::vector<const RepresentationType*>& platform) {
      return checkLayoutText(*text, file, solutions(), platform, givenRepresentations());
    };
    const std::vector<Error> errors = errorsOn(platformRepresentations());
    if (!errors.empty() && !errorsOn(LogPlatform::representations()).empty())
      errors_.insert(errors_.end(), errors.begin(), errors.end());
  }

  void checkScenes() {
    for (const std::string& file : files("scenes", ".scene")) {
      ++counts_["scenes"];
      const std::size_t before = errors_.size();
      const SceneDescription scene = loadScene(file, errors_);
      if (scene.file.empty()) continue;  // it is no scene at all
      if (errors_.size() == before) checkModel(scene, errors_);
      for (const SceneRobot& robot : scene.robots) checkLayout(scene.resolve(robot.layout));
      if (!fs::is_directory(scene.resolve(scene.config)))
        collect({file, 0, "config", "there is no folder " + scene.config});
      if (!scene.script.empty() && !fs::is_regular_file(scene.resolve(scene.script)))
        collect({file, 0, "script", "there is no file " + scene.script});
    }
  }

  std::string root_;
  std::vector<Error> errors_;
  std::map<std::string, int> counts_;
  std::set<fs::path> layouts_;
};

}  // namespace

int checkTree(const CheckOptions& options) {
  if (!fs::is_directory(options.root)) {
    fmt::print(stderr, "simgt: {}: is not a folder\n", options.root);
    return 2;
  }
  TreeCheck tree{options.root};
  tree.check();
  const std::vector<Error> errors = tree.errors();
  for (const Error& error : errors) fmt::print(stderr, "simgt: {}\n", error.text());
  if (!errors.empty()) return 2;
  fmt::print("Checked, all is sound:");
  for (const auto& [what, count] : tree.counts()) fmt::print(" {} {}", count, what);
  fmt::print("\n");
  return 0;
}

}  // namespace gt
