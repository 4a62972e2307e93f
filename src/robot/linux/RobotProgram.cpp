#include "robot/linux/RobotProgram.h"

#include <algorithm>
#include <csignal>

#include "crash/CrashHandler.h"
#include "framework/DebugProcess.h"
#include "network/ToolPort.h"
#include "network/Wire.h"
#include "robot/RobotLog.h"
#include "robot/linux/Recorder.h"

namespace gt {
namespace {

volatile std::sig_atomic_t stopped = 0;

/// How long a program sleeps at most before it looks whether it shall end, in ms.
constexpr std::int64_t longestWait = 50;
/// The process that serves tools does not turn faster, whatever they send, in ms.
constexpr std::int64_t shortestTurn = 2;

void stopOnSignals() {
  struct sigaction action {};
  action.sa_handler = [](int) { stopped = 1; };
  sigaction(SIGTERM, &action, nullptr);
  sigaction(SIGINT, &action, nullptr);
}

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
    if (!known) return Error{options.layout, 0, name, "the layout has no such process"};
    if (endpoint.find("://") == endpoint.npos)
      return Error{"network", 0, endpoint, "is no endpoint, such as tcp://10.0.1.100:5001"};
  }
  return {};
}

std::string debugProcessOf(const Layout& layout) {
  for (const ProcessLayout& process : layout.processes)
    if (process.collectsMessages) return process.name;
  return "";
}

void connect(Wire& wire, ModuleProcess& process, const Plan& plan, const Plan::Process& planned,
             const std::string& debugProcess) {
  for (const Connection& connection : plan.connections)
    if (connection.to == process.name())
      wire.receive(connection.from.empty() ? platformProcess : connection.from,
                   process.receiver(*connection.type, connection.blocking));
  for (const Plan::Step& step : planned.order)
    for (const RepresentationType* type : step.task->outputs)
      if (type->encodedSize) wire.provide(process.sender(*type));
  wire.provide(process.debugSender());
  if (!debugProcess.empty()) wire.receive(debugProcess, process.debugReceiver());
}

/// Carries out a BehaviorRequest where behavior is decided.
bool changeBehavior(ModuleProcess& process, const Message& message) {
  if (!message.is<BehaviorRequest>()) return false;
  if (!process.solves("BehaviorControl")) {
    process.answerNotConcerned(message);
    return true;
  }
  BehaviorRequest request;
  Result<void> done = message.read(request);
  if (done) {
    if (const auto behavior = loadBehavior(request, process.blackboard().get<MotionNet>()))
      process.blackboard().get<Behavior>() = *behavior;
    else
      done = behavior.error();
  }
  process.answer(message, done);
  return true;
}

/// Lives by the platform's clock. Returns when the program shall end, or the platform began anew:
/// then so does the robot.
Result<void> runModules(const RobotProgramOptions& options, const Layout& layout,
                        const SolutionTable& table, const RobotSetup& setup) {
  const auto plan = makePlan(layout, table, setup.platform, givenRepresentations());
  if (!plan) return plan.error();
  const auto planned = std::ranges::find_if(plan->processes, [&](const Plan::Process& process) {
    return process.layout.name == options.process;
  });
  for (const Plan::Step& step : planned->order)
    if (step.task->solutions.empty())
      return Error{options.layout, planned->layout.line, step.task->name,
                   "this program was linked without solutions of this task"};

  const auto process = makeProcess(*planned, setup);
  if (auto done = configureProcess(*process, *setup.configuration); !done) return done;
  Network network;
  Wire wire{network, options.process};
  if (auto done = join(wire, options, layout); !done) return done;
  connect(wire, *process, *plan, *planned, debugProcessOf(layout));
  process->onMessage([&](const Message& message) { return changeBehavior(*process, message); });

  std::uint64_t session = 0;
  while (!stopped) {
    network.wait(longestWait);
    wire.takeIn();
    const Wire::Clock clock = wire.clockOf(platformProcess);
    if (session != 0 && clock.session != session) return {};
    session = clock.session;
    network.now = clock.time;
    if (process->step(clock.time))
      noteForCrashReport("cycle at " + std::to_string(clock.time.ms) + " ms");
    wire.askForMore();
  }
  return {};
}

