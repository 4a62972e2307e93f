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

/// A tool's view of a robot: the data received in its messages, and all requests to it
/// (framework/Requests.h). Works in the same way for a simulated robot, one on a log, and a
/// physical one. Data must be requested; data that is not requested is neither sent nor copied nor
/// decoded. Not thread-safe.
class ObservedRobot {
 public:
  /// A value at a point in time.
  struct Point {
    Time time;
    double value;
  };

  ObservedRobot(std::string name, std::unique_ptr<RobotLink> link);
  ObservedRobot(const ObservedRobot&) = delete;
  ObservedRobot& operator=(const ObservedRobot&) = delete;

  const std::string& name() const { return name_; }
  RobotKind kind() const { return link_->kind(); }
  /// Time of the newest message.
  Time time() const { return time_; }

  /// Processes messages of the robot. Called by the code that runs the robot.
  void take(const MessageQueue& messages);
  /// Processes the messages that have arrived by the link.
  void update();

  // Values of representations, by name.

  /// Returns the present value of a representation: where it lies, if the robot's memory is in this
  /// program; otherwise requests it from the robot, unless it is subscribed. The value is valid until
  /// the robot's next cycle, or until the same representation is asked for again. Returns an error if
  /// the robot lacks the representation or does not answer.
  Result<ConstValue> value(const std::string& representation);
  template <typename T>
  Result<const T*> value() {
    const auto found = value(std::string{representation<T>().name});
    if (!found) return found.error();
    return static_cast<const T*>(found->data());
  }
  /// Returns the newest value that was received, without requesting it; null if there is none.
  template <typename T>
  const T* newest() {
    return static_cast<const T*>(newest(representation<T>()));
  }
  /// Lets the robot send a representation after each cycle for as long as the subscription exists.
  /// The robot must outlive the subscription.
  class Subscription;
  [[nodiscard]] Subscription subscribe(const std::string& representation);
  /// Lets the robot send the output of a debug key for as long as the subscription exists, even if
  /// a request switches the key off. `drawings()` does not contain drawings that are only sent for
  /// subscriptions.
  [[nodiscard]] Subscription subscribeKey(const std::string& key);
  /// Lets the robot send the drawings of a debug key for as long as the handle exists, unless a
  /// request switches the key off. The handle may be released in any thread, and outlive the robot.
  [[nodiscard]] std::shared_ptr<const void> showKey(const std::string& key);
  /// Lets the robot send a representation at the rate of a debug key of this state (command dk),
  /// without a Subscription object.
  Result<void> watch(const std::string& representation, DebugKeyRequest often);
  /// Representations that can be requested from the robot, sorted; empty if it does not answer.
  const std::vector<std::string>& representations();
  /// Those of the representations that the robot's platform sends: its sensor input.
  const std::vector<std::string>& inputs();

  // Values by path: RobotPose.pose.rotation, or a parameter, as TASK.PATH or TASK.SOLUTION.PATH.

  Result<std::string> get(const std::string& path);
  /// Sets a parameter, or a field of a representation. A field keeps the value until its provider
  /// provides it again, or until it is released if it is held.
  Result<void> set(const std::string& path, const std::string& value,
                   ValueMode mode = ValueMode::set);
  /// Whether a name is that of a representation or a task, so that paths may begin with it.
  bool has(const std::string& name);
  /// The paths that begin with the name of a representation or task.
  Result<std::vector<std::string>> paths(const std::string& name);

  // What its processes report about themselves.

  /// Tasks, solutions, parameters and debug keys. Requested each time, because they may have
  /// changed.
  Result<const std::vector<ProcessDescription>*> processes();
  /// Description of one task. Returns an error if no process solves it.
  Result<const TaskDescription*> task(const std::string& name);
  /// All debug keys, sorted.
  const std::vector<std::string>& debugKeys();
  /// Total execution times of the modules of each process.
  Result<const std::map<std::string, ModuleTimes>*> times();

  /// The data from which the robot is made, so that a log can contain it.
  Result<RecordedSetup> setup();

  // Messages to the robot.

