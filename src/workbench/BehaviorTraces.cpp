#include "workbench/BehaviorTraces.h"

#include <atomic>
#include <cstdlib>
#include <mutex>
#include <optional>
#include <utility>

#include "framework/SolutionTable.h"
#include "logs/RobotLog.h"
#include "representations/behavior/BehaviorTrace.h"

namespace gt {
namespace {

constexpr std::size_t mostParts = 20'000;
constexpr const char* beginOfTrace = "xabsl";

/// The first trace in a log, to which all others refer; empty if there is none.
std::string subjectIn(const std::string& log) {
  auto reader = McapReader::open(log);
  if (!reader) return {};
  BehaviorTrace trace;
  while (const auto message = reader->next()) {
    if (reader->channel(message->channel)->topic != "/BehaviorTrace") continue;
    if (decode(message->data, trace) && trace.text.starts_with(beginOfTrace)) return trace.text;
    break;
  }
  return {};
}

}  // namespace

/// Takes the messages, on the session's thread.
class BehaviorTraces::Collector : public std::enable_shared_from_this<Collector> {
 public:
  explicit Collector(std::string robot) : robot_{std::move(robot)} {}

  /// The robots are other ones from now on.
  void forget() { forgotten_ = true; }
  /// To be called after each step.
  void look(Console& console) {
    ConsoleRobot* robot = console.session().find(robot_);
    if (robot_.empty())
      if (const auto selected = console.selected(); !selected.empty()) robot = selected.front();
    if (!robot) return;
    ObservedRobot& observed = robot->observed();
    if (forgotten_.exchange(false) || &observed != observed_) {
      observed_ = &observed;
      handle_ = observed.passTo([collector = weak_from_this()](const MessageQueue& queue) {
        const auto self = collector.lock();
        if (!self) return;
        queue.handleAllMessages([&](const Message& message) { self->take(message); });
      });
      complete_ = false;
      restarting_.reset();
      if (robot->onLog() && !runs(observed))
        showRecorded(robot->onLog()->player().path());
      else
        request(DebugKeyMode::always);
      return;
    }
    // What a trace is about comes when it is switched on: it has been on, so off and on again.
    if (!restarting_) return;
    if (*restarting_ == never()) {
      restarting_ = observed.time();
      request(DebugKeyMode::disabled);
    } else if (std::abs(observed.time() - *restarting_) > pause) {
      restarting_.reset();
      request(DebugKeyMode::always);
    }
  }
  std::deque<std::string> takeParts() {
    const std::lock_guard lock{mutex_};
    return std::exchange(parts_, {});
  }

 private:
  static constexpr std::int64_t pause = 100;  // ms

  static bool runs(ObservedRobot& robot) {
    const auto task = robot.task("BehaviorControl");
    return task && !(*task)->active.empty() && (*task)->active != SolutionTable::disabled;
  }
  /// The log's own trace is shown while the key is off.
  void showRecorded(const std::string& log) {
    request(DebugKeyMode::disabled);
    std::string subject = subjectIn(log);
    if (subject.empty()) return;
    complete_ = true;
    keep(std::move(subject));
  }
  void request(DebugKeyMode mode) {
    // A robot without behavior has no trace.
    static_cast<void>(observed_->request(DebugRequest{traceKey, mode, 0}));
  }
  void take(const Message& message) {
    BehaviorTrace trace;
    if (!message.is<BehaviorTrace>() || !message.read(trace)) return;
    complete_ |= trace.text.starts_with(beginOfTrace);
    if (!complete_) {
      if (!restarting_) restarting_ = never();
      return;
    }
    keep(std::move(trace.text));
  }
  void keep(std::string part) {
    const std::lock_guard lock{mutex_};
    parts_.push_back(std::move(part));
    if (parts_.size() > mostParts) parts_.pop_front();
  }

  std::string robot_;
  ObservedRobot* observed_ = nullptr;
  std::shared_ptr<const void> handle_;
  std::atomic<bool> forgotten_ = true;
  bool complete_ = false;           ///< What the trace is about has come.
  std::optional<Time> restarting_;  ///< Never: to be switched off.
  std::mutex mutex_;
  std::deque<std::string> parts_;
};

BehaviorTraces::BehaviorTraces(SessionThread& session)
    : session_{session}, beginnings_{session.status().beginnings} {
  follow({});
}

void BehaviorTraces::follow(const std::string& robot) {
  collector_ = std::make_shared<Collector>(robot);
  const auto handle = std::make_shared<std::shared_ptr<const void>>();
  session_.change([collector = std::weak_ptr{collector_}, handle](Console& console) {
    *handle = console.session().afterSteps([collector, &console] {
      if (const auto known = collector.lock()) known->look(console);
    });
  });
  handle_ = handle;
}

std::deque<std::string> BehaviorTraces::takeParts() {
  return collector_->takeParts();
}

bool BehaviorTraces::beganAnew() {
  const std::uint64_t beginnings = session_.status().beginnings;
  if (std::exchange(beginnings_, beginnings) == beginnings) return false;
  collector_->forget();
  return true;
}

}  // namespace gt
