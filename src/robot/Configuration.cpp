#include "robot/Configuration.h"

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <set>
#include <sstream>

#include "modules/behavior/control/GT2003BehaviorControl.h"
#include "robot/Processes.h"
#include "streams/Config.h"
#include "streams/File.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

using Errors = std::vector<Error>;

void collect(Errors& errors, const Result<void>& done) {
  if (!done) errors.push_back(done.error());
}

/// Blanks a line of a text, by its number from 1; with a line [section] all up to the next one.
/// False if there is nothing in it.
bool leaveOut(std::string& text, int line) {
  const auto isSection = [&](std::size_t at) {
    at = text.find_first_not_of(" \t\r", at);
    return at != text.npos && text[at] == '[';
  };
  std::size_t begin = 0;
  for (int number = 1; number < line && begin < text.size(); ++number)
    begin = std::min(text.find('\n', begin), text.size() - 1) + 1;
  if (line < 1 || begin >= text.size()) return false;
  const bool section = isSection(begin);
  bool found = false;
  for (std::size_t at = begin; at < text.size(); ++at) {
    if (text[at] == '\n') {
      if (!section || isSection(at + 1)) break;
    } else {
      found |= text[at] != ' ';
      text[at] = ' ';
    }
  }
  return found;
}

/// Tells all that is wrong with a config file: its lines say different things, so one that is wrong
/// is left out and the others are read again, up to as many errors as a person reads.
template <typename Parse>
void collectAll(Errors& errors, std::string text, Parse parse) {
  for (int most = 100; most > 0; --most) {
    const Result<void> done = parse(std::as_const(text));
    collect(errors, done);
    if (done || !leaveOut(text, done.error().line)) return;
  }
}

template <typename T>
Result<void> parse(const std::string& text, const std::string& path, T& value) {
  return parseConfig(text, path, value);
}

template <typename T>
Result<void> parse(const std::string& text, const std::string& path, PerRobot<T>& value) {
  return parsePerRobot(text, path, value);
}

/// Reads a config file that may be missing.
template <typename T>
void readOptional(const std::string& path, T& value, Errors& errors) {
  if (!fs::exists(path)) return;
  const auto text = readFile(path);
  if (!text) return errors.push_back(text.error());
  collectAll(errors, *text, [&](const std::string& rest) { return parse(rest, path, value); });
}

void readNetwork(const std::string& path, NetworkSettings& network, Errors& errors) {
  readOptional(path, network, errors);
  if (!network.address.empty() && !isHardwareAddress(network.address))
    errors.push_back({path, 0, "address", "expected 12 digits, as 00022D1F626B"});
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
void readPairs(const std::string& path, const char* expected, Errors& errors, Visit&& visit) {
  if (!fs::exists(path)) return;
  const auto text = readFile(path);
  if (!text) return errors.push_back(text.error());
  std::istringstream lines{*text};
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.resize(std::min({line.size(), line.find("//"), line.find('#')}));
    std::istringstream words{line};
    std::string first, second, more;
    if (!(words >> first)) continue;
    if (!(words >> second) || words >> more)
      errors.push_back({path, number, first, expected});
    else
      collect(errors, visit(first, second, number));
  }
}

/// modules.cfg: lines TASK SOLUTION.
void readSolutions(const SolutionTable& table, const std::string& path,
                   std::vector<Configuration::SolutionChoice>& choices, Errors& errors) {
  readPairs(path, "expected a task and one solution", errors,
            [&](const std::string& task, const std::string& solution, int line) -> Result<void> {
              if (auto known = checkSolution(table, task, solution, path, line, true); !known)
                return known;
              choices.push_back({task, solution, path, line});
              return {};
            });
}

/// Whether a robot can have a representation of that name.
bool isKnown(const SolutionTable& table, const std::string& name) {
  const auto named = [&](const RepresentationType* type) { return type->name == name; };
  const auto holds = [&](const auto& list) { return std::any_of(list.begin(), list.end(), named); };
  return holds(platformRepresentations()) || holds(givenRepresentations()) ||
         std::any_of(table.tasks().begin(), table.tasks().end(),
                     [&](const auto& task) { return holds(task.second.outputs); });
}

