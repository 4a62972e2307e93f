#include "robot/Configuration.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/Lines.h"
#include "modules/behavior/control/GT2003BehaviorControl.h"
#include "motionnet/Listing.h"
#include "robot/Processes.h"
#include "streams/Config.h"
#include "streams/File.h"
#include "xabsl/formats/Compile.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

template <typename T>
Findings parse(const std::string& text, const std::string& path, T& value) {
  return collectConfig(text, path, value);
}

template <typename T>
Findings parse(const std::string& text, const std::string& path, PerRobot<T>& value) {
  return collectPerRobot(text, path, value);
}

/// Reads a config file that may be missing.
template <typename T>
void readOptional(const std::string& path, T& value, Findings& findings) {
  if (!fs::exists(path)) return;
  if (const auto text = readFile(path))
    findings.add(parse(*text, path, value));
  else
    findings.add(text.error());
}

void readNetwork(const std::string& path, NetworkSettings& network, Findings& findings) {
  readOptional(path, network, findings);
  if (!network.address.empty() && !isHardwareAddress(network.address))
    findings.add({.file = path, .field = "address", .what = "expected 12 digits, as 00022D1F626B"});
}

Result<void> checkSolution(const SolutionTable& table, const std::string& task,
                           const std::string& solution, const std::string& file, int line,
                           bool disabledAllowed) {
  const Task* known = table.find(task);
  const bool isOthers = known && known->solutions.empty();  // another program solves the task
  if (isOthers || (known && known->find(solution)) ||
      (known && disabledAllowed && solution == SolutionTable::disabled))
    return {};
  return Error{.file = file,
               .line = line,
               .field = task,
               .what = known ? "there is no solution '" + solution + "'" : "there is no such task"};
}

/// Reads a file of lines of two words, which may be missing; visit(first, second, line) returns a
/// Result<void>.
template <typename Visit>
void readPairs(const std::string& path, const char* expected, Findings& findings, Visit&& visit) {
  if (!fs::exists(path)) return;
  const auto text = readFile(path);
  if (!text) return findings.add(text.error());
  for (const Line& line : linesOf(*text)) {
    const auto words = wordsOf(line.text);
    if (!words || words->size() != 2)
      findings.add({.file = path,
                    .line = line.number,
                    .field = words ? words->front().text : std::string{line.text},
                    .what = words ? expected : words.error().what});
    else
      findings.add(visit((*words)[0].text, (*words)[1].text, line.number));
  }
}

