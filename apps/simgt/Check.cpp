#include "Check.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/File.h"
#include "console/Console.h"
#include "framework/LayoutCheck.h"
#include "match/teams/TeamFolder.h"
#include "representations/behavior/HeadControlMode.h"
#include "robot/CalibratedFiles.h"
#include "robot/Robot.h"
#include "robot/Solutions.h"
#include "robot/replay/LogPlatform.h"
#include "simulation/scene/SceneModel.h"

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

  /// Returns what was found, sorted by file and line.
  Findings check() {
    checkConfigurations();
    checkTeams();
    checkLayouts();
    checkScenes();
    checkLogs();
    findings_.add(checkCalibratedFiles(root_));
    findings_.sort();
    return findings_;
  }
  /// How many there were of what.
  const std::map<std::string, int>& counts() const { return counts_; }

 private:
  std::string path(const std::string& name) const {
    return root_ == "." ? name : (fs::path{root_} / name).lexically_normal().string();
  }

  /// The files of a folder with an extension, in order; a folder without any is an error.
  template <typename Iterator = fs::directory_iterator>
  std::vector<std::string> files(const std::string& folder, const std::string& extension) {
    std::vector<std::string> found;
    std::error_code failed;
    for (const auto& entry : Iterator{path(folder), failed})
      if (entry.path().extension() == extension) found.push_back(entry.path().string());
    if (root_ == ".")
      for (std::string& file : found) file = fs::path{file}.lexically_normal().string();
    std::sort(found.begin(), found.end());
    if (found.empty())
      findings_.add({.file = path(folder), .what = "there is no folder with files *" + extension});
    return found;
  }

  /// The configuration as it is chosen, with each behavior; then each location's.
  void checkConfigurations() {
    const std::string config = path("config");
    counts_["motions"] =
        static_cast<int>(files<fs::recursive_directory_iterator>("motions", ".mof").size());
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
    std::shared_ptr<const Configuration> configuration;
    findings_.add(gt::checkConfiguration(paths, allModules(), &configuration));
    logs_.push_back(configuration->log);
  }

  /// What each team of the folder teams plays with. Errors of the project's own files are found
  /// once.
  void checkTeams() {
    std::error_code failed;
    for (const auto& entry : fs::directory_iterator{path("teams"), failed}) {
      if (!entry.is_directory()) continue;
      ++counts_["teams"];
      ConfigurationPaths paths;
      paths.config = path("config");
      paths.motions = path("motions");
      paths.behavior = path("behavior/GT2003.xabsl");
      const auto team = TeamFolder::open(entry.path().string(), paths);
      if (!team) {
        findings_.add(team.error());
        continue;
      }
      const Findings found = gt::checkConfiguration((*team)->paths(), allModules());
      for (const Error& finding : found.list()) findings_.add((*team)->named(finding));
    }
  }

  void checkLayouts() {
    for (const std::string& file : files("layouts", ".layout")) checkLayout(file);
  }

  void checkLayout(const std::string& file) {
    if (!layouts_.insert(fs::weakly_canonical(file)).second) return;
    ++counts_["layouts"];
    const auto text = readFile(file);
    if (!text) return findings_.add(text.error());
    // A robot on a log gets from it what others work out for themselves.
    const auto check = [&](const std::vector<const RepresentationType*>& platform) {
      return checkLayoutText(*text, file, solutions(), platform, allModules().given());
    };
    Findings findings = check(platformRepresentations());
    if (findings.empty())
      plans_.push_back(*robotPlan(*parseLayout(*text, file), platformRepresentations()));
    else if (!check(LogPlatform::representations()).empty())
      findings_.add(std::move(findings));
  }

  /// Whether a robot with a layout decides by BehaviorControl; one that does not has a team's
  /// configuration of its own.
  static bool decides(const Plan& plan) { return plan.has(representation<HeadControlMode>().name); }

  /// What is recorded must be there in every such layout, since each may be played with each
  /// configuration.
  void checkLogs() {
    for (const Configuration::LogSettings& log : logs_)
      for (const auto& plan : plans_)
        for (const std::string& name : log.representations)
          if (!plan.has(name) && decides(plan)) {
            Error missing = log.missing(name);
            missing.what += " in " + plan.file;
            findings_.add(std::move(missing));
          }
  }

  void checkScenes() {
    for (const std::string& file : files("scenes", ".scene")) {
      ++counts_["scenes"];
      std::vector<Error> errors;
      const SceneDescription scene = loadScene(file, errors);
      if (!scene.file.empty()) {
        if (errors.empty()) checkModel(scene, errors);
        findSceneFiles(scene, errors);
      }
      findings_.add(errors);
      if (scene.file.empty()) continue;  // it is no scene at all
      for (const SceneRobot& robot : scene.robots)
        if (const std::string layout = scene.resolve(robot.layout); fs::exists(layout))
          checkLayout(layout);
    }
  }

  std::string root_;
  Findings findings_;
  std::map<std::string, int> counts_;
  std::set<fs::path> layouts_;
  std::vector<Plan> plans_;
  std::vector<Configuration::LogSettings> logs_;
};

}  // namespace

int checkTree(const CheckOptions& options) {
  if (!fs::is_directory(options.root)) {
    fmt::print(stderr, "simgt: {}: is not a folder\n", options.root);
    return 2;
  }
  if (!options.fits.empty()) {
    const auto kept = keepCalibratedFile(options.root, options.fits);
    if (!kept) fmt::print(stderr, "simgt: {}\n", kept.error().text());
    return kept ? 0 : 2;
  }
  TreeCheck tree{options.root};
  const Findings findings = tree.check();
  for (const Error& finding : findings.list()) fmt::print(stderr, "simgt: {}\n", finding.text());
  if (findings.fail(options.strict)) return 2;
  fmt::print("All checks passed:");
  for (const auto& [what, count] : tree.counts()) fmt::print(" {} {}", count, what);
  if (findings.warnings() > 0) fmt::print(" {} warnings", findings.warnings());
  fmt::print("\n");
  return 0;
}

}  // namespace gt
