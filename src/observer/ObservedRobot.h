#pragma once
#include <algorithm>
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/Findings.h"
#include "debug/DebugKey.h"
#include "debug/Drawing.h"
#include "framework/Description.h"
#include "framework/Representation.h"
#include "framework/Requests.h"
#include "logs/RecordedSetup.h"
#include "observer/RobotLink.h"

namespace gt {

/// What is known of a robot from its messages, and all that it can be asked (framework/Requests.h):
/// the same for a robot of the simulator, one on a log and one elsewhere. Whoever wants to know
/// something asks for it; what nobody asks for is neither sent nor copied nor decoded. One thread
/// at a time.
class ObservedRobot {
 public:
  /// A value over time.
  struct Point {
    Time time;
    double value;
  };

  ObservedRobot(std::string name, std::unique_ptr<RobotLink> link);
  ObservedRobot(const ObservedRobot&) = delete;
  ObservedRobot& operator=(const ObservedRobot&) = delete;

  const std::string& name() const { return name_; }
  RobotKind kind() const { return link_->kind(); }
  /// Of the newest message.
  Time time() const { return time_; }

  /// Takes what the robot has sent. Called by whatever runs the robot.
  void take(const MessageQueue& messages);
  /// Takes what has come by the link meanwhile.
  void update();

  // Values of representations, by name.

  /// A representation as it is now. Asks the robot for it, unless it is subscribed. The value is
  /// valid until messages are taken again. Returns an error if the robot does not have it or does
  /// not answer.
  Result<ConstValue> value(const std::string& representation);
  template <typename T>
  Result<const T*> value() {
    const auto found = value(std::string{representation<T>().name});
    if (!found) return found.error();
    return static_cast<const T*>(found->data());
  }
  /// The newest value that has come, without asking for it; null if none has.
  template <typename T>
  const T* newest() {
    return static_cast<const T*>(newest(representation<T>()));
  }
  /// Has a representation sent after each cycle for as long as the subscription exists. The robot
  /// must outlive the subscription.
  class Subscription;
  [[nodiscard]] Subscription subscribe(const std::string& representation);
  /// Has the output of a debug key sent for as long as the subscription exists, also after a
  /// request has switched the key off. `drawings()` has none that is drawn for subscriptions alone.
  [[nodiscard]] Subscription subscribeKey(const std::string& key);
  /// Has the drawings of a debug key come for as long as the handle exists, unless the key was
  /// switched off by a request. The handle may be dropped in any thread, and outlive the robot.
  [[nodiscard]] std::shared_ptr<const void> showKey(const std::string& key);
  /// The same as `subscribe` by hand: as often as a debug key of this state (command dk).
  Result<void> watch(const std::string& representation, DebugKeyRequest often);
  /// The representations that the robot can be asked for, sorted; empty if it does not answer.
  const std::vector<std::string>& representations();
  /// Of these, the ones that its platform sends: what the robot senses.
  const std::vector<std::string>& inputs();

  // Values by path: RobotPose.pose.rotation, or a parameter, as TASK.PATH or TASK.SOLUTION.PATH.

  Result<std::string> get(const std::string& path);
  /// Sets a parameter, or a field of a representation. A field lasts until its provider provides it
  /// again, or until it is released if it is held.
  Result<void> set(const std::string& path, const std::string& value,
                   ValueMode mode = ValueMode::set);
  /// Whether paths may begin with this name: of a representation or a task.
  bool has(const std::string& name);
  /// The paths that begin with the name of a representation or task.
  Result<std::vector<std::string>> paths(const std::string& name);

  // What its processes report about themselves.

  /// Tasks, solutions, parameters, debug keys: asked for each time, since they may have changed.
  Result<const std::vector<ProcessDescription>*> processes();
  /// One task. Returns an error if no process solves it.
  Result<const TaskDescription*> task(const std::string& name);
  /// All debug keys, sorted.
  const std::vector<std::string>& debugKeys();
  /// How long the modules of each process took so far.
  Result<const std::map<std::string, ModuleTimes>*> times();

  /// What makes it, so that a log can keep it.
  Result<RecordedSetup> setup();

  // Messages to the robot.

  /// Hands a request to all processes. Returns an error if one of them refuses it, if it concerns
  /// none of them, or if they do not all answer.
  template <typename Request>
  Result<void> request(const Request& request);
  /// Also shows or hides what is drawn under the key.
  Result<void> request(const DebugRequest& request);
  /// Also asks anew what the robot has.
  Result<void> request(const LayoutRequest& request);
  /// Sends any other message, such as a representation. Returns an error if it is refused at once.
  template <typename T>
  Result<void> send(const T& message) {
    return send(representation<T>(), &message);
  }
  Result<void> send(const RepresentationType& type, const void* message);

  // Drawings, plots, texts: what has come so far.