/// modules.cfg: lines TASK SOLUTION.
void readSolutions(const SolutionTable& table, const std::string& path,
                   std::vector<Configuration::SolutionChoice>& choices, Findings& findings) {
  readPairs(path, "expected a task and one solution", findings,
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
             Findings& findings) {
  constexpr const char* expected = "expected: representation NAME, or: pictures MS";
  log.file = path;
  readPairs(path, expected, findings,
            [&](const std::string& what, const std::string& value, int line) -> Result<void> {
              const auto wrong = [&](const std::string& field, std::string text) {
                return Error{.file = path, .line = line, .field = field, .what = std::move(text)};
              };
              if (what == "representation") {
                if (!isKnown(table, value)) return wrong(value, "there is no such representation");
                log.representations.push_back(value);
                log.lines[value] = line;
                return {};
              }
              if (what != "pictures") return wrong(what, expected);
              const Range range{0, 1e9};
              if (!setScalar(valueOf(log.picturePeriod), value, range))
                return wrong(what, "'" + value + "' is not a period in ms");
              return {};
            });
}

/// modules/TASK.SOLUTION.cfg: the parameters of a solution.
Result<void> readParameterFile(const SolutionTable& table, const fs::path& path,
                               std::vector<Configuration::ParameterFile>& files) {
  const std::string stem = path.stem().string();
  const auto dot = stem.find('.');
  if (path.extension() != ".cfg" || dot == stem.npos)
    return Error{
        .file = path.string(), .field = stem, .what = "expected a file name TASK.SOLUTION.cfg"};
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
                    std::vector<Configuration::ParameterFile>& files, Findings& findings) {
  std::set<std::string> names;
  for (const std::string& modules : folder.paths("modules")) {
    if (!fs::is_directory(modules)) continue;
    for (const auto& entry : fs::directory_iterator{modules})
      names.insert(entry.path().filename().string());
  }
  for (const std::string& name : names)
    findings.add(readParameterFile(table, folder.path("modules/" + name), files));
}

void add(const std::vector<xabsl::Diagnostic>& diagnostics, Findings& findings) {
  for (const xabsl::Diagnostic& diagnostic : diagnostics) {
    const bool isError = diagnostic.severity == xabsl::Diagnostic::Severity::error;
    findings.add({.file = diagnostic.file,
                  .line = diagnostic.line,
                  .field = "column " + std::to_string(diagnostic.column),
                  .what = diagnostic.message,
                  .severity = isError ? Severity::error : Severity::warning});
  }
}

/// Compiles a behavior, and links it: that finds missing symbols before a robot runs. The file that
/// declares the special actions is made from the motions, whatever the one in the folder says.
Behavior readBehavior(const BehaviorRequest& request, const MotionNet& motions,
                      Findings& findings) {
  xabsl::VirtualFiles files;
  for (const auto& [path, text] : request.files) files[path] = text;
  const xabsl::FileReader read = files.empty() ? xabsl::diskReader() : xabsl::readerOf(files);
  const bool motionsFailed = motions.motions.empty();
  std::vector<std::string> names;
  for (std::size_t i = 1; i < motions.motions.size(); ++i) names.push_back(motions.motions[i].name);
  xabsl::Compilation compilation = xabsl::compile(
      request.path, [&](const std::string& path, std::string& text) -> std::optional<std::string> {
        if (motionsFailed || fs::path{path}.filename() != "special_actions.xabsl")
          return read(path, text);
        text = motionnet::listing(names);
        return std::nullopt;
      });
  const std::size_t before = findings.errors();
  add(compilation.diagnostics, findings);
  if (findings.errors() > before || motionsFailed) return {};
  GT2003BehaviorControl control;
  add(xabsl::Engine::create(*compilation.behavior, control.symbols(motions)).diagnostics, findings);
  return Behavior{std::move(compilation.behavior)};
}

void readMotions(const std::string& folder, MotionNet& motions, Findings& findings) {
  const auto compilation = motionnet::compileFolder(folder, motionRules());
  for (const motionnet::Diagnostic& error : compilation.errors)
    findings.add(
        {.file = error.file, .line = error.line, .field = error.field, .what = error.message});
  if (!compilation) return;
  auto net = motionNetOf(compilation.net, folder);
  if (net)
    motions = std::move(*net);
  else
    findings.add(net.error());
}

void readTsl(const std::string& file, TslColors& colors, Findings& findings) {
  auto read = readTslColors(file);
  if (read)
    colors = std::move(*read);
  else
    findings.add(read.error());
}

Result<ConfigFolder> openFolder(const ConfigurationPaths& paths) {
  if (paths.location.empty()) return ConfigFolder::open(paths.config);
  return ConfigFolder{paths.config, paths.location};
}

/// Reads everything, and goes on after errors.
std::shared_ptr<Configuration> read(const ConfigurationPaths& paths, const SolutionTable& table,
                                    Findings& findings) {
  auto configuration = std::make_shared<Configuration>();
  Configuration& c = *configuration;
  const auto folder = openFolder(paths);
  if (!folder) {
    findings.add(folder.error());
    return configuration;
  }
  c.field = std::make_shared<FieldDimensions>();
  c.robot = std::make_shared<RobotDimensions>();
  c.motions = std::make_shared<MotionNet>();
  readOptional(folder->path("field.cfg"), *c.field, findings);
  readOptional(folder->path("dimensions.cfg"), *c.robot, findings);
  readOptional(folder->path("robot.cfg"), c.calibration, findings);
  readOptional(folder->path("camera.cfg"), c.camera, findings);
  auto colorTable = readColorTable(
      paths.colorTable.empty() ? folder->path("coltable.c64") : paths.colorTable, paths.colorOrder);
  if (colorTable)
    c.colorTable = std::make_shared<ColorTable64>(std::move(*colorTable));
  else
    findings.add(colorTable.error());
  c.tslColors = std::make_shared<TslColors>();
  if (const std::string file = folder->path("coltable.tsl"); fs::exists(file))
    readTsl(file, *c.tslColors, findings);
  readMotions(paths.motions, *c.motions, findings);
  c.behavior = readBehavior({paths.behavior, {}}, *c.motions, findings);
  readSolutions(table, folder->path("modules.cfg"), c.solutions, findings);
  readLog(table, folder->path("log.cfg"), c.log, findings);
  readParameters(table, *folder, c.parameters, findings);
  return configuration;
}

/// Whether a solution has the parameters of its file, within their ranges.
void checkParameters(const Solution& solution, const Configuration::ParameterFile& file,
                     Findings& findings) {
  Blackboard blackboard;
  Debug debug;
  const auto module = solution.make({blackboard, debug, Random{0}});
  findings.add(module->configure(file.text, file.path));
}

/// One file of a configuration that may be missing, read by `read`.
template <typename T, typename Read>
Result<T> loadOne(const std::string& folder, const char* file, Read read) {
  const auto opened = ConfigFolder::open(folder);
  if (!opened) return opened.error();
  T value;
  Findings findings;
  read(opened->path(file), value, findings);
  if (auto done = findings.firstError(); !done) return done.error();
  return value;
}

}  // namespace

