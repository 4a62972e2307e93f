#include "framework/ModuleProcess.h"

#include <algorithm>

namespace gt {

ModuleProcess::ModuleProcess(const Plan::Process& plan, Blackboard blackboard, Time& frameTime,
                             const Random& random)
    : Process{plan.layout.name},
      blackboard_{std::move(blackboard)},
      frameTime_{frameTime},
      debugSender_{representation<MessageQueue>(), &debugOut_},
      debugReceiver_{representation<MessageQueue>(), &debugIn_} {
  for (const auto& [task, trigger] : plan.order) {
    Slot& slot = slots_.emplace_back(Slot{task, trigger, {}, nullptr});
    for (const Solution& solution : task->solutions)
      slot.solutions.push_back(solution.make({blackboard_, debug_, random.fork(task->name)}));
    slot.active = slot.solutions.front().get();
    times_.emplace_back(task->name);
  }
  enlist(debugSender_);
  enlist(debugReceiver_);
}

PackageSender& ModuleProcess::sender(const RepresentationType& type) {
  for (const auto& sender : ownSenders_)
    if (&sender->type() == &type) return *sender;
  ownSenders_.push_back(std::make_unique<PackageSender>(type, blackboard_.get(type)));
  enlist(*ownSenders_.back());
  return *ownSenders_.back();
}

PackageReceiver& ModuleProcess::receiver(const RepresentationType& type, bool blocking) {
  ownReceivers_.push_back(std::make_unique<PackageReceiver>(type, blackboard_.get(type), blocking));
  enlist(*ownReceivers_.back());
  return *ownReceivers_.back();
}

ModuleProcess::Slot* ModuleProcess::find(std::string_view task) {
  const auto slot = std::find_if(slots_.begin(), slots_.end(),
                                 [&](const Slot& s) { return s.task->name == task; });
  return slot == slots_.end() ? nullptr : &*slot;
}

bool ModuleProcess::solves(std::string_view task) const {
  return std::any_of(slots_.begin(), slots_.end(),
                     [&](const Slot& s) { return s.task->name == task; });
}

Result<AnyModule*> ModuleProcess::find(std::string_view task, std::string_view solution) {
  Slot* slot = find(task);
  if (!slot) return Error{"", 0, std::string{task}, "process " + name() + " has no such task"};
  for (std::size_t i = 0; i < slot->solutions.size(); ++i)
    if (slot->task->solutions[i].name == solution) return slot->solutions[i].get();
  return Error{"", 0, std::string{task}, "there is no solution '" + std::string{solution} + "'"};
}

Result<void> ModuleProcess::request(const SolutionRequest& request) {
  if (request.solution == SolutionTable::disabled) {
    Slot* slot = find(request.task);
    if (!slot) return Error{"", 0, request.task, "process " + name() + " has no such task"};
    slot->active = nullptr;
    return {};
  }
  const auto module = find(request.task, request.solution);
  if (!module) return module.error();
  find(request.task)->active = *module;
  return {};
}

Result<void> ModuleProcess::request(const DebugRequest& request) {
  const DebugKey* key = DebugKey::find(request.key);
  if (!key) return Error{"", 0, request.key, "there is no such debug key"};
  debug_.keys().set(*key, {request.mode, request.n});
  return {};
}

Result<void> ModuleProcess::request(const WatchRequest& request) {
  const RepresentationType* type = blackboard_.find(request.representation);
  if (!type) return Error{"", 0, request.representation, "process " + name() + " does not have it"};
  std::erase_if(watched_, [&](const Watched& watched) { return watched.type == type; });
  if (request.mode != DebugKeyMode::disabled)
    watched_.push_back({type, blackboard_.get(*type), DebugKeyState{{request.mode, request.n}}});
  return {};
}

Result<void> ModuleProcess::request(const ParameterRequest& request) {
  const auto module = find(request.task, request.solution);
  if (!module) return module.error();
  return (*module)->set(request.path, request.value);
}

Result<void> ModuleProcess::request(const DescriptionRequest& request) {
  if (request.about.empty() || request.about == name()) debug_.out().write(now(), describe());
  return {};
}

Result<void> ModuleProcess::request(const GenericDebugData& data) {
  debug_.receive(data);
  return {};
}

std::string ModuleProcess::activeSolution(std::string_view task) const {
  for (const Slot& slot : slots_) {
    if (slot.task->name != task) continue;
    for (std::size_t i = 0; i < slot.solutions.size(); ++i)
      if (slot.solutions[i].get() == slot.active) return slot.task->solutions[i].name;
    return std::string{SolutionTable::disabled};
  }
  return {};
}

Result<std::string> ModuleProcess::parameter(std::string_view task, std::string_view solution,
                                             std::string_view path) {
  const auto module = find(task, solution);
  if (!module) return module.error();
  return (*module)->get(path);
}

ProcessDescription ModuleProcess::describe() {
  ProcessDescription description;
  description.process = name();
  for (const Slot& slot : slots_) {
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
  for (const DebugKey* key : DebugKey::all()) description.debugKeys.emplace_back(key->name());
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
    times_[static_cast<std::size_t>(&slot - slots_.data())] =
        other.times_[static_cast<std::size_t>(before - other.slots_.data())];
    for (std::size_t i = 0; i < slot.solutions.size(); ++i) {
      slot.solutions[i]->adopt(*before->solutions[i]);
      if (before->solutions[i].get() == before->active) slot.active = slot.solutions[i].get();
    }
    if (!before->active) slot.active = nullptr;
  }
  debug_.keys() = other.debug_.keys();
}

std::vector<WatchRequest> ModuleProcess::watched() const {
  std::vector<WatchRequest> requests;
  for (const auto& [type, value, state] : watched_)
    requests.push_back({std::string{type->name}, name(), state.request().mode, state.request().n});
  return requests;
}

Result<void> ModuleProcess::configure(std::string_view task, std::string_view solution,
                                      std::string_view text, const std::string& file) {
  const auto module = find(task, solution);
  if (!module) return Error{file, 0, module.error().field, module.error().what};
  return (*module)->configure(text, file);
}

template <typename Request>
bool ModuleProcess::handleAs(const Message& message) {
  if (!message.is<Request>()) return false;
  Request wanted;
  auto done = message.read(wanted);
  if (done) {
    // Requests go to all processes; each carries out what concerns it.
    if constexpr (requires { wanted.task; })
      if (!solves(wanted.task)) return true;
    if constexpr (requires { wanted.process; }) {
      const bool here =
          wanted.process.empty() ? provides(wanted.representation) : wanted.process == name();
      if (!here) return true;
    }
    done = request(wanted);
  }
  if (!done) debug_.text(name() + ": " + done.error().text());
  return true;
}

void ModuleProcess::handle(const Message& message) {
  handleAs<SolutionRequest>(message) || handleAs<DebugRequest>(message) ||
      handleAs<WatchRequest>(message) || handleAs<ParameterRequest>(message) ||
      handleAs<DescriptionRequest>(message) || handleAs<GenericDebugData>(message) ||
      (handler_ && handler_(message)) || handlePackage(message);
}

/// What the process receives as a package may also come as a message: a motion request of a tool, a
/// message of a team mate that the router brings (report 2.2.2). What its own modules provide is
/// laid down for them: it lasts as long as none of them says otherwise, for instance while no
/// BehaviorControl is active (report I.5.3: mr).
bool ModuleProcess::handlePackage(const Message& message) {
  const RepresentationType* type = blackboard_.findOwn(message.id);
  if (!type || !type->decode) return false;
  const auto tell = [this](const Result<void>& done) {
    if (!done) debug_.text(name() + ": " + done.error().text());
    return true;
  };
  for (const auto& receiver : ownReceivers_)
    if (&receiver->type() == type)
      return !receiver->blocking() && tell(receiver->deliverBytes(message.bytes));
  const std::shared_ptr<void> package = type->make();
  const auto done = type->decode(message.bytes, package.get());
  if (done) type->swap(package.get(), blackboard_.get(*type));
  return tell(done);
}

bool ModuleProcess::layIfDisabled(const RepresentationType& type, const void* value) {
  for (const Slot& slot : slots_)
    if (!slot.active && std::find(slot.task->outputs.begin(), slot.task->outputs.end(), &type) !=
                            slot.task->outputs.end()) {
      type.copy(value, blackboard_.get(type));
      return true;
    }
  return false;
}

bool ModuleProcess::provides(std::string_view representation) const {
  return std::any_of(slots_.begin(), slots_.end(), [&](const Slot& slot) {
    return std::any_of(slot.task->outputs.begin(), slot.task->outputs.end(),
                       [&](auto* output) { return output->name == representation; });
  });
}

bool ModuleProcess::isDue(const Slot& slot) const {
  return !slot.trigger ||
         std::any_of(ownReceivers_.begin(), ownReceivers_.end(), [&](const auto& receiver) {
           return &receiver->type() == slot.trigger && receiver->receivedNew();
         });
}

int ModuleProcess::main() {
  debug_.begin(now());
  if (debugReceiver_.receivedNew())
    debugIn_.handleAllMessages([this](const Message& message) { handle(message); });
  frameTime_ = now();

  for (std::size_t i = 0; i < slots_.size(); ++i)
    if (slots_[i].active && isDue(slots_[i])) {
      const Stopwatch::Lap lap{times_[i]};
      slots_[i].active->run();
    }

  debug_.forgetReceived();
  for (const auto& sender : ownSenders_) sender->send();
  for (Watched& watched : watched_)
    if (watched.state.isDue(now())) watched.type->write(watched.value, now(), debug_.out());
  if (!debug_.out().empty() && debugSender_.requestedNew()) {
    debugOut_.clear();
    debug_.out().moveAllMessages(debugOut_);
    debug_.out().tellDropped(now());
    debugSender_.send();
  }
  return 0;
}

}  // namespace gt