/// log.cfg: lines `representation NAME` and `pictures MS`.
void readLog(const SolutionTable& table, const std::string& path, Configuration::LogSettings& log,
             Errors& errors) {
  constexpr const char* expected = "expected: representation NAME, or: pictures MS";
  readPairs(path, expected, errors,
            [&](const std::string& what, const std::string& value, int line) -> Result<void> {
              if (what == "representation") {
                if (!isKnown(table, value))
                  return Error{path, line, value, "there is no such representation"};
                log.representations.push_back(value);
                return {};
              }
              if (what != "pictures") return Error{path, line, what, expected};
              const char* const end = value.data() + value.size();
              const auto [stop, error] = std::from_chars(value.data(), end, log.picturePeriod);
              if (error != std::errc{} || stop != end || log.picturePeriod < 0)
                return Error{path, line, what, "'" + value + "' is not a period in ms"};
              return {};
            });
}

/// modules/TASK.SOLUTION.cfg: the parameters of a solution.
Result<void> readParameterFile(const SolutionTable& table, const fs::path& path,
                               std::vector<Configuration::ParameterFile>& files) {
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
  return {};
}

/// The files of the common folder `modules` and of the location's, where those win.
void readParameters(const SolutionTable& table, const ConfigFolder& folder,
                    std::vector<Configuration::ParameterFile>& files, Errors& errors) {
  std::set<std::string> names;
  for (const std::string& modules : folder.paths("modules")) {
    if (!fs::is_directory(modules)) continue;
    for (const auto& entry : fs::directory_iterator{modules})
      names.insert(entry.path().filename().string());
  }
  for (const std::string& name : names)
    collect(errors, readParameterFile(table, folder.path("modules/" + name), files));
}

void add(const std::vector<xabsl::Diagnostic>& diagnostics, Errors& errors) {
  for (const xabsl::Diagnostic& diagnostic : diagnostics)
    if (diagnostic.severity == xabsl::Diagnostic::Severity::error)
      errors.push_back({diagnostic.file, diagnostic.line,
                        "column " + std::to_string(diagnostic.column), diagnostic.message});
}

/// Compiles a behavior, and links it: that tells of missing symbols before a robot runs.
Behavior readBehavior(const BehaviorRequest& request, Errors& errors) {
  xabsl::VirtualFiles files;
  for (const auto& [path, text] : request.files) files[path] = text;
  xabsl::Compilation compilation =
      files.empty() ? xabsl::compile(request.path) : xabsl::compile(request.path, files);
  const std::size_t before = errors.size();
  add(compilation.diagnostics, errors);
  if (errors.size() > before) return {};
  GT2003BehaviorControl control;
  add(xabsl::Engine::create(*compilation.behavior, control.symbols()).diagnostics, errors);
  return Behavior{std::move(compilation.behavior)};
}

void readMotions(const std::string& folder, MotionNet& motions, Errors& errors) {
  const auto compilation = motionnet::compileFolder(folder, motionRules());
  for (const motionnet::Diagnostic& error : compilation.errors)
    errors.push_back({error.file, error.line, error.field, error.message});
  if (!compilation) return;
  auto net = motionNetOf(compilation.net, folder);
  if (net)
    motions = std::move(*net);
  else
    errors.push_back(net.error());
}

void readTsl(const std::string& file, TslColors& colors, Errors& errors) {
  auto read = readTslColors(file);
  if (read)
    colors = std::move(*read);
  else
    errors.push_back(read.error());
}

Result<ConfigFolder> openFolder(const ConfigurationPaths& paths) {
  if (paths.location.empty()) return ConfigFolder::open(paths.config);
  return ConfigFolder{paths.config, paths.location};
}