Result<Behavior> loadBehavior(const BehaviorRequest& request, const MotionNet& motions) {
  Findings findings;
  Behavior behavior = readBehavior(request, motions, findings);
  if (auto done = findings.firstError(); !done) return done.error();
  return behavior;
}

Error Configuration::LogSettings::missing(const std::string& representation) const {
  const auto line = lines.find(representation);
  return {.file = file,
          .line = line == lines.end() ? 0 : line->second,
          .field = representation,
          .what = "no process of the robot's layout has it"};
}

void Configuration::share(Blackboard& blackboard, const std::string& address) const {
  blackboard.share(field);
  blackboard.share(robot);
  blackboard.share(colorTable);
  blackboard.share(tslColors);
  blackboard.share(motions);
  blackboard.get<Behavior>() = behavior;
  blackboard.get<RobotCalibration>() = calibration.of(address);
  blackboard.get<CameraSettings>() = camera.of(address);
}

std::vector<const RepresentationType*> Configuration::representations() {
  return {&representation<FieldDimensions>(),  &representation<RobotDimensions>(),
          &representation<ColorTable64>(),     &representation<TslColors>(),
          &representation<MotionNet>(),        &representation<Behavior>(),
          &representation<RobotCalibration>(), &representation<CameraSettings>()};
}

Result<std::shared_ptr<const Configuration>> loadConfiguration(const ConfigurationPaths& paths,
                                                               const SolutionTable& table) {
  Findings findings;
  auto configuration = read(paths, table, findings);
  if (auto done = findings.firstError(); !done) return done.error();
  return std::shared_ptr<const Configuration>{std::move(configuration)};
}

Findings checkConfiguration(const ConfigurationPaths& paths, const SolutionTable& table,
                            std::shared_ptr<const Configuration>* configuration) {
  Findings findings;
  const auto found = read(paths, table, findings);
  for (const Configuration::ParameterFile& file : found->parameters) {
    const Task* task = table.find(file.task);
    const Solution* solution = task ? task->find(file.solution) : nullptr;
    if (solution) checkParameters(*solution, file, findings);
  }
  if (const auto folder = openFolder(paths)) {
    Player player;
    readOptional(folder->path("player.cfg"), player, findings);
    NetworkSettings network;
    readNetwork(folder->path("network.cfg"), network, findings);
  }
  if (configuration) *configuration = found;
  return findings;
}

Result<Player> loadPlayer(const std::string& configFolder) {
  return loadOne<Player>(configFolder, "player.cfg", readOptional<Player>);
}

Result<NetworkSettings> loadNetwork(const std::string& configFolder) {
  return loadOne<NetworkSettings>(configFolder, "network.cfg", readNetwork);
}

}  // namespace gt
