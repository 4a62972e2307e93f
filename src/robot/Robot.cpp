#include "robot/Robot.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "robot/Solutions.h"

namespace gt {

Result<Plan> robotPlan(const Layout& layout,
                       const std::vector<const RepresentationType*>& platform) {
  return makePlan(layout, solutions(), platform, givenRepresentations());
}

Result<std::unique_ptr<Robot>> Robot::make(const RobotSetup& setup) {
  auto plan = robotPlan(setup.layout, setup.platform);
  if (!plan) return plan.error();
  std::unique_ptr<Robot> robot{new Robot{setup}};
  robot->build(std::move(*plan));
  if (const auto done = robot->configure(*setup.configuration); !done) return done.error();
  return robot;
}

void Robot::build(Plan plan) {
  plan_ = std::move(plan);
  for (const Plan::Process& process : plan_.processes)
    if (!process.layout.collectsMessages) processes_.push_back(makeProcess(process, setup_));
  debug_ = std::make_unique<DebugProcess>("Debug");
  connect();
}

Result<void> Robot::changeLayout(const Layout& layout) {
  auto plan = robotPlan(layout, setup_.platform);
  if (!plan) return plan.error();
  const auto oldProcesses = std::exchange(processes_, {});
  const auto oldDebug = std::move(debug_);
  links_.clear();
  setup_.layout = layout;
  build(std::move(*plan));
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

Result<void> Robot::carryOut(const LayoutRequest& request) {
  const auto layout = parseLayout(request.text, request.name);
  return layout ? changeLayout(*layout) : Result<void>{layout.error()};
}

Result<void> Robot::request(const BehaviorRequest& request) {
  for (const auto& process : processes_) {
    Blackboard& blackboard = process->blackboard();
    if (!blackboard.find(representation<Behavior>().name)) continue;
    auto behavior = loadBehavior(request, blackboard.get<MotionNet>());
    if (!behavior) return behavior.error();
    blackboard.get<Behavior>() = *std::move(behavior);
  }
  return {};
}

/// Requests that concern the robot as a whole: the last of a kind that came counts.
template <typename Request, typename CarryOut>
void Robot::carryOutLast(Time now, CarryOut carryOut) {
  std::optional<Message> last;
  Request wanted;
  Result<void> done;
  fromTools().handleAllMessages([&](const Message& message) {
    if (!message.is<Request>()) return;
    last = message;
    done = message.read(wanted);
  });
  if (!last) return;
  fromTools().removeIf([](const Message& message) { return message.is<Request>(); });
  if (done) done = carryOut(wanted);
  toTools().write(now, answerTo(*last, "robot", done));
}

void Robot::connect() {
  for (const Connection& connection : plan_.connections) {
    PackageReceiver& receiver =
        find(connection.to)->receiver(*connection.type, connection.blocking);
    if (connection.from.empty())
      links_.push_back({connection.type, &receiver});
    else
      find(connection.from)->sender(*connection.type).connect(receiver);
  }
  for (const auto& process : processes_)
    debug_->connect(process->debugSender(), process->debugReceiver());
}

Result<void> Robot::configure(const Configuration& configuration) {
  for (const Configuration::SolutionChoice& choice : configuration.solutions)
    if (std::none_of(processes_.begin(), processes_.end(),
                     [&](const auto& process) { return process->solves(choice.task); }))
      return Error{choice.file, choice.line, choice.task, "no process solves this task"};
  for (const auto& process : processes_)
    if (auto done = configureProcess(*process, configuration); !done) return done;
  return {};
}

ModuleProcess* Robot::find(std::string_view name) const {
  for (const auto& process : processes_)
    if (process->name() == name) return process.get();
  return nullptr;
}

ModuleProcess* Robot::providerOf(std::string_view representation) const {
  for (const Plan::Process& process : plan_.processes)
    for (const Plan::Step& step : process.order)
      for (const RepresentationType* output : step.task->outputs)
        if (output->name == representation) return find(process.layout.name);
  return nullptr;
}

Result<const RepresentationType*> Robot::watch(const std::string& representation,
                                               DebugKeyRequest often) {
  ModuleProcess* process = providerOf(representation);
  for (const auto& reader : processes_)
    if (!process && reader->blackboard().find(representation)) process = reader.get();
  if (!process) return Error{"", 0, representation, "no process of the robot has it"};
  const WatchRequest request{representation, process->name(), often.mode, often.n};
  if (auto done = process->request(request); !done) return done.error();
  return process->blackboard().find(representation);
}

std::optional<ConstValue> Robot::value(std::string_view representation) const {
  ModuleProcess* process = providerOf(representation);
  for (const auto& reader : processes_)
    if (!process && reader->blackboard().find(representation)) process = reader.get();
  const RepresentationType* type = process ? process->blackboard().find(representation) : nullptr;
  if (!type || !type->type()) return std::nullopt;
  return ConstValue{*type->type(), process->blackboard().get(*type)};
}

const void* Robot::provided(const RepresentationType& type) const {
  ModuleProcess* process = providerOf(type.name);
  return process ? process->blackboard().get(type) : nullptr;
}

/// Of the messages of the tools, those that concern the robot as a whole.
void Robot::carryOutWhole(Time now) {
  if (fromTools().empty()) return;
  carryOutLast<LayoutRequest>(now,
                              [this](const LayoutRequest& wanted) { return carryOut(wanted); });
  carryOutLast<BehaviorRequest>(now,
                                [this](const BehaviorRequest& wanted) { return request(wanted); });
}

void Robot::step(Time now) {
  for (const auto& process : processes_) process->step(now);
  carryOutWhole(now);
  debug_->step(now);
}

void Robot::answer() {
  carryOutWhole(processes_.front()->now());
  debug_->handleRequests();
  for (const auto& process : processes_) process->carryOut(fromTools(), toTools());
  fromTools().clear();
}

}  // namespace gt
