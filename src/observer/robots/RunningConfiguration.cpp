#include "observer/robots/RunningConfiguration.h"

#include <algorithm>
#include <filesystem>

#include "base/File.h"
#include "base/Lines.h"
#include "representations/perception/LearnedCalibration.h"
#include "robot/Configuration.h"
#include "robot/Solutions.h"
#include "streams/Config.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Parameters of one solution as a file of the folder modules/.
std::string parameterText(const SolutionDescription& solution) {
  std::string text;
  for (const ParameterDescription& parameter : solution.parameters)
    text += parameter.path + " " + parameter.value +
            (parameter.doc.empty() ? "" : "  // " + parameter.doc) + "\n";
  return text;
}

Result<void> saveModules(ObservedRobot& robot, const fs::path& folder) {
  const auto processes = robot.processes();
  if (!processes) return processes.error();
  std::string choices;
  for (const ProcessDescription& process : **processes)
    for (const TaskDescription& task : process.tasks) {
      choices += task.name + " " + task.active + "\n";
      for (const SolutionDescription& solution : task.solutions) {
        if (solution.name != task.active || solution.parameters.empty()) continue;
        const fs::path file = folder / "modules" / (task.name + "." + solution.name + ".cfg");
        if (auto done = writeFile(file.string(), parameterText(solution)); !done) return done;
      }
    }
  return writeFile((folder / "modules.cfg").string(), choices);
}

/// A file that is not needed is removed: it would be read.
Result<void> savePart(ObservedRobot& robot, const ConfigurationPart& part, const fs::path& folder) {
  const std::string name{part.type->name};
  const auto& known = robot.representations();
  if (!part.text || !std::ranges::binary_search(known, name)) return {};
  const auto value = robot.value(name);
  if (!value) return value.error();
  const std::string text = part.text(value->data());
  const fs::path file = folder / part.file;
  if (!text.empty()) return writeFile(file.string(), text);
  std::error_code failure;
  fs::remove(file, failure);
  if (failure) return Error{.file = file.string(), .what = failure.message()};
  return {};
}

/// What a robot has learned of itself replaces what it began with.
Result<void> saveLearned(ObservedRobot& robot, const fs::path& folder) {
  const std::string name{representation<LearnedCalibration>().name};
  if (!std::ranges::binary_search(robot.representations(), name)) return {};
  const auto value = robot.value(name);
  if (!value) return value.error();
  const auto& learned = *static_cast<const LearnedCalibration*>(value->data());
  if (learned.deviation == RobotCalibration{}) return {};
  return writeFile((folder / "robot.cfg").string(), writeConfig(learned.robot));
}

/// Sets a solution's parameters line by line, as in a file of the folder modules/.
Result<void> loadParameters(ObservedRobot& robot, const Configuration::ParameterFile& file) {
  const std::string solution = file.task + "." + file.solution + ".";
  std::string section;
  for (const Line& line : linesOf(file.text)) {
    if (line.text.starts_with('[')) {
      section = std::string{trimmed(line.text.substr(1, line.text.find(']') - 1))} + ".";
      continue;
    }
    const std::size_t end = std::min(line.text.find_first_of(" \t="), line.text.size());
    const std::string name{line.text.substr(0, end)};
    std::string_view value = trimmed(line.text.substr(end));
    if (value.starts_with('=')) value = trimmed(value.substr(1));
    if (const auto done = robot.set(solution + section + name, std::string{value}); !done)
      return Error{
          .file = file.path, .line = line.number, .field = name, .what = done.error().what};
  }
  return {};
}

Result<void> loadModules(ObservedRobot& robot, const Configuration& configuration) {
  for (const Configuration::SolutionChoice& choice : configuration.solutions)
    if (auto done = robot.request(SolutionRequest{choice.task, choice.solution}); !done)
      return Error{.file = choice.file, .line = choice.line, .what = done.error().text()};
  for (const Configuration::ParameterFile& file : configuration.parameters)
    if (auto done = loadParameters(robot, file); !done) return done;
  return {};
}

/// What a tool sends replaces the robot's own.
Result<void> loadParts(ObservedRobot& robot, const Configuration& configuration,
                       const std::string& address) {
  Blackboard blackboard;
  for (const ConfigurationPart* part : configuration.parts) {
    if (!part->text || !fs::exists(configuration.files.folder.path(part->file))) continue;
    configuration.share(*part, blackboard, address);
    const void* value = blackboard.get(*part->type);
    if (part->text(value).empty()) continue;
    if (auto done = robot.send(*part->type, value); !done) return done;
  }
  return {};
}

}  // namespace

Result<void> saveRunningConfiguration(ObservedRobot& robot, const std::string& folder) {
  std::error_code failure;
  fs::create_directories(fs::path{folder} / "modules", failure);
  if (failure) return Error{.file = folder, .what = failure.message()};
  if (auto done = saveModules(robot, folder); !done) return done;
  for (const ConfigurationPart& part : allModules().parts)
    if (auto done = savePart(robot, part, folder); !done) return done;
  return saveLearned(robot, folder);
}

Result<void> loadRunningConfiguration(ObservedRobot& robot, const std::string& folder,
                                      const DataRoot& root) {
  ConfigurationPaths paths = ConfigurationPaths::in(root);
  paths.config = folder;
  const auto own = ConfigFolder::open(folder);
  if (!own) return own.error();
  if (!fs::exists(own->path("coltable.c64")) && !fs::exists(own->path("coltable.hsi")))
    paths.colorTable = root.path("config/coltable.c64");
  const auto loaded = loadConfiguration(paths);
  if (!loaded) return loaded.error();
  if (auto done = loadModules(robot, **loaded); !done) return done;
  const auto setup = robot.setup();
  return loadParts(robot, **loaded, setup ? setup->address : std::string{});
}

}  // namespace gt
