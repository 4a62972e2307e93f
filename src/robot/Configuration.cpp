#include "robot/Configuration.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <sstream>

#include "modules/behavior/GT2003BehaviorControl.h"
#include "modules/perception/ColorTableFile.h"
#include "streams/Config.h"
#include "streams/File.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Reads a config file that may be missing.
template <typename T>
Result<void> readOptional(const fs::path& path, T& value) {
  return fs::exists(path) ? readConfig(path.string(), value) : Result<void>{};
}

Result<void> checkSolution(const SolutionTable& table, const std::string& task,
                           const std::string& solution, const std::string& file, int line,
                           bool disabledAllowed) {
  const Task* known = table.find(task);
  if (known && known->solutions.empty()) return {};  // another program's matter
  if (!known) return Error{file, line, task, "there is no such task"};
  if (!known->find(solution) && !(disabledAllowed && solution == SolutionTable::disabled))
    return Error{file, line, task, "there is no solution '" + solution + "'"};
  return {};
}

/// Reads a file of lines of two words, which may be missing; visit(first, second, line) returns a
/// Result<void>.
template <typename Visit>
Result<void> readPairs(const fs::path& path, const char* expected, Visit&& visit) {
  if (!fs::exists(path)) return {};
  const auto text = readFile(path.string());
  if (!text) return text.error();
  std::istringstream lines{*text};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.resize(std::min({line.size(), line.find("//"), line.find('#')}));
    std::istringstream words{line};
    std::string first, second, more;
    if (!(words >> first)) continue;
    if (!(words >> second) || words >> more) return Error{path.string(), number, first, expected};
    if (auto done = visit(first, second, number); !done) return done;
  }
  return {};
}

/// modules.cfg: lines TASK SOLUTION.
Result<void> readSolutions(const SolutionTable& table, const fs::path& path,
                           std::vector<Configuration::SolutionChoice>& choices) {
  return readPairs(
      path, "expected a task and one solution",
      [&](const std::string& task, const std::string& solution, int line) -> Result<void> {
        if (auto known = checkSolution(table, task, solution, path.string(), line, true); !known)
          return known;
        choices.push_back({task, solution, path.string(), line});
        return {};
      });
}

/// log.cfg: lines `representation NAME` and `pictures MS`.
Result<void> readLog(const fs::path& path, Configuration::LogSettings& log) {
  constexpr const char* expected = "expected: representation NAME, or: pictures MS";
  return readPairs(
      path, expected,
      [&](const std::string& what, const std::string& value, int line) -> Result<void> {
        if (what == "representation") {
          log.representations.push_back(value);
          return {};
        }
        if (what != "pictures") return Error{path.string(), line, what, expected};
        const char* const end = value.data() + value.size();
        const auto [stop, error] = std::from_chars(value.data(), end, log.picturePeriod);
        if (error != std::errc{} || stop != end || log.picturePeriod < 0)
          return Error{path.string(), line, what, "'" + value + "' is not a period in ms"};
        return {};
      });
}

/// modules/TASK.SOLUTION.cfg: the parameters of a solution.
Result<void> readParameters(const SolutionTable& table, const fs::path& folder,
                            std::vector<Configuration::ParameterFile>& files) {
  if (!fs::exists(folder)) return {};
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator{folder}) paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  for (const fs::path& path : paths) {
    const std::string stem = path.stem().string();
    const auto dot = stem.find('.');
    if (path.extension() != ".cfg" || dot == stem.npos)
      return Error{path.string(), 0, stem, "expected a file name TASK.SOLUTION.cfg"};
    const std::string task = stem.substr(0, dot), solution = stem.substr(dot + 1);
    if (auto known = checkSolution(table, task, solution, path.string(), 0, false); !known)
      return known;
    auto text = readFile(path.string());
    if (!text) return text.error();
    files.push_back({task, solution, path.string(), std::move(*text)});
  }
  return {};
}

/// The first error of a compiler or linker.
Result<void> check(const std::vector<xabsl::Diagnostic>& diagnostics) {
  for (const xabsl::Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == xabsl::Diagnostic::Severity::error)
      return Error{diagnostic.file, diagnostic.line, "column " + std::to_string(diagnostic.column),
                   diagnostic.message};
  return {};
}

}  // namespace

Result<Behavior> loadBehavior(const BehaviorRequest& request) {
  xabsl::Compilation compilation =
      request.text.empty() ? xabsl::compile(request.path)
                           : xabsl::compile(request.path, {{request.path, request.text}});
  if (auto done = check(compilation.diagnostics); !done) return done.error();
  // Linking now tells of missing symbols before a robot runs.
  GT2003BehaviorControl control;
  if (auto done =
          check(xabsl::Engine::create(*compilation.behavior, control.symbols()).diagnostics);
      !done)
    return done.error();
  return Behavior{std::move(compilation.behavior)};
}

void Configuration::share(Blackboard& blackboard) const {
  blackboard.share(field);
  blackboard.share(robot);
  blackboard.share(colorTable);
  blackboard.share(motions);
  blackboard.get<Behavior>() = behavior;
}

std::vector<const RepresentationType*> Configuration::representations() {
  return {&representation<FieldDimensions>(), &representation<RobotDimensions>(),
          &representation<ColorTable64>(), &representation<MotionNet>(),
          &representation<Behavior>()};
}

Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths,
                                                               const SolutionTable& table) {
  const fs::path folder{paths.config};
  if (!fs::is_directory(folder)) return Error{paths.config, 0, "", "is not a folder"};
  auto configuration = std::make_shared<Configuration>();
  configuration->field = std::make_shared<FieldDimensions>();
  configuration->robot = std::make_shared<RobotDimensions>();
  if (auto done = readOptional(folder / "field.cfg", *configuration->field); !done)
    return done.error();
  if (auto done = readOptional(folder / "robot.cfg", *configuration->robot); !done)
    return done.error();
  auto colorTable = readColorTable(
      paths.colorTable.empty() ? (folder / "coltable.c64").string() : paths.colorTable,
      paths.colorOrder);
  if (!colorTable) return colorTable.error();
  configuration->colorTable = std::make_shared<ColorTable64>(std::move(*colorTable));
  auto motions = loadMotionNet(paths.motions);
  if (!motions) return motions.error();
  configuration->motions = std::make_shared<MotionNet>(std::move(*motions));
  auto behavior = loadBehavior({paths.behavior, {}});
  if (!behavior) return behavior.error();
  configuration->behavior = std::move(*behavior);
  if (auto done = readSolutions(table, folder / "modules.cfg", configuration->solutions); !done)
    return done.error();
  if (auto done = readLog(folder / "log.cfg", configuration->log); !done) return done.error();
  if (auto done = readParameters(table, folder / "modules", configuration->parameters); !done)
    return done.error();
  return std::shared_ptr<const Configuration>{std::move(configuration)};
}

}  // namespace gt
