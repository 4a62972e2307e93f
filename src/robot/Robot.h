#pragma once
#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/DebugProcess.h"
#include "logs/RecordedSetup.h"
#include "robot/Processes.h"

namespace gt {

class Wire;

/// A robot: the processes of its layout, connected to each other and to a platform, which sends it
/// sensor readings and takes its commands. It does not know whether the platform is a simulator,
/// hardware or a log. All of its processes run in this program, or some of them, joined with the
/// others by a wire; which makes no difference to what it does and answers. One thread at a time.
class Robot {
 public:
  /// A robot in one program, with all modules that there are.
  static Result<std::unique_ptr<Robot>> make(const RobotSetup& setup);
  /// The processes of a robot that run `here`, by their names in the layout (all, without a name),
  /// with the modules that are linked into this program.
  static Result<std::unique_ptr<Robot>> make(const RobotSetup& setup, const RobotModules& modules,
                                             const std::vector<std::string>& here = {});

  /// Connects the processes with those that run in other programs and, if it is one, the platform.
  /// The wire bears the name of the process that runs here.
  void join(Wire& wire);

  /// Sends a package to every process that reads it, as the platform.
  template <typename T>
  void send(const T& package) {
    send(representation<T>(), &package);
  }
  void send(const RepresentationType& type, const void* package) {
    for (PlatformLink& link : links_)
      if (link.type == &type) link.receiver->deliver(package);
  }
  /// Where a package can be written before it is sent, so that sending it copies nothing to the
  /// first process that reads it; null if none does. Valid until the next step.
  template <typename T>
  T* place() {
    for (PlatformLink& link : links_)
      if (link.type == &representation<T>()) return static_cast<T*>(link.receiver->place());
    return nullptr;
  }
  /// A representation that some process provides, as it is at the end of its last cycle; null if
  /// none does.
  template <typename T>
  const T* provided() const {
    return static_cast<const T*>(provided(representation<T>()));
  }

  /// Has a representation sent to the tools after cycles of the process that provides it, or of the
  /// first that reads it, as often as a debug key of that state. Returns its type.
  Result<const RepresentationType*> watch(const std::string& representation,
                                          DebugKeyRequest often = {DebugKeyMode::always, 0});
  /// A representation by its name, as it is at the end of the last cycle of the process that
  /// provides it, or of the first that reads it; nothing if there is none, or it is not streamable.
  std::optional<ConstValue> value(std::string_view representation) const;
  /// Lays a value down in place of the task that would provide it, if that is disabled: as the
  /// oracle does (report I.5.3: so).
  template <typename T>
  void layIfDisabled(const T& value) {
    layIfDisabled(representation<T>(), &value);
  }
  void layIfDisabled(const RepresentationType& type, const void* value) {
    for (const auto& process : processes_) process->layIfDisabled(type, value);
  }
  bool isDisabled(const RepresentationType& type) const {
    return std::ranges::any_of(processes_,
                               [&](const auto& process) { return process->isDisabled(type); });
  }

  /// Has the robot go on with another behavior from its next cycle on; see BehaviorRequest. Who
  /// calls it may name any file.
  Result<void> request(const BehaviorRequest& request);

  using Requests = RequestTypes<LayoutRequest, SetupRequest>;
  /// Gives each process, in the order of the layout, the chance to run once. Then carries out or
  /// refuses what the tools ask of the robot as a whole. Returns whether a process ran.
  bool step(Time now);
  /// Carries out at once, between two steps, what the tools have sent; the answers are in
  /// `toTools`.
  void answer();

  /// Sets what provides the setup of the robot when tools ask for it (SetupRequest).
  void provideSetup(std::function<Result<RecordedSetup>()> setup) { setupOf_ = std::move(setup); }

  /// Regroups the modules to the processes of another layout, between two steps. They go on with
  /// all that they remember; solutions, parameters, debug keys and representations stay as they
  /// are. References to what `provided` returned before are no longer valid. An error leaves all as
  /// it was. Only for robots in one program.
  Result<void> changeLayout(const Layout& layout);

  /// Has the platform send a representation from now on, between two steps: solutions that read it
  /// can be chosen then. Otherwise as `changeLayout` with the same layout.
  Result<void> addToPlatform(const RepresentationType& type);

  /// Adds a solution of a task, between two steps, to which the robot can be switched from then on.
  /// It replaces one of its name that was added before. Otherwise as `changeLayout` with the same
  /// layout. An error also if no process solves the task, or nobody provides an input.
  Result<void> add(const std::string& task, Solution solution);

  /// Messages from and to the robot's processes, where the Debug process runs.
  MessageQueue& toTools() { return debug_->toTools(); }
  MessageQueue& fromTools() { return debug_->fromTools(); }
  /// When the Debug process has its next cycle.
  Time nextDebugCycle() const { return debug_->next(); }
  /// Hands a request to all processes that it concerns, at once; an error if it concerns none.
  template <typename Request>
  Result<void> request(const Request& request);
  /// Fills the queue to the tools in another way, from now on.
  Result<void> request(const QueueFillRequest& request) { return debug_->request(request); }
  /// What takes the messages that a QueueFillRequest asks to save.
  void onSave(QueueFill::Saver saver) { debug_->onSave(std::move(saver)); }

  const std::vector<std::unique_ptr<ModuleProcess>>& processes() const { return processes_; }
  const Plan& plan() const { return plan_; }
  const std::vector<const RepresentationType*>& platform() const { return setup_.platform; }
  const RobotSetup& setup() const { return setup_; }
  /// Counts the changes of the layout.
  int layoutChanges() const { return layoutChanges_; }

 private:
  struct PlatformLink {
    const RepresentationType* type;
    PackageReceiver* receiver;
  };

  Robot(RobotSetup setup, const RobotModules& modules, std::vector<std::string> here)
      : setup_{std::move(setup)}, modules_{&modules}, here_{std::move(here)} {}
  Result<void> build(Plan plan);
  void addProcess(const Plan::Process& plan);
  void connect();
  Result<void> configure(const Configuration& configuration);
  bool runsHere(const std::string& process) const;
  ModuleProcess* find(std::string_view process) const;
  ModuleProcess* holderOf(std::string_view representation) const;
  const void* provided(const RepresentationType& type) const;

  struct Whole;
  void handleRequests(Time now);
  bool handle(const Message& message, ModuleProcess& process) const;

  RobotSetup setup_;
  const RobotModules* modules_;
  std::shared_ptr<const RobotModules> ownModules_;  ///< Once solutions were added.
  std::vector<std::string> here_;                   ///< Empty: all.
  Plan plan_;
  std::vector<std::unique_ptr<ModuleProcess>> processes_;
  std::unique_ptr<DebugProcess> debug_;
  std::vector<PlatformLink> links_;
  int layoutChanges_ = 0;
  Wire* wire_ = nullptr;
  std::function<Result<RecordedSetup>()> setupOf_;
};

template <typename Request>
Result<void> Robot::request(const Request& request) {
  bool concerned = false;
  for (const auto& process : processes_) {
    if (!process->concerns(request)) continue;
    concerned = true;
    if (auto done = process->request(request); !done) return done;
  }
  return concerned ? Result<void>{} : concernsNobody(request);
}

/// The plan of a layout for a robot on a platform that sends this; see makePlan.
Result<Plan> robotPlan(const Layout& layout,
                       const std::vector<const RepresentationType*>& platform);

}  // namespace gt
