#include "robot/Robot.h"

#include <algorithm>
#include <utility>

#include "network/RobotAddresses.h"
#include "network/Wire.h"
#include "representations/behavior/BehaviorRequest.h"
#include "robot/Solutions.h"
#include "robot/TeamSolutions.h"

namespace gt {
namespace {

bool contains(const std::vector<std::string>& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

Result<std::unique_ptr<Robot>> Robot::make(const RobotSetup& setup, const RobotModules& modules,
                                           const std::vector<std::string>& here) {
  auto plan = makePlan(setup.layout, modules.solutions, setup.platform, modules.given());
  if (!plan) return plan.error();
  for (const std::string& process : here)
    if (std::ranges::none_of(plan->processes,
                             [&](const auto& planned) { return planned.layout.name == process; }))
      return Error{
          .file = setup.layout.file, .field = process, .what = "the layout has no such process"};
  std::unique_ptr<Robot> robot{new Robot{setup, modules, here}};
  if (auto done = robot->build(std::move(*plan)); !done) return done.error();
  if (auto done = robot->configure(*setup.configuration); !done) return done.error();
  return robot;
}

bool Robot::runsHere(const std::string& process) const {
  return here_.empty() || contains(here_, process);
}

Result<void> Robot::build(Plan plan) {
  plan_ = std::move(plan);
  std::string debug = here_.empty() ? "Debug" : "";
  for (const Plan::Process& process : plan_.processes) {
    if (!runsHere(process.layout.name)) continue;
    for (const Plan::Step& step : process.order)
      if (step.task->solutions.empty())
        return Error{.file = setup_.layout.file,
                     .line = process.layout.line,
                     .field = step.task->name,
                     .what = "this program was linked without solutions of this task"};
    if (process.layout.collectsMessages)
      debug = process.layout.name;
    else
      addProcess(process);
  }
  if (!debug.empty()) debug_ = std::make_unique<DebugProcess>(debug);
  connect();
  return {};
}

void Robot::addProcess(const Plan::Process& plan) {
  ModuleProcess& process = *processes_.emplace_back(makeProcess(plan, setup_));
  process.answerAsOneOf(static_cast<std::uint32_t>(std::ranges::count(
      plan_.processes, false, [](const auto& other) { return other.layout.collectsMessages; })));
  process.onMessage([this, &process](const Message& message) { return handle(message, process); });
  process.onChange([this, &process](const RepresentationType& type) {
    for (const ConfigurationPart& part : modules_->parts)
      if (part.type == &type && part.changed) part.changed(process.blackboard());
  });
}

/// Connects the processes that run here with each other and with the platform.
void Robot::connect() {
  for (const Connection& connection : plan_.connections) {
    ModuleProcess* to = find(connection.to);
    ModuleProcess* from = find(connection.from);
    if (to && from)
      from->sender(*connection.type).connect(to->receiver(*connection.type, connection.blocking));
    else if (to && connection.from.empty())
      links_.push_back({connection.type, &to->receiver(*connection.type, connection.blocking)});
  }
  for (const auto& process : processes_)
    if (debug_) debug_->connect(process->debugSender(), process->debugReceiver());
}

void Robot::join(Wire& wire) {
  wire_ = &wire;
  for (const PlatformLink& link : links_) wire.receive(platformProcess, *link.receiver);
  for (const Connection& connection : plan_.connections)
    if (ModuleProcess* to = find(connection.to);
        to && !connection.from.empty() && !find(connection.from))
      wire.receive(connection.from, to->receiver(*connection.type, connection.blocking));
  for (const Plan::Process& planned : plan_.processes)
    if (ModuleProcess* process = find(planned.layout.name))
      for (const Plan::Step& step : planned.order)
        for (const RepresentationType* type : step.task->outputs)
          if (type->encodedSize) wire.provide(process->sender(*type));
  for (const RepresentationType* command : commandRepresentations())
    if (ModuleProcess* process = find(senderOf(plan_, *command)))
      wire.provide(process->sender(*command));
  if (debug_ && processes_.empty()) wire.provide(debug_->sender());
  for (const Plan::Process& other : plan_.processes) {
    if (runsHere(other.layout.name)) continue;
    if (debug_ && !other.layout.collectsMessages)
      wire.receive(other.layout.name, debug_->addReceiver());
    if (debug_ || !other.layout.collectsMessages) continue;
    for (const auto& process : processes_) {
      wire.provide(process->debugSender());
      wire.receive(other.layout.name, process->debugReceiver());
    }
  }
}

Result<void> Robot::changeLayout(const Layout& layout) {
  if (wire_)
    return Error{
        .file = layout.file,
        .what = "the robot's processes are programs of their own: start those of the layout"};
  auto plan = makePlan(layout, modules_->solutions, setup_.platform, modules_->given());
  if (!plan) return plan.error();
  const auto oldProcesses = std::exchange(processes_, {});
  const auto oldDebug = std::move(debug_);
  links_.clear();
  setup_.layout = layout;
  if (auto done = build(std::move(*plan)); !done) return done;
  for (const auto& process : processes_) {
    // What a process reads from the platform, then what others have provided, then its own.
    for (const auto& old : oldProcesses) process->blackboard().copyFrom(old->blackboard());
    for (const auto& old : oldProcesses) old->copyProvided(process->blackboard());
    for (const auto& old : oldProcesses) process->adopt(*old);
  }
  for (const auto& old : oldProcesses)
    for (const WatchRequest& watched : old->watched())
      static_cast<void>(watch(watched.representation, {watched.mode, watched.n}));
  debug_->adopt(*oldDebug);
  ++layoutChanges_;
  return {};
}

Result<void> Robot::addToPlatform(const RepresentationType& type) {
  if (std::ranges::find(setup_.platform, &type) != setup_.platform.end()) return {};
  setup_.platform.push_back(&type);
  auto done = changeLayout(setup_.layout);
  if (!done) setup_.platform.pop_back();
  return done;
}

Result<void> Robot::add(const std::string& task, Solution solution) {
  if (std::ranges::none_of(processes_, [&](const auto& process) { return process->solves(task); }))
    return Error{.field = task, .what = "no process of the robot solves this task"};
  auto modules = std::make_shared<RobotModules>(*modules_);
  if (auto done = modules->solutions.add(task, std::move(solution)); !done) return done;
  const RobotModules* before = std::exchange(modules_, modules.get());
  if (auto done = changeLayout(setup_.layout); !done) {
    modules_ = before;
    return done;
  }
  ownModules_ = std::move(modules);
  return {};
}

Result<void> Robot::configure(const Configuration& configuration) {
  for (const Configuration::SolutionChoice& choice : configuration.solutions)
    if (here_.empty() && !isInherited(choice, configuration.solutions) &&
        std::ranges::none_of(processes_,
                             [&](const auto& process) { return process->solves(choice.task); }))
      return Error{.file = choice.file,
                   .line = choice.line,
                   .field = choice.task,
                   .what = "no process solves this task"};
  for (const auto& process : processes_)
    if (auto done = configureProcess(*process, configuration); !done) return done;
  return {};
}

ModuleProcess* Robot::find(std::string_view name) const {
  for (const auto& process : processes_)
    if (process->name() == name) return process.get();
  return nullptr;
}

/// The process that provides a representation, or the first that reads it.
ModuleProcess* Robot::holderOf(std::string_view representation) const {
  for (const Plan::Process& process : plan_.processes)
    for (const Plan::Step& step : process.order)
      for (const RepresentationType* output : step.task->outputs)
        if (output->name == representation) return find(process.layout.name);
  for (const auto& process : processes_)
    if (process->blackboard().find(representation)) return process.get();
  return nullptr;
}

Result<const RepresentationType*> Robot::watch(const std::string& representation,
                                               DebugKeyRequest often) {
  ModuleProcess* process = holderOf(representation);
  if (!process) return Error{.field = representation, .what = "no process of the robot has it"};
  const WatchRequest request{representation, process->name(), often.mode, often.n};
  if (auto done = process->request(request); !done) return done.error();
  return process->blackboard().find(representation);
}

std::optional<ConstValue> Robot::value(std::string_view representation) const {
  ModuleProcess* process = holderOf(representation);
  const RepresentationType* type = process ? process->blackboard().find(representation) : nullptr;
  if (!type || !type->type()) return std::nullopt;
  return ConstValue{*type->type(), process->blackboard().get(*type)};
}

const void* Robot::provided(const RepresentationType& type) const {
  ModuleProcess* process = find(senderOf(plan_, type));
  return process ? process->blackboard().get(type) : nullptr;
}

bool Robot::step(Time now) {
  bool ran = false;
  for (const auto& process : processes_) ran |= process->step(now);
  if (!debug_) return ran;
  handleRequests(now);
  return debug_->step(now) || ran;
}

/// What concerns the robot as a whole.
struct Robot::Whole {
  Result<void> request(const LayoutRequest& request) {
    const auto layout = parseLayout(request.text, request.name);
    return layout ? robot.changeLayout(*layout) : layout.error();
  }
  Result<void> request(const SetupRequest&) {
    if (!robot.setupOf_) return Error{.field = "setup", .what = "is not known of this robot"};
    const auto setup = robot.setupOf_();
    if (!setup) return setup.error();
    if (!robot.toTools().write(now, *setup))
      return Error{.field = "setup", .what = "is too large to be sent"};
    return {};
  }

  Robot& robot;
  Time now;
};

void Robot::handleRequests(Time now) {
  Whole whole{*this, now};
  Requests::carryOutAll(fromTools(), "robot", whole,
                        [&](const RequestAnswer& answer) { toTools().write(now, answer); });
}

/// What the framework does not know but some part of the configuration does.
bool Robot::handle(const Message& message, ModuleProcess& process) const {
  for (const ConfigurationPart& part : modules_->parts)
    if (part.handle && part.handle(message, process, setup_.configuration->files)) return true;
  // Another process may have the part that knows it.
  if (!message.is<BehaviorRequest>()) return false;
  process.answerNotConcerned(message);
  return true;
}

void Robot::answer() {
  handleRequests(processes_.front()->now());
  debug_->handleRequests();
  for (const auto& process : processes_) process->carryOut(fromTools(), toTools());
  fromTools().clear();
}

}  // namespace gt
