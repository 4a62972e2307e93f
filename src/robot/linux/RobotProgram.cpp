#include "robot/linux/RobotProgram.h"

#include <algorithm>
#include <cstdio>
#include <iterator>

#include "base/EndSignals.h"
#include "logs/RobotLog.h"
#include "network/ToolPort.h"
#include "network/Wire.h"
#include "robot/Robot.h"
#include "robot/SetupFiles.h"
#include "robot/linux/ProgramRecorder.h"

namespace gt {
namespace {

/// How long a program sleeps at most before it looks whether it shall end, in ms.
constexpr std::int64_t longestWait = 50;
/// The process that serves tools does not turn faster, whatever they send, in ms.
constexpr std::int64_t shortestTurn = 2;

/// Each two processes have one connection: the one later in the layout connects to the other, all
/// connect to the platform.
Result<void> join(Wire& wire, const RobotProgramOptions& options, const Layout& layout) {
  const auto connect = [&](const std::string& peer) {
    return wire.connect(peer, options.addresses.endpoint(peer), options.connectKeys);
  };
  const std::string own = options.addresses.endpoint(options.process);
  if (auto done = wire.listen(own, options.listenKeys); !done) return done;
  if (auto done = connect(platformProcess); !done) return done;
  for (const ProcessLayout& process : layout.processes) {
    if (process.name == options.process) break;
    if (auto done = connect(process.name); !done) return done;
  }
  return {};
}

/// Addresses are those of the layout's processes, or of the platform.
Result<void> checkAddresses(const RobotProgramOptions& options, const Layout& layout) {
  for (const auto& [name, endpoint] : options.addresses.elsewhere) {
    const bool known = name == platformProcess ||
                       std::ranges::any_of(layout.processes, [&, &process = name](const auto& p) {
                         return p.name == process;
                       });
    if (!known)
      return Error{.file = options.layout, .field = name, .what = "the layout has no such process"};
    if (auto done = checkEndpoint(endpoint); !done) return done;
  }
  if (!options.tools.empty()) return checkEndpoint(options.tools);
  return {};
}

/// What the program of the Debug process serves besides: tools at a port, and a log.
class ToolServer {
 public:
  static Result<std::unique_ptr<ToolServer>> open(const RobotProgramOptions& options, Robot& robot,
                                                  const RobotModules& modules, Network& network,
                                                  Wire& wire) {
    const std::string endpoint =
        options.tools.empty() ? options.addresses.endpoint("Tools") : options.tools;
    std::unique_ptr<ToolServer> server{new ToolServer{robot, wire, modules}};
    auto port = ToolPort::open(network, endpoint, options.listenKeys, &server->vocabulary_);
    if (!port) return port.error();
    server->port_ = std::move(*port);
    if (!options.logs.empty()) {
      auto recorder = ProgramRecorder::open(options, robot.setup().layout, modules);
      if (!recorder) return recorder.error();
      server->recorder_ = std::move(*recorder);
      server->recorder_->connect(wire);
    }
    robot.onSave([&options, &robot, &network](const MessageQueue& messages) {
      const std::string folder = options.logs.empty() ? "." : options.logs;
      const auto file = saveQueue(messages, folder + "/" + options.addresses.robot);
      robot.toTools().write(network.now, Text{file ? "saved " + *file : file.error().text()});
    });
    return server;
  }

  /// To be called before each cycle of the process, and after it.
  void ask() {
    if (recorder_) recorder_->ask(wire_, robot_.fromTools());
  }
  std::vector<std::string> takeNews() {
    std::vector<std::string> news = port_->takeNews();
    if (recorder_) std::ranges::move(recorder_->takeNews(), std::back_inserter(news));
    return news;
  }
  void serve(std::int64_t elapsed) {
    if (recorder_) recorder_->write(wire_, robot_.toTools(), elapsed);
    port_->send(robot_.toTools());
    robot_.toTools().clear();
    // What tools want shall reach all processes, also those that start a little later.
    if (isComplete(elapsed)) port_->update(robot_.fromTools());
  }

