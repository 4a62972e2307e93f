#include "framework/ModuleProcess.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "base/CrashNotes.h"
#include "framework/UnknownNames.h"

namespace gt {

ModuleProcess::ModuleProcess(const Plan::Process& plan, Blackboard blackboard, Time& frameTime,
                             const Random& random)
    : Process{plan.layout.name},
      blackboard_{std::move(blackboard)},
      frameTime_{frameTime},
      platform_{plan.platform},
      missing_{plan.missing},
      answersFor_{plan.answersFor},
      debugSender_{representation<MessageQueue>(), &debugOut_},
      debugReceiver_{representation<MessageQueue>(), &debugIn_} {
  for (const auto& [task, trigger] : plan.order) {
    Slot& slot = slots_.emplace_back(Slot{task, trigger, {}, nullptr});
    for (const Solution& solution : task->solutions)
      slot.solutions.push_back(solution.make({blackboard_, debug_, random.fork(task->name)}));
    slot.active = slot.solutions.front().get();
    times_.modules.push_back({.name = task->name});
  }
  times_.process = name();
  add(debugSender_);
  add(debugReceiver_);
}

PackageSender& ModuleProcess::sender(const RepresentationType& type) {
  for (const auto& sender : ownSenders_)
    if (&sender->type() == &type) return *sender;
  ownSenders_.push_back(std::make_unique<PackageSender>(type, blackboard_.get(type)));
  add(*ownSenders_.back());
  return *ownSenders_.back();
}

PackageReceiver& ModuleProcess::receiver(const RepresentationType& type, bool blocking) {
  ownReceivers_.push_back(std::make_unique<PackageReceiver>(type, blackboard_.get(type), blocking));
  add(*ownReceivers_.back());
  return *ownReceivers_.back();
}

const ModuleProcess::Slot* ModuleProcess::find(std::string_view task) const {
  const auto slot =
      std::ranges::find_if(slots_, [&](const Slot& s) { return s.task->name == task; });
  return slot == slots_.end() ? nullptr : &*slot;
}

ModuleProcess::Slot* ModuleProcess::find(std::string_view task) {
  return const_cast<Slot*>(std::as_const(*this).find(task));
}

bool ModuleProcess::solves(std::string_view task) const {
  return find(task);
}

Result<AnyModule*> ModuleProcess::find(std::string_view task, std::string_view solution) {
  Slot* slot = find(task);
  if (!slot)
    return Error{.field = std::string{task}, .what = "process " + name() + " has no such task"};
  if (solution.empty() && slot->active) return slot->active;
  for (std::size_t i = 0; i < slot->solutions.size(); ++i)
    if (slot->task->solutions[i].name == solution) return slot->solutions[i].get();
  return Error{.field = std::string{task},
               .what = solution.empty() ? "is disabled; name the solution"
                                        : noSuchSolution(*slot->task, solution)};
}

/// Checks whether all inputs of a solution are available.
Result<void> ModuleProcess::checkInputs(const Task& task, std::string_view solution) const {
  if (const Solution* chosen = task.find(solution))
    for (const Port& port : chosen->ports)
      if (std::ranges::find(missing_, port.type) != missing_.end())
        return Error{.field = task.name,
                     .what = "'" + chosen->name + "' reads " + std::string{port.type->name} +
                             ", which this robot does not get"};
  return {};
}

bool ModuleProcess::concerns(const WatchRequest& request) const {
  if (!request.process.empty()) return request.process == name();
  return request.representation == typeName<ModuleTimes>() ||
         std::ranges::find(answersFor_, request.representation, &RepresentationType::name) !=
             answersFor_.end();
}

bool ModuleProcess::concerns(const ValueRequest& request) const {
  const RepresentationType* type = blackboard_.find(request.representation);
  return type && originOf(*type) != RepresentationOrigin::received;
}

bool ModuleProcess::concerns(const DescriptionRequest& request) const {
  return request.about.empty() || request.about == name() || solves(request.about);
}

/// Splits TASK.SOLUTION at its dot; the second part is empty if there is none.
static std::pair<std::string, std::string> taskAndSolution(const std::string& id) {
  const std::size_t dot = std::min(id.find('.'), id.size());
  return {id.substr(0, dot), id.substr(std::min(dot + 1, id.size()))};
}

bool ModuleProcess::concerns(const GenericDebugData& data) const {
  return solves(taskAndSolution(data.id).first);
}

Result<void> ModuleProcess::request(const SolutionRequest& request) {
  Slot* slot = find(request.task);
  if (slot && request.solution == SolutionTable::disabled) {
    slot->active = nullptr;
    return {};
  }
  const auto module = find(request.task, request.solution);
  if (!module) return module.error();
  if (auto done = checkInputs(*slot->task, request.solution); !done) return done;
  slot->active = *module;
  return {};
}

Result<void> ModuleProcess::request(const DebugRequest& request) {
  const DebugKey* key = DebugKey::find(request.key);
  if (!key) return concernsNobody(request);
  debug_.keys().set(*key, {request.mode, request.n});
  return {};
}

Result<void> ModuleProcess::request(const WatchRequest& request) {
  const RepresentationType* type = &representation<ModuleTimes>();
  const Blackboard::Slot* slot = nullptr;
  if (request.representation != type->name) {
    type = blackboard_.find(request.representation);
    if (!type)
      return Error{.field = request.representation,
                   .what = "process " + name() + " does not have it"};
    if (!type->type())
      return Error{.field = request.representation,
                   .what = "it cannot be sent, since it has no fields()"};
    slot = &blackboard_.slot(*type);
  }
  // Single requests (times) are stored in addition to permanent ones.
  if (request.mode != DebugKeyMode::times)
    std::erase_if(watched_, [&](const Watched& watched) { return watched.type == type; });
  if (request.mode != DebugKeyMode::disabled)
    watched_.push_back({type, slot, DebugKeyState{{request.mode, request.n}}});
  return {};
}

Result<void> ModuleProcess::setField(const RepresentationType& type, const std::string& path,
                                     const std::string& value) {
  const auto failed = [&](const Error& error) {
    return Error{.field = std::string{type.name} + "." + path, .what = error.what};
  };
  const std::shared_ptr<void> copy = type.make();
  type.copy(blackboard_.get(type), copy.get());
  const Value changed{type.type(), copy.get()};
  if (const auto done = detail::setByPath(changed, path, value); !done) return failed(done.error());
  if (const auto done = checked(ConstValue{changed}); !done) return failed(done.error());
  type.swap(copy.get(), blackboard_.own(type));
  return {};
}

void ModuleProcess::setHeld(const RepresentationType& type) {
  for (const Held& held : held_)
    if (held.type == &type) static_cast<void>(setField(type, held.path, held.value));
}

Result<void> ModuleProcess::request(const ValueRequest& request) {
  const RepresentationType* type = blackboard_.find(request.representation);
  if (!type || !type->type())
    return Error{.field = request.representation,
                 .what = type ? "it cannot be set, since it has no fields()"
                              : "process " + name() + " does not have it"};
  if (request.mode != ValueMode::release)
    if (auto done = setField(*type, request.path, request.value); !done) return done;
  if (changed_) changed_(*type);
  if (request.mode != ValueMode::set)
    std::erase_if(held_, [&](const Held& held) {
      return held.type == type && (held.path == request.path || request.path.empty());
    });
  if (request.mode == ValueMode::hold) held_.push_back({type, request.path, request.value});
  return {};
}

Result<void> ModuleProcess::request(const ParameterRequest& request) {
  const auto module = find(request.task, request.solution);
  if (!module) return module.error();
  return (*module)->set(request.path, request.value);
}

Result<void> ModuleProcess::request(const DescriptionRequest& request) {
  debug_.out().write(now(), describe(solves(request.about) ? request.about : std::string{}));
  return {};
}

Result<void> ModuleProcess::request(const GenericDebugData& data) {
  const auto [task, solution] = taskAndSolution(data.id);
  const auto module = find(task, solution);
  if (!module) return module.error();
  // Processed like a config file, which is applied completely or not at all.
  std::string text;
  auto number = data.data.begin();
  for (const PathInfo& parameter : (*module)->parameters()) {
    const auto count = static_cast<std::ptrdiff_t>(width(*parameter.value.type));
    if (parameter.value.type->kind == Kind::text || count > data.data.end() - number) break;
    text += parameter.path;
    const bool isSwitch = parameter.value.type->kind == Kind::boolean;
    for (const auto end = number + count; number != end; ++number)
      text += isSwitch ? *number != 0 ? " true" : " false" : ' ' + scalarText(valueOf(*number));
    text += '\n';
  }
  if (number != data.data.end())
    return Error{.field = data.id, .what = "these are more numbers than it has parameters"};
  return (*module)->configure(text, data.id).firstError();
}

std::string ModuleProcess::activeSolution(std::string_view task) const {
  const Slot* slot = find(task);
  if (!slot) return {};
  for (std::size_t i = 0; i < slot->solutions.size(); ++i)
    if (slot->solutions[i].get() == slot->active) return slot->task->solutions[i].name;
  return std::string{SolutionTable::disabled};
}

Result<std::string> ModuleProcess::parameter(std::string_view task, std::string_view solution,
                                             std::string_view path) {
  const auto module = find(task, solution);
  if (!module) return module.error();
  return (*module)->get(path);
}

Result<ConstValue> ModuleProcess::parameterValue(std::string_view task, std::string_view solution,
                                                 std::string_view path) {
  const auto module = find(task, solution);
  if (!module) return module.error();
  const auto parameters = (*module)->parameters();
  const auto found = std::ranges::find(parameters, path, &PathInfo::path);
  if (found == parameters.end())
    return Error{.field = std::string{path}, .what = "there is no such parameter"};
  return ConstValue{found->value};
}

bool ModuleProcess::provides(const RepresentationType& type) const {
  return std::ranges::any_of(slots_, [&](const Slot& slot) {
    return std::ranges::find(slot.task->outputs, &type) != slot.task->outputs.end();
  });
}

RepresentationOrigin ModuleProcess::originOf(const RepresentationType& type) const {
  if (provides(type)) return RepresentationOrigin::provided;
  if (std::ranges::find(platform_, &type) != platform_.end()) return RepresentationOrigin::platform;
  const bool received = std::ranges::any_of(
      ownReceivers_, [&](const auto& receiver) { return &receiver->type() == &type; });
  return received ? RepresentationOrigin::received : RepresentationOrigin::configuration;
}

ProcessDescription ModuleProcess::describe(std::string_view only) {
  ProcessDescription description;
  description.process = name();
  for (const Slot& slot : slots_) {
    if (!only.empty() && slot.task->name != only) continue;
    TaskDescription& task = description.tasks.emplace_back();
    task.name = slot.task->name;
    task.active = activeSolution(task.name);
    for (const auto* output : slot.task->outputs) task.outputs.emplace_back(output->name);
    for (std::size_t i = 0; i < slot.solutions.size(); ++i) {
      SolutionDescription& solution = task.solutions.emplace_back();
      solution.name = slot.task->solutions[i].name;
      for (const Port& port : slot.task->solutions[i].ports)
        if (port.kind != PortKind::output) solution.inputs.emplace_back(port.type->name);
      for (const PathInfo& p : slot.solutions[i]->parameters())
        solution.parameters.push_back({p.path, *slot.solutions[i]->get(p.path),
                                       std::string{p.info.unit}, std::string{p.info.doc},
                                       p.info.range.low, p.info.range.high});
    }
  }
  if (!only.empty()) return description;
  for (const RepresentationType* type : blackboard_.types())
    description.representations.push_back({std::string{type->name}, originOf(*type),
                                           type->type() != nullptr,
                                           type->type() ? type->schema().id() : 0});
  for (const DebugKey& key : DebugKey::all()) description.debugKeys.emplace_back(key.name());
  return description;
}

void ModuleProcess::copyProvided(Blackboard& to) {
  for (const Slot& slot : slots_)
    for (const RepresentationType* output : slot.task->outputs)
      if (to.find(output->name)) output->copy(blackboard_.get(*output), to.get(*output));
}

void ModuleProcess::adopt(ModuleProcess& other) {
  for (Slot& slot : slots_) {
    const Slot* before = other.find(slot.task->name);
    if (!before) continue;
    times_.modules[static_cast<std::size_t>(&slot - slots_.data())] =
        other.times_.modules[static_cast<std::size_t>(before - other.slots_.data())];
    for (std::size_t i = 0; i < slot.solutions.size(); ++i) {
      const auto same = other.find(slot.task->name, slot.task->solutions[i].name);
      if (!same) continue;
      slot.solutions[i]->adopt(**same);
      if (*same == before->active) slot.active = slot.solutions[i].get();
    }
    if (!before->active) slot.active = nullptr;
  }
  for (const Held& held : other.held_)
    if (concerns(ValueRequest{std::string{held.type->name}, held.path, held.value}))
      held_.push_back(held);
  debug_.keys() = other.debug_.keys();
}

std::vector<WatchRequest> ModuleProcess::watched() const {
  std::vector<WatchRequest> requests;
  for (const auto& [type, slot, state] : watched_)
    requests.push_back({std::string{type->name}, name(), state.request().mode, state.request().n});
  return requests;
}

Result<void> ModuleProcess::configure(std::string_view task, std::string_view solution,
                                      std::string_view text, const std::string& file) {
  const auto module = find(task, solution);
  if (!module)
    return Error{.file = file, .field = module.error().field, .what = module.error().what};
  return (*module)->configure(text, file).firstError();
}

void ModuleProcess::send(RequestAnswer answer) {
  answer.of = answering_;
  debug_.send(answer);
}

void ModuleProcess::handle(const Message& message) {
  if (auto answer = Requests::carryOut(message, name(), *this))
    send(*std::move(answer));
  else if (!handler_ || !handler_(message))
    handlePackage(message);
}

/// A message may replace a package that the process receives: a motion request of a tool, or a
/// message of a teammate that the router sends (report 2.2.2). An output of the process's own
/// modules keeps the value until a module provides it again, for instance while no BehaviorControl
/// is active (report I.5.3: mr). Configuration keeps the value.
void ModuleProcess::handlePackage(const Message& message) {
  const RepresentationType* type = blackboard_.find(message.id);
  if (!type || !type->decode) return;
  const auto report = [&](const Result<void>& done) {
    if (!done) answer(message, done);
  };
  for (const auto& receiver : ownReceivers_)
    if (&receiver->type() == type) {
      if (!receiver->blocking()) report(receiver->deliverBytes(message.bytes));
      return;
    }
  const std::shared_ptr<void> package = type->make();
  const auto done = type->decode(message.bytes, package.get());
  if (done) {
    type->swap(package.get(), blackboard_.own(*type));
    if (changed_) changed_(*type);
  }
  report(done);
}

bool ModuleProcess::isDisabled(const RepresentationType& type) const {
  return std::ranges::any_of(slots_, [&](const Slot& slot) {
    return !slot.active && std::ranges::find(slot.task->outputs, &type) != slot.task->outputs.end();
  });
}

bool ModuleProcess::layIfDisabled(const RepresentationType& type, const void* value) {
  if (!isDisabled(type)) return false;
  type.copy(value, blackboard_.get(type));
  return true;
}

bool ModuleProcess::isDue(const Slot& slot) const {
  return !slot.trigger ||
         std::any_of(ownReceivers_.begin(), ownReceivers_.end(), [&](const auto& receiver) {
           return &receiver->type() == slot.trigger && receiver->receivedNew();
         });
}

/// If the active solution fails, the solution that it names runs instead, in the same cycle.
void ModuleProcess::run(Slot& slot) {
  while (slot.active) {
    try {
      return slot.active->run();
    } catch (const ModuleFailure& failure) {
      const std::string failed = activeSolution(slot.task->name);
      const auto instead = find(slot.task->name, failure.instead());
      slot.active = instead && *instead != slot.active ? *instead : nullptr;
      debug_.warn(slot.task->name + ": " + failed + " failed, now " +
                  activeSolution(slot.task->name) + ": " + failure.what());
    }
  }
}

void ModuleProcess::sendWatched(bool onlyTimes) {
  std::erase_if(watched_, [&](Watched& watched) {
    const bool times = watched.state.request().mode == DebugKeyMode::times;
    if ((onlyTimes && !times) || !watched.state.isDue(now())) return false;
    watched.type->write(watched.slot ? watched.slot->value.get() : &times_, now(), debug_.out());
    return watched.state.request().mode == DebugKeyMode::disabled;
  });
}

void ModuleProcess::carryOut(const MessageQueue& messages, MessageQueue& answers) {
  messages.handleAllMessages([this](const Message& message) { handle(message); });
  sendWatched(true);
  debug_.out().moveAllMessages(answers);
  debug_.out().reportDropped(now());
}

int ModuleProcess::main() {
  const CrashContext context{name().c_str(), now()};
  debug_.begin(now());
  if (debugReceiver_.receivedNew())
    debugIn_.handleAllMessages([this](const Message& message) { handle(message); });
  frameTime_ = now();
  for (const Held& held : held_) static_cast<void>(setField(*held.type, held.path, held.value));

  for (std::size_t i = 0; i < slots_.size(); ++i)
    if (slots_[i].active && isDue(slots_[i])) {
      {
        const CrashContext module{slots_[i].task->name.c_str()};
        const Stopwatch::Lap lap{times_.modules[i]};
        run(slots_[i]);
      }
      if (!held_.empty())
        for (const RepresentationType* output : slots_[i].task->outputs) setHeld(*output);
    }

  for (const auto& sender : ownSenders_) sender->send();
  sendWatched(false);
  if (!debug_.out().empty() && debugSender_.requestedNew()) {
    debugOut_.clear();
    debug_.out().moveAllMessages(debugOut_);
    debug_.out().reportDropped(now());
    debugSender_.send();
  }
  return 0;
}

}  // namespace gt