  /// Sends a request to all processes. Returns an error if one of them refuses it, if it concerns
  /// none of them, or if not all of them answer.
  template <typename Request>
  Result<void> request(const Request& request);
  /// Sends the request, and shows or hides the drawings of the key.
  Result<void> request(const DebugRequest& request);
  /// Sends the request, and discards the known descriptions of the robot.
  Result<void> request(const LayoutRequest& request);
  /// Sends any other message, such as a representation. Returns an error if it is refused at once.
  template <typename T>
  Result<void> send(const T& message) {
    return send(representation<T>(), &message);
  }
  Result<void> send(const RepresentationType& type, const void* message);

  // Drawings, plots, texts: what has come so far.

  /// The newest drawing of each key.
  const std::map<std::string, Drawing>& drawings() const { return drawings_; }
  /// Time at which the newest drawing of a key was received; never if there is none.
  Time drawnAt(const std::string& key) const {
    const auto known = drawnAt_.find(key);
    return known == drawnAt_.end() ? never() : known->second;
  }
  /// Whether this tool has switched off the key of a drawing.
  bool isHidden(const std::string& key) const {
    const auto known = keys_.find(key);
    return known != keys_.end() && known->second.off;
  }
  /// Plotted values over time, and the times of stopwatches in us.
  const std::map<std::string, std::deque<Point>>& plots() const { return plots_; }
  /// The texts received since the last call.
  std::vector<std::string> takeTexts() { return std::exchange(texts_, {}); }
  void addText(std::string text);
  /// Warnings of the robot, at most 1,000: texts that are warnings, requests that it refused,
  /// messages for which it had no room.
  const Findings& warnings() const { return warnings_; }
  /// Discards all received data, because the robot has started again, possibly at an earlier time.
  void forget();

  /// Also passes all messages to another receiver, such as a recorder, for as long as the handle
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
    DebugKeyRequest watched{};  ///< By watch().
  };

  /// The requests for a debug key.
  struct Key {
    DebugKeyRequest byHand{};
    bool asked = false, off = false;  ///< State of the last request by hand.
    int subscriptions = 0;
    std::vector<std::weak_ptr<const void>> viewers{};

    bool isWanted() const {
      return subscriptions > 0 || byHand.mode != DebugKeyMode::disabled || (!off && isViewed());
    }
    bool isViewed() const {
      return std::ranges::any_of(viewers, [](const auto& viewer) { return !viewer.expired(); });
    }
    /// Drawings that are only sent for subscriptions are not shown.
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

  /// Sends a message to the robot. Returns its time stamp, which identifies the answers.
  template <typename T>
  Result<Time> write(const T& message) {
    return write(representation<T>(), &message);
  }
  Result<Time> write(const RepresentationType& type, const void* message);
  Result<void> refusalOf(Time asked) const;
  template <typename Condition>
  bool await(Condition condition);
  /// Waits until all processes have answered the last message, or one of them if only one is
  /// concerned. Returns an error if they do not.
  Result<void> awaitAnswers(bool one);
  Result<bool> carriedOut(bool one);

  std::string name_;
  std::unique_ptr<RobotLink> link_;
  Time time_;
  std::map<std::uint32_t, Newest> newest_;  ///< By the ids of the types.
  std::map<std::string, Drawing> drawings_;
  std::map<std::string, Time> drawnAt_;
  std::map<std::string, std::deque<Point>> plots_;
  std::vector<std::string> texts_;
  Findings warnings_;
  std::vector<std::weak_ptr<const RobotLink::Taker>> takers_;
  std::map<std::string, Key> keys_;

  Time asked_;                                 ///< Time stamp of the last message to the robot.
  std::vector<RequestAnswer> answers_;         ///< Answers to this message.
  std::vector<ProcessDescription> processes_;  ///< Processes as described last, by name.
  std::vector<std::string> representations_, inputs_, debugKeys_;
  std::string about_;     ///< Name of the task that was requested alone.
  TaskDescription task_;  ///< Description of that task.
  std::map<std::string, ModuleTimes> times_;
};

/// Requests a representation or the output of a debug key for as long as it exists.
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