 private:
  ToolServer(Robot& robot, Wire& wire, const RobotModules& modules)
      : robot_{robot}, wire_{wire}, vocabulary_{modules.messageTypes()} {}

  /// Whether all the robot's processes have been heard of, or have had their time to start.
  bool isComplete(std::int64_t elapsed) const {
    constexpr std::int64_t timeToStart = 3000;  // ms
    return elapsed > timeToStart ||
           std::ranges::all_of(robot_.setup().layout.processes, [&](const auto& process) {
             return process.collectsMessages || wire_.clockOf(process.name).session != 0;
           });
  }

  Robot& robot_;
  Wire& wire_;
  Vocabulary vocabulary_;
  std::unique_ptr<ToolPort> port_;
  std::unique_ptr<ProgramRecorder> recorder_;
};

void print(const RobotProgramOptions& options, const std::vector<std::string>& news) {
  for (const std::string& line : news)
    std::fprintf(stderr, "gtrobot %s: %s\n", options.process.c_str(), line.c_str());
}

/// Runs the process until the program shall end, or, as modules follow the platform's clock, until
/// the platform starts again.
Result<void> runSession(const RobotProgramOptions& options, const RobotModules& modules,
                        const RobotSetup& setup, bool servesTools, const EndSignals& signals) {
  const auto robot = Robot::make(setup, modules, {options.process});
  if (!robot) return robot.error();
  (*robot)->provideSetup([&options] {
    return recordSetup(
        {options.paths, options.layout, options.player, options.seed, options.hardwareAddress});
  });
  Network network;
  Wire wire{network, options.process};
  if (auto done = join(wire, options, setup.layout); !done) return done;
  (*robot)->join(wire);
  std::unique_ptr<ToolServer> tools;
  if (servesTools) {
    auto opened = ToolServer::open(options, **robot, modules, network, wire);
    if (!opened) return opened.error();
    tools = std::move(*opened);
  }

  std::uint64_t session = 0;
  while (!signals.received()) {
    if (tools)
      network.wait(std::clamp<std::int64_t>((*robot)->nextDebugCycle().ms - network.elapsed(), 0,
                                            longestWait),
                   shortestTurn);
    else
      network.wait(longestWait);
    wire.takeIn();
    const Wire::Clock platform = wire.clockOf(platformProcess);
    if (!tools && session != 0 && platform.session != session) return {};
    session = platform.session;
    network.now = tools ? Time{network.elapsed()} : platform.time;
    if (tools) tools->ask();
    (*robot)->step(network.now);
    wire.askForMore();
    if (tools) tools->serve(network.elapsed());
    print(options, wire.takeNews());
    if (tools) print(options, tools->takeNews());
  }
  return {};
}

}  // namespace

Result<void> runRobotProgram(const RobotProgramOptions& options, const RobotModules& modules) {
  const EndSignals signals;
  const auto layout = loadLayout(options.layout);
  if (!layout) return layout.error();
  const auto process = std::ranges::find_if(
      layout->processes, [&](const ProcessLayout& p) { return p.name == options.process; });
  if (process == layout->processes.end())
    return Error{
        .file = options.layout, .field = options.process, .what = "the layout has no such process"};
  if (auto done = checkAddresses(options, *layout); !done) return done;
  if (auto done = makePrivateFolder(options.addresses.folder); !done) return done;

  const auto wanted = configurationOf(*process, modules.solutions);
  const auto configuration = loadConfiguration(options.paths, modules, &wanted);
  if (!configuration) return configuration.error();
  const RobotSetup setup{
      *configuration,         *layout, options.player, options.seed, platformRepresentations(),
      options.hardwareAddress};
  do {
    if (auto done = runSession(options, modules, setup, process->collectsMessages, signals); !done)
      return done;
  } while (!signals.received());
  return {};
}

}  // namespace gt
