#pragma once
#include <chrono>
#include <functional>

#include "streams/MessageQueue.h"

namespace gt {

/// Where a robot's processes run (report 5.2): in this program, fed by the simulator or by a log,
/// or elsewhere.
enum class RobotKind { simulated, physical };

/// The message queues to and from a robot, wherever it runs. Provided by the simulator, by logs,
/// and by connections to programs elsewhere; used by ObservedRobot.
class RobotLink {
 public:
  using Taker = std::function<void(const MessageQueue&)>;

  virtual ~RobotLink() = default;
  virtual RobotKind kind() const { return RobotKind::simulated; }
  /// Messages for the robot's processes.
  virtual MessageQueue& toRobot() = 0;
  /// Has the robot carry out these messages, and hands over what it has sent. A robot of this
  /// program answers at once, between two of its cycles. One elsewhere has sent what it has sent;
  /// its answers follow.
  virtual void exchange(const Taker& take) = 0;
  /// How long an answer may take.
  virtual std::chrono::milliseconds patience() const { return {}; }
};

}  // namespace gt