/// Saves messages beside the robot's log, and tells the tools where.
void tellSaved(const RobotProgramOptions& options, const MessageQueue& messages,
               const SolutionTable& table, Time now, MessageQueue& toTools) {
  const std::string folder = options.logs.empty() ? "." : options.logs;
  const auto file = saveQueue(messages, folder + "/" + options.addresses.robot, table);
  toTools.write(now, Text{file ? "saved " + *file : file.error().text()});
}

/// Whether all the robot's processes have been heard of, or have had their time to start.
bool isComplete(const Wire& wire, const Layout& layout, std::int64_t elapsed) {
  constexpr std::int64_t timeToStart = 3000;  // ms
  return elapsed > timeToStart || std::ranges::all_of(layout.processes, [&](const auto& process) {
           return process.collectsMessages || wire.clockOf(process.name).session != 0;
         });
}

/// Passes messages between the robot's other processes and the tools.
Result<void> runDebug(const RobotProgramOptions& options, const Layout& layout,
                      const SolutionTable& table) {
  DebugProcess debug{options.process};
  Network network;
  Wire wire{network, options.process};
  if (auto done = join(wire, options, layout); !done) return done;
  const std::string tools =
      options.tools.empty() ? options.addresses.endpoint("Tools") : options.tools;
  const auto port = ToolPort::open(network, tools, options.listenKeys);
  if (!port) return port.error();
  debug.onSave([&](const MessageQueue& messages) {
    tellSaved(options, messages, table, network.now, debug.toTools());
  });
  std::unique_ptr<Recorder> recorder;
  if (!options.logs.empty()) {
    auto opened = Recorder::open(options, layout, table);
    if (!opened) return opened.error();
    recorder = std::move(*opened);
    recorder->connect(wire);
  }
  wire.provide(debug.sender());
  for (const ProcessLayout& process : layout.processes)
    if (!process.collectsMessages) wire.receive(process.name, debug.addReceiver());

  while (!stopped) {
    network.wait(std::clamp<std::int64_t>(debug.next().ms - network.elapsed(), 0, longestWait),
                 shortestTurn);
    wire.takeIn();
    network.now = Time{network.elapsed()};
    if (recorder) recorder->ask(wire, debug.fromTools());
    debug.step(network.now);
    wire.askForMore();
    if (recorder) recorder->write(wire, debug.toTools(), network.elapsed());
    (*port)->send(debug.toTools());
    debug.toTools().clear();
    // What tools want shall reach all processes, also those that start a little later.
    if (isComplete(wire, layout, network.elapsed())) (*port)->update(debug.fromTools());
  }
  return {};
}

}  // namespace

Result<void> runRobotProgram(const RobotProgramOptions& options, const SolutionTable& table) {
  stopOnSignals();
  const auto layout = loadLayout(options.layout);
  if (!layout) return layout.error();
  const auto process = std::ranges::find_if(
      layout->processes, [&](const ProcessLayout& p) { return p.name == options.process; });
  if (process == layout->processes.end())
    return Error{options.layout, 0, options.process, "the layout has no such process"};
  if (auto done = checkAddresses(options, *layout); !done) return done;
  if (auto done = makePrivateFolder(options.addresses.folder); !done) return done;
  if (process->collectsMessages) return runDebug(options, *layout, table);

  const auto configuration = loadConfiguration(options.paths, table);
  if (!configuration) return configuration.error();
  const RobotSetup setup{
      *configuration,         *layout, options.player, options.seed, platformRepresentations(),
      options.hardwareAddress};
  while (!stopped)
    if (auto done = runModules(options, *layout, table, setup); !done) return done;
  return {};
}

}  // namespace gt