/// Reads everything, and goes on after errors.
std::shared_ptr<Configuration> read(const ConfigurationPaths& paths, const SolutionTable& table,
                                    Errors& errors) {
  auto configuration = std::make_shared<Configuration>();
  Configuration& c = *configuration;
  const auto folder = openFolder(paths);
  if (!folder) {
    errors.push_back(folder.error());
    return configuration;
  }
  c.field = std::make_shared<FieldDimensions>();
  c.robot = std::make_shared<RobotDimensions>();
  c.motions = std::make_shared<MotionNet>();
  readOptional(folder->path("field.cfg"), *c.field, errors);
  readOptional(folder->path("dimensions.cfg"), *c.robot, errors);
  readOptional(folder->path("robot.cfg"), c.calibration, errors);
  readOptional(folder->path("camera.cfg"), c.camera, errors);
  auto colorTable = readColorTable(
      paths.colorTable.empty() ? folder->path("coltable.c64") : paths.colorTable, paths.colorOrder);
  if (colorTable)
    c.colorTable = std::make_shared<ColorTable64>(std::move(*colorTable));
  else
    errors.push_back(colorTable.error());
  c.tslColors = std::make_shared<TslColors>();
  if (const std::string file = folder->path("coltable.tsl"); fs::exists(file))
    readTsl(file, *c.tslColors, errors);
  readMotions(paths.motions, *c.motions, errors);
  c.behavior = readBehavior({paths.behavior, {}}, errors);
  readSolutions(table, folder->path("modules.cfg"), c.solutions, errors);
  readLog(table, folder->path("log.cfg"), c.log, errors);
  readParameters(table, *folder, c.parameters, errors);
  return configuration;
}

/// Whether a solution has the parameters of its file, within their ranges.
void checkParameters(const Solution& solution, const Configuration::ParameterFile& file,
                     Errors& errors) {
  Blackboard blackboard;
  Debug debug;
  const auto module = solution.make({blackboard, debug, Random{0}});
  collectAll(errors, file.text,
             [&](const std::string& rest) { return module->configure(rest, file.path); });
}

/// One file of a configuration that may be missing, read by `read`.
template <typename T, typename Read>
Result<T> loadOne(const std::string& folder, const char* file, Read read) {
  const auto opened = ConfigFolder::open(folder);
  if (!opened) return opened.error();
  T value;
  Errors errors;
  read(opened->path(file), value, errors);
  if (!errors.empty()) return errors.front();
  return value;
}

}  // namespace

Result<Behavior> loadBehavior(const BehaviorRequest& request) {
  Errors errors;
  Behavior behavior = readBehavior(request, errors);
  if (!errors.empty()) return errors.front();
  return behavior;
}

void Configuration::share(Blackboard& blackboard, const std::string& address) const {
  blackboard.share(field);
  blackboard.share(robot);
  blackboard.share(colorTable);
  blackboard.share(tslColors);
  blackboard.share(motions);
  blackboard.get<Behavior>() = behavior;
  blackboard.get<RobotCalibration>() = calibration.of(address);
}

std::vector<const RepresentationType*> Configuration::representations() {
  return {&representation<FieldDimensions>(), &representation<RobotDimensions>(),
          &representation<ColorTable64>(),    &representation<TslColors>(),
          &representation<MotionNet>(),       &representation<Behavior>(),
          &representation<RobotCalibration>()};
}

Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths,
                                                               const SolutionTable& table) {
  Errors errors;
  auto configuration = read(paths, table, errors);
  if (!errors.empty()) return errors.front();
  return std::shared_ptr<const Configuration>{std::move(configuration)};
}

std::vector<Error> checkConfiguration(const ConfigurationPaths& paths, const SolutionTable& table) {
  Errors errors;
  const auto configuration = read(paths, table, errors);
  for (const Configuration::ParameterFile& file : configuration->parameters) {
    const Task* task = table.find(file.task);
    const Solution* solution = task ? task->find(file.solution) : nullptr;
    if (solution) checkParameters(*solution, file, errors);
  }
  if (const auto folder = openFolder(paths)) {
    Player player;
    readOptional(folder->path("player.cfg"), player, errors);
    NetworkSettings network;
    readNetwork(folder->path("network.cfg"), network, errors);
  }
  return errors;
}

Result<Player> loadPlayer(const std::string& configFolder) {
  return loadOne<Player>(configFolder, "player.cfg", readOptional<Player>);
}

Result<NetworkSettings> loadNetwork(const std::string& configFolder) {
  return loadOne<NetworkSettings>(configFolder, "network.cfg", readNetwork);
}

}  // namespace gt
