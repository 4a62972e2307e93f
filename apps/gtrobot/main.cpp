#include <unistd.h>

#include "Process.h"
#include "commandline/CommandLine.h"
#include "crash/CrashHandler.h"
#include "robot/linux/Lockstep.h"
#include "robot/linux/RobotProgram.h"

namespace {

void addOptions(CLI::App& app, gt::RobotProgramOptions& options) {
  app.add_option("--robot", options.addresses.robot, "The robot's name; one for all its processes")
      ->capture_default_str();
  app.add_option("--layout", options.layout, "Process layout; the same for all its processes")
      ->capture_default_str();
  app.add_option("--team", options.player.teamColor, "Color of the team")
      ->transform(CLI::CheckedTransformer(std::map<std::string, gt::TeamColor>{
          {"red", gt::TeamColor::red}, {"blue", gt::TeamColor::blue}}));
  app.add_option("--role", options.player.role, "Role of the player")
      ->transform(CLI::CheckedTransformer(
          std::map<std::string, gt::PlayerRole>{{"goalie", gt::PlayerRole::goalie},
                                                {"defender", gt::PlayerRole::defender},
                                                {"striker1", gt::PlayerRole::striker1},
                                                {"striker2", gt::PlayerRole::striker2}}));
  app.add_option("--address", options.hardwareAddress,
                 "Hardware address for robot.cfg; by default the machine's")
      ->check([](const std::string& text) {
        return gt::isHardwareAddress(text) ? "" : "expected 12 digits, as 00022D1F626B";
      });
  app.add_option("--seed", options.seed, "Of the modules' chance")->capture_default_str();
  app.add_option("--config", options.paths.config, "Folder of the configuration")
      ->capture_default_str();
  app.add_option("--motions", options.paths.motions, "Folder of motion descriptions")
      ->capture_default_str();
  app.add_option("--behavior", options.paths.behavior, "Agents file of the behavior")
      ->capture_default_str();
  app.add_option("--sockets", options.addresses.folder, "Folder of the processes' sockets")
      ->capture_default_str();
  app.add_option("--logs", options.logs, "Folder in which the process Debug records a log")
      ->check(CLI::ExistingDirectory);
  app.add_option("--tools", options.tools,
                 "Where tools and the router connect (process Debug): tcp://127.0.0.1:15001; "
                 "by default a socket in the folder");
}

/// `PROCESS=ENDPOINT`; empty if it is not.
std::pair<std::string, std::string> splitAddress(const std::string& text) {
  const auto at = text.find('=');
  if (at == text.npos || at == 0) return {};
  return {text.substr(0, at), text.substr(at + 1)};
}

/// The words of the command line.
struct Arguments {
  std::vector<std::string> processes;
  std::string keys, connectKeys;
};

/// Takes from player.cfg and network.cfg what the command line does not state.
gt::Result<void> readSettings(const CLI::App& app, gt::RobotProgramOptions& options,
                              Arguments& arguments) {
  const auto player = gt::loadPlayer(options.paths.config);
  if (!player) return player.error();
  const auto network = gt::loadNetwork(options.paths.config);
  if (!network) return network.error();
  const auto take = [&app](const char* option, auto& value, const auto& settings) {
    if (app.count(option) == 0) value = settings;
  };
  take("--team", options.player.teamColor, player->teamColor);
  take("--role", options.player.role, player->role);
  take("--robot", options.addresses.robot, network->robot);
  take("--tools", options.tools, network->tools);
  take("--address", options.hardwareAddress, network->address);
  take("--keys", arguments.keys, network->keys);
  take("--connect-keys", arguments.connectKeys, network->connectKeys);
  take("--at", arguments.processes, network->processes);
  if (options.hardwareAddress.empty()) options.hardwareAddress = gt::machineAddress();
  return {};
}

gt::Result<void> readFiles(const CLI::App& app, gt::RobotProgramOptions& options,
                           Arguments& arguments) {
  if (auto done = readSettings(app, options, arguments); !done) return done;
  for (const std::string& address : arguments.processes) {
    const auto [process, endpoint] = splitAddress(address);
    if (process.empty()) return gt::Error{.field = address, .what = "expected PROCESS=ENDPOINT"};
    options.addresses.elsewhere[process] = endpoint;
  }
  for (auto& [file, keys] : {std::pair{&arguments.keys, &options.listenKeys},
                             std::pair{&arguments.connectKeys, &options.connectKeys}}) {
    if (file->empty()) continue;
    const auto loaded = gt::loadKeys(*file);
    if (!loaded) return loaded.error();
    *keys = *loaded;
  }
  return {};
}

}  // namespace

/// One process of a robot on Linux.
int main(int argc, char** argv) {
  gt::CommandLine line{argc, argv, std::string{"The process "} + gt::processName + " of a robot"};
  const gt::DataRoot root = line.root();
  gt::RobotProgramOptions options;
  options.process = gt::processName;
  options.layout = root.path("layouts/cmd.layout");
  options.paths = gt::ConfigurationPaths::in(root);
  options.addresses.folder = gt::defaultSocketFolder();
  CLI::App& app = line.app();
  addOptions(app, options);
  Arguments arguments;
  app.add_option("--at", arguments.processes,
                 "Where a process listens if not in the folder: Motion=tcp://10.0.1.100:5001; "
                 "Platform is the simulation (simgt play --remote) or the hardware");
  app.add_option("--keys", arguments.keys,
                 "Key file for listening (robot.key of router --make-keys)");
  app.add_option("--connect-keys", arguments.connectKeys, "Key file for connecting (tool.key)");
  bool lockstep = false;
  app.add_flag("--lockstep", lockstep,
               "All of the robot in this program, in lockstep with the simulator that started it "
               "with a socket as its standard input; player.cfg and network.cfg are not read");
  gt::CrashSettings crashes{std::string{"gtrobot-"} + gt::processName};
  app.add_option("--crashes", crashes.folder, "Folder for a crash report, which crashlog reads")
      ->capture_default_str();
  return line.run([&]() -> gt::Result<void> {
    gt::installCrashHandler(crashes);
    if (!lockstep)
      if (auto done = readFiles(app, options, arguments); !done) return done;
    // The configuration names for its parts where in these they are.
    gt::RobotModules modules = gt::tasks();
    gt::addProcessModules(modules);
    if (lockstep) return gt::runInLockstep(options, modules, gt::FileDescriptor{STDIN_FILENO});
    return gt::runRobotProgram(options, modules);
  });
}
