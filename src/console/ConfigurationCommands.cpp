#include <filesystem>
#include <sstream>

#include "colors/ColorTableFile.h"
#include "console/Commands.h"
#include "representations/infrastructure/CameraSettings.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/perception/ColorTable64.h"
#include "robot/Configuration.h"
#include "streams/Config.h"
#include "streams/File.h"

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

template <typename T>
Result<void> saveValue(ObservedRobot& robot, const fs::path& file) {
  const auto value = robot.value<T>();
  if (!value) return {};  // no process of this robot reads it
  return writeFile(file.string(), writeConfig(**value));
}

/// What a robot works with now, as a folder from which another can be started.
Result<void> save(ObservedRobot& robot, const fs::path& folder) {
  std::error_code failure;
  fs::create_directories(folder / "modules", failure);
  if (failure) return Error{.file = folder.string(), .what = failure.message()};
  if (auto done = saveModules(robot, folder); !done) return done;
  if (auto done = saveValue<FieldDimensions>(robot, folder / "field.cfg"); !done) return done;
  if (auto done = saveValue<RobotDimensions>(robot, folder / "dimensions.cfg"); !done) return done;
  if (auto done = saveValue<CameraSettings>(robot, folder / "camera.cfg"); !done) return done;
  if (const auto table = robot.value<ColorTable64>())
    return writeFile((folder / "coltable.c64").string(), colorTableBytes(**table));
  return {};
}

/// Sets a solution's parameters as a file of the folder modules/ says.
Result<void> loadParameters(ObservedRobot& robot, const Configuration::ParameterFile& file) {
  std::istringstream lines{file.text};
  std::string section;
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    line.erase(std::min({line.find("//"), line.find('#'), line.size()}));
    std::ranges::replace(line, '=', ' ');
    std::istringstream words{line};
    std::string name, value;
    if (!(words >> name)) continue;
    if (name.front() == '[') {
      section = name.substr(1, name.find(']') - 1) + ".";
      continue;
    }
    std::getline(words >> std::ws, value);
    value.erase(value.find_last_not_of(" \t\r") + 1);
    const std::string path = file.task + "." + file.solution + "." + section + name;
    if (const auto done = robot.set(path, value); !done)
      return Error{.file = file.path, .line = number, .field = name, .what = done.error().what};
  }
  return {};
}

/// Has a running robot work with what a folder holds; files that are not there change nothing.
Result<void> load(ObservedRobot& robot, const fs::path& folder, const DataRoot& root) {
  ConfigurationPaths paths = ConfigurationPaths::in(root);
  paths.config = folder.string();
  if (!fs::exists(folder / "coltable.c64")) paths.colorTable = root.path("config/coltable.c64");
  const auto loaded = loadConfiguration(paths);
  if (!loaded) return loaded.error();
  const Configuration& configuration = **loaded;
  for (const Configuration::SolutionChoice& choice : configuration.solutions)
    if (auto done = robot.request(SolutionRequest{choice.task, choice.solution}); !done)
      return Error{.file = choice.file, .line = choice.line, .what = done.error().text()};
  for (const Configuration::ParameterFile& file : configuration.parameters)
    if (auto done = loadParameters(robot, file); !done) return done;
  const auto send = [&](const char* file, const auto& value) -> Result<void> {
    return fs::exists(folder / file) ? robot.send(value) : Result<void>{};
  };
  if (auto done = send("coltable.c64", *configuration.colorTable); !done) return done;
  if (auto done = send("field.cfg", *configuration.field); !done) return done;
  if (auto done = send("dimensions.cfg", *configuration.robot); !done) return done;
  return send("camera.cfg", configuration.camera.of(""));
}

Result<void> config(Console& console, const Words& words) {
  const bool several = console.selected().size() > 1 && words[1] == "save";
  return console.forEachRobot([&](ConsoleRobot& robot) -> Result<void> {
    const fs::path named{words[2]};
    const fs::path folder = named.has_parent_path() ? named : fs::path{"out/configs"} / named;
    if (words[1] == "load") return load(robot.observed(), folder, console.session().options().root);
    const fs::path own = several ? folder / robot.name() : folder;
    if (auto done = save(robot.observed(), own); !done) return done;
    printWritten(console, own.string());
    return {};
  });
}

}  // namespace

std::vector<Command> configurationCommands() {
  return {{Command::Kind::robot, "config", "(save | load) FOLDER",
           "Writes what a robot works with now, or has it work with what was written: solutions, "
           "parameters, color table, settings of the camera, dimensions. The folder lies in "
           "out/configs/ if it is named without a path; a robot can be started with it, too.",
           config, nullptr, true}};
}

}  // namespace gt