  /// The newest of each key.
  const std::map<std::string, Drawing>& drawings() const { return drawings_; }
  /// When the newest of a key came; never if none has.
  Time drawnAt(const std::string& key) const {
    const auto known = drawnAt_.find(key);
    return known == drawnAt_.end() ? never() : known->second;
  }
  /// Whether the key of a drawing was switched off here.
  bool isHidden(const std::string& key) const {
    const auto known = keys_.find(key);
    return known != keys_.end() && known->second.off;
  }
  /// What was plotted, and the times of stopwatches in us.
  const std::map<std::string, std::deque<Point>>& plots() const { return plots_; }
  /// The texts that came since this was called last.
  std::vector<std::string> takeTexts() { return std::exchange(texts_, {}); }
  void addText(std::string text);
  /// All that the robot has reported as wrong, up to a thousand findings: texts that are warnings,
  /// requests that it refused, messages for which it had no room.
  const Findings& warnings() const { return warnings_; }
  /// Forgets all of that, and all values: the robot has begun anew, perhaps at an earlier time.
  void forget();

  /// Also hands all messages to something else, such as a recorder, for as long as the handle
  /// exists.
  [[nodiscard]] std::shared_ptr<const void> passTo(RobotLink::Taker taker);

 private:
  /// The newest message of a type.
  struct Newest {
    std::vector<std::byte> bytes;
    std::uint64_t count = 0;
    std::shared_ptr<void> value{};
    bool decoded = false;
    int subscriptions = 0;
    DebugKeyRequest watched{};  ///< By hand.
  };

  /// What is asked for of a debug key.
  struct Key {
    DebugKeyRequest byHand{};
    bool asked = false, off = false;  ///< By hand, last.
    int subscriptions = 0;
    std::vector<std::weak_ptr<const void>> viewers{};

    bool isWanted() const {
      return subscriptions > 0 || byHand.mode != DebugKeyMode::disabled || (!off && isViewed());
    }
    bool isViewed() const {
      return std::ranges::any_of(viewers, [](const auto& viewer) { return !viewer.expired(); });
    }
    /// What is drawn for subscriptions alone is for others.
    bool isShown() const { return !off && (asked || isViewed() || subscriptions == 0); }
  };

  void take(const Message& message);
  void take(RequestAnswer answer);
  void take(ProcessDescription description);
  void keep(Time time, Drawing drawing);
  void keep(const std::string& plot, Point point);
  void forgetNames();
  void drop(const std::string& representation);
  void dropKey(const std::string& key);
  void dropViewers();
  Result<void> isKnown(std::string_view representation);
  const void* newest(const RepresentationType& type);
  Result<ConstValue> decoded(const RepresentationType& type);
  Result<std::pair<ParameterRequest, std::string>> parameter(const std::string& path);

  /// Writes a message for the robot; returns the time stamp by which it is answered.
  template <typename T>
  Result<Time> write(const T& message) {
    return write(representation<T>(), &message);
  }
  Result<Time> write(const RepresentationType& type, const void* message);
  Result<void> refusalOf(Time asked) const;
  template <typename Condition>
  bool await(Condition condition);
  /// Waits until all processes have answered the last message, or one if only one is concerned.
  /// Returns an error if they do not.
  Result<void> awaitAnswers(bool one);
  Result<bool> carriedOut(bool one);

  std::string name_;
  std::unique_ptr<RobotLink> link_;
  Time time_;
  std::map<std::uint32_t, Newest> newest_;  ///< By the types' ids.
  std::map<std::string, Drawing> drawings_;
  std::map<std::string, Time> drawnAt_;
  std::map<std::string, std::deque<Point>> plots_;
  std::vector<std::string> texts_;
  Findings warnings_;
  std::vector<std::weak_ptr<const RobotLink::Taker>> takers_;
  std::map<std::string, Key> keys_;

  Time asked_;                                 ///< Time stamp of the last message to the robot.
  std::vector<RequestAnswer> answers_;         ///< To it.
  std::vector<ProcessDescription> processes_;  ///< As they were last asked for, by name.
  std::vector<std::string> representations_, inputs_, debugKeys_;
  std::string about_;     ///< What was asked for is one task.
  TaskDescription task_;  ///< That task.
  std::map<std::string, ModuleTimes> times_;
};

/// Keeps a representation or the output of a debug key coming.
class ObservedRobot::Subscription {
 public:
  using Drop = void (ObservedRobot::*)(const std::string&);

  Subscription() = default;
  Subscription(ObservedRobot& robot, std::string name, Drop drop)
      : robot_{&robot}, name_{std::move(name)}, drop_{drop} {}
  Subscription(Subscription&& other) noexcept
      : robot_{std::exchange(other.robot_, nullptr)},
        name_{std::move(other.name_)},
        drop_{other.drop_} {}
  Subscription& operator=(Subscription&& other) noexcept {
    std::swap(robot_, other.robot_);
    std::swap(name_, other.name_);
    std::swap(drop_, other.drop_);
    return *this;
  }
  ~Subscription() {
    if (robot_) (robot_->*drop_)(name_);
  }

 private:
  ObservedRobot* robot_ = nullptr;
  std::string name_;
  Drop drop_ = nullptr;
};

template <typename Request>
Result<void> ObservedRobot::request(const Request& request) {
  constexpr bool toAll = requires {
    concernsNobody(request);
  };
  if (const auto asked = write(request); !asked) return asked.error();
  const auto done = carriedOut(!toAll);
  if (!done) return done.error();
  if (*done) return {};
  if constexpr (toAll)
    return concernsNobody(request);
  else
    return Error{.field = name_, .what = "no process of the robot can do that"};
}

}  // namespace gt
