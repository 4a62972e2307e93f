#pragma once
#include <cassert>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "framework/DebugProcess.h"
#include "robot/Processes.h"

namespace gt {

/// A robot: the processes of its layout, connected to each other and to a platform, which sends it
/// sensor readings and takes its commands. It does not know whether the platform is a simulator,
/// hardware or a log. One thread at a time.
class Robot {
 public:
  static Result<std::unique_ptr<Robot>> make(const RobotSetup& setup);

  /// Sends a package to every process that reads it, as the platform.
  template <typename T>
  void send(const T& package) {
    send(representation<T>(), &package);
  }
  void send(const RepresentationType& type, const void* package) {
    for (PlatformLink& link : links_)
      if (link.type == &type) link.receiver->deliver(package);
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
    for (const auto& process : processes_) process->layIfDisabled(representation<T>(), &value);
  }

  /// Has the robot go on with another behavior from its next cycle on; see BehaviorRequest.
  Result<void> request(const BehaviorRequest& request);

  /// Gives each process, in the order of the layout, the chance to run once. Then carries out a
  /// LayoutRequest or BehaviorRequest that came from the tools; what is wrong with it is told by a
  /// text.
  void step(Time now);
  /// Carries out at once, between two steps, what the tools have sent; the answers are in
  /// `toTools`.
  void answer();

  /// Regroups the modules to the processes of another layout, between two steps. They go on with
  /// all that they remember; solutions, parameters, debug keys and representations stay as they
  /// are. References to what `provided` returned before are no longer valid. An error leaves all as
  /// it was.
  Result<void> changeLayout(const Layout& layout);

  /// Messages from and to the robot's processes.
  MessageQueue& toTools() { return debug_->toTools(); }
  MessageQueue& fromTools() { return debug_->fromTools(); }
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

  explicit Robot(RobotSetup setup) : setup_{std::move(setup)} {}
  void build(Plan plan);
  void connect();
  void carryOutWhole(Time now);
  Result<void> carryOut(const LayoutRequest& request);
  template <typename Request, typename CarryOut>
  void carryOutLast(Time now, CarryOut carryOut);
  Result<void> configure(const Configuration& configuration);
  ModuleProcess* find(std::string_view process) const;
  ModuleProcess* providerOf(std::string_view representation) const;
  const void* provided(const RepresentationType& type) const;

  RobotSetup setup_;
  Plan plan_;
  std::vector<std::unique_ptr<ModuleProcess>> processes_;
  std::unique_ptr<DebugProcess> debug_;
  std::vector<PlatformLink> links_;
  int layoutChanges_ = 0;
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
