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

/// A robot: the processes of its layout, connected to each other and to a platform, which sends
/// sensor data and receives commands. The robot does not know whether the platform is a simulator,
/// hardware or a log. Either all of its processes run in this program, or some of them, connected
/// to the others by a wire; this does not change the robot's behavior and answers. Not thread-safe.
class Robot {
 public:
  /// Makes a robot in one program, with all existing modules.
  static Result<std::unique_ptr<Robot>> make(const RobotSetup& setup);
  /// Makes those processes of a robot that run `here`, by their names in the layout (all if empty),
  /// with the modules that are linked into this program.
  static Result<std::unique_ptr<Robot>> make(const RobotSetup& setup, const RobotModules& modules,
                                             const std::vector<std::string>& here = {});

  /// Connects the processes with those in other programs and, if it is one of them, with the
  /// platform. The name of the wire is that of the process that runs here.
  void join(Wire& wire);

  /// Sends a package from the platform to every process that reads it.
  template <typename T>
  void send(const T& package) {
    send(representation<T>(), &package);
  }
  void send(const RepresentationType& type, const void* package) {
    for (PlatformLink& link : links_)
      if (link.type == &type) link.receiver->deliver(package);
  }
  /// Memory in which a package can be written before it is sent, so that it is not copied for the
  /// first process that reads it. Null if no process reads it. Valid until the next step.
  template <typename T>
  T* place() {
    for (PlatformLink& link : links_)
      if (link.type == &representation<T>()) return static_cast<T*>(link.receiver->place());
    return nullptr;
  }
  /// A representation that a process provides, as it is at the end of that process's last cycle;
  /// null if no process provides it.
  template <typename T>
  const T* provided() const {
    return static_cast<const T*>(provided(representation<T>()));
  }

  /// Requests that a representation is sent to the tools after cycles of the process that provides
  /// it, or of the first process that reads it. The rate is given by the state of a debug key.
  /// Returns the representation's type.
  Result<const RepresentationType*> watch(const std::string& representation,
                                          DebugKeyRequest often = {DebugKeyMode::always, 0});
  /// A representation by its name, as it is at the end of the last cycle of the process that
  /// provides it, or of the first process that reads it. Empty if it does not exist or is not
  /// streamable.
  std::optional<ConstValue> value(std::string_view representation) const;
  /// Sets the output of a task that is disabled; the oracle uses this (report I.5.3: so).
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

  /// Switches to another behavior in the next cycle; see BehaviorRequest. The caller is trusted:
  /// any file is read.
  Result<void> request(const BehaviorRequest& request);

  using Requests = RequestTypes<LayoutRequest, SetupRequest>;
  /// Lets each process run at most once, in the order of the layout. Then executes or refuses the
  /// tools' requests to the robot as a whole. Returns whether a process ran.
  bool step(Time now);
  /// Executes the messages from the tools immediately, between two steps. The answers are in
  /// `toTools`.
  void answer();

  /// Sets the function that provides the robot's setup for tools (SetupRequest).
  void provideSetup(std::function<Result<RecordedSetup>()> setup) { setupOf_ = std::move(setup); }

  /// Redistributes the modules to the processes of another layout, between two steps. The modules
  /// keep their internal state; solutions, parameters, debug keys and representations are
  /// unchanged. References returned by `provided` before become invalid. After an error nothing is
  /// changed. Only for robots in one program.
  Result<void> changeLayout(const Layout& layout);

  /// Adds a representation to those that the platform sends, between two steps. Solutions that read
  /// it can be selected afterward. Otherwise like `changeLayout` with the same layout.
  Result<void> addToPlatform(const RepresentationType& type);

  /// Adds a solution of a task, between two steps, to which the robot can be switched afterward.
  /// Replaces a solution of the same name that was added before. Otherwise like `changeLayout` with
  /// the same layout. Also returns an error if no process solves the task, or an input is not
  /// provided.
  Result<void> add(const std::string& task, Solution solution);

  /// Message queues from and to the tools; they belong to the Debug process.
  MessageQueue& toTools() { return debug_->toTools(); }
  MessageQueue& fromTools() { return debug_->fromTools(); }
  /// Time of the Debug process's next cycle.
  Time nextDebugCycle() const { return debug_->next(); }
  /// Passes a request immediately to all processes that it concerns. Returns an error if there is
  /// none.
  template <typename Request>
  Result<void> request(const Request& request);
  /// Changes how the queue to the tools is filled.
  Result<void> request(const QueueFillRequest& request) { return debug_->request(request); }
  /// Sets the receiver of the messages that a QueueFillRequest asks to save.
  void onSave(QueueFill::Saver saver) { debug_->onSave(std::move(saver)); }

  const std::vector<std::unique_ptr<ModuleProcess>>& processes() const { return processes_; }
  const Plan& plan() const { return plan_; }
  const std::vector<const RepresentationType*>& platform() const { return setup_.platform; }
  const RobotSetup& setup() const { return setup_; }
  /// Number of changes of the layout so far.
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
  std::shared_ptr<const RobotModules> ownModules_;  ///< Set once solutions were added.
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

/// The plan of a layout for a robot on a platform that sends these representations; see makePlan.
Result<Plan> robotPlan(const Layout& layout,
                       const std::vector<const RepresentationType*>& platform);

}  // namespace gt
