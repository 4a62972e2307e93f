#include "robot/Configuration.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/File.h"
#include "base/Lines.h"
#include "base/Suggestion.h"
#include "framework/UnknownNames.h"
#include "network/RobotAddresses.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "robot/Processes.h"
#include "robot/Solutions.h"
#include "robot/TeamSolutions.h"
#include "streams/Config.h"

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
  if (!network.tools.empty())
    if (const auto done = checkEndpoint(network.tools); !done)
      findings.add({.file = path, .field = "tools", .what = done.error().text()});
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
               .what = known ? noSuchSolution(*known, solution) : noSuchTask(table, task)};
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

/// The lines of modules.cfg, or of a team, whose own stand for those of their tasks.
void readAllSolutions(const SolutionTable& table, const ConfigFolder& files,
                      std::vector<Configuration::SolutionChoice>& choices, Findings& findings) {
  readSolutions(table, files.path("modules.cfg"), choices, findings);
  std::vector<Configuration::SolutionChoice> team;
  readSolutions(table, files.path(teamSolutions), team, findings);
  layOver(choices, team);
}

/// Whether a robot can have a representation of that name: where modules are not linked into this
/// program, another one knows it.
bool isKnown(const RobotModules& modules, const std::string& name) {
  const auto named = [&](const RepresentationType* type) { return type->name == name; };
  const auto holds = [&](const auto& list) { return std::any_of(list.begin(), list.end(), named); };
  return holds(platformRepresentations()) || holds(modules.given()) ||
         std::any_of(modules.solutions.tasks().begin(), modules.solutions.tasks().end(),
                     [&](const auto& task) {
                       return task.second.solutions.empty() || holds(task.second.outputs);
                     });
}

std::vector<std::string> knownRepresentations(const RobotModules& modules) {
  std::vector<std::string> names;
  const auto add = [&](const auto& types) {
    for (const RepresentationType* type : types) names.emplace_back(type->name);
  };
  add(platformRepresentations());
  add(modules.given());
  for (const auto& [name, task] : modules.solutions.tasks()) add(task.outputs);
  return names;
}

/// log.cfg: lines `representation NAME` and `pictures MS`.
void readLog(const RobotModules& modules, const std::string& path, Configuration::LogSettings& log,
             Findings& findings) {
  constexpr const char* expected = "expected: representation NAME, or: pictures MS";
  log.file = path;
  readPairs(path, expected, findings,
            [&](const std::string& what, const std::string& value, int line) -> Result<void> {
              const auto wrong = [&](const std::string& field, std::string text) {
                return Error{.file = path, .line = line, .field = field, .what = std::move(text)};
              };
              if (what == "representation") {
                if (!isKnown(modules, value))
                  return wrong(value, "there is no such representation" +
                                          suggestion(value, knownRepresentations(modules)));
                log.representations.push_back(value);
                log.lines[value] = line;
                return {};
              }
              if (what != "pictures") return wrong(what, expected);
              const Range range{0, 1e9};
              if (!setScalar(valueOf(log.imagePeriod), value, range))
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

/// Reads a part from its file, which may have sections for single robots.
template <typename T>
void readPerRobot(const ConfigurationPart& part, Configuration& configuration, Findings& findings) {
  readOptional(configuration.files.folder.path(part.file), configuration.perRobot<T>(), findings);
}

template <typename T>
void shareOwn(const Configuration& configuration, const std::string& address,
              Blackboard& blackboard) {
  blackboard.get<T>() = configuration.of<T>(address);
}

/// The text of a part's file in the config format.
template <typename T>
std::string configText(const void* value) {
  return writeConfig(*static_cast<const T*>(value));
}

Result<ConfigFolder> openFolder(const ConfigurationPaths& paths) {
  if (paths.location.empty()) return ConfigFolder::open(paths.config);
  return ConfigFolder{paths.config, paths.location};
}

bool contains(const std::vector<const RepresentationType*>& types, const RepresentationType* type) {
  return std::ranges::find(types, type) != types.end();
}

/// Reads everything, and goes on after errors.
std::shared_ptr<Configuration> read(const ConfigurationPaths& paths, const RobotModules& modules,
                                    const std::vector<const RepresentationType*>* wanted,
                                    Findings& findings) {
  auto configuration = std::make_shared<Configuration>();
  Configuration& c = *configuration;
  auto folder = openFolder(paths);
  if (!folder) {
    findings.add(folder.error());
    return configuration;
  }
  c.files = {paths, std::move(*folder)};
  for (const ConfigurationPart& part : modules.parts) {
    if (wanted && !contains(*wanted, part.type)) continue;
    part.read(part, c, findings);
    c.parts.push_back(&part);
  }
  const ConfigFolder& files = c.files.folder;
  readAllSolutions(modules.solutions, files, c.solutions, findings);
  readLog(modules, files.path("log.cfg"), c.log, findings);
  readParameters(modules.solutions, files, c.parameters, findings);
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

const std::vector<ConfigurationPart>& commonParts() {
  static const std::vector<ConfigurationPart> parts{{.type = &representation<FieldDimensions>(),
                                                     .file = "field.cfg",
                                                     .read = readPart<FieldDimensions>,
                                                     .text = configText<FieldDimensions>},
                                                    {.type = &representation<RobotDimensions>(),
                                                     .file = "dimensions.cfg",
                                                     .read = readPart<RobotDimensions>,
                                                     .text = configText<RobotDimensions>},
                                                    {.type = &representation<RobotCalibration>(),
                                                     .file = "robot.cfg",
                                                     .read = readPerRobot<RobotCalibration>,
                                                     .share = shareOwn<RobotCalibration>,
                                                     .text = configText<RobotCalibration>},
                                                    {.type = &representation<CameraSettings>(),
                                                     .file = "camera.cfg",
                                                     .read = readPerRobot<CameraSettings>,
                                                     .share = shareOwn<CameraSettings>,
                                                     .text = configText<CameraSettings>}};
  return parts;
}

Error Configuration::LogSettings::missing(const std::string& representation) const {
  const auto line = lines.find(representation);
  return {.file = file,
          .line = line == lines.end() ? 0 : line->second,
          .field = representation,
          .what = "no process of the robot's layout has it"};
}

void Configuration::share(Blackboard& blackboard, const std::string& address) const {
  for (const ConfigurationPart* part : parts) share(*part, blackboard, address);
}

void Configuration::share(const ConfigurationPart& part, Blackboard& blackboard,
                          const std::string& address) const {
  if (part.share)
    part.share(*this, address, blackboard);
  else if (const auto value = values_.find(part.type); value != values_.end())
    blackboard.share(*part.type, value->second);
}

Result<std::shared_ptr<const Configuration>> loadConfiguration(
    const ConfigurationPaths& paths, const RobotModules& modules,
    const std::vector<const RepresentationType*>* wanted) {
  Findings findings;
  auto configuration = read(paths, modules, wanted, findings);
  if (auto done = findings.firstError(); !done) return done.error();
  return std::shared_ptr<const Configuration>{std::move(configuration)};
}

Findings checkConfiguration(const ConfigurationPaths& paths, const RobotModules& modules,
                            std::shared_ptr<const Configuration>* configuration) {
  Findings findings;
  const auto found = read(paths, modules, nullptr, findings);
  for (const Configuration::ParameterFile& file : found->parameters) {
    const Task* task = modules.solutions.find(file.task);
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
