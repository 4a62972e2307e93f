#pragma once
#include <chrono>
#include <functional>

#include "streams/MessageQueue.h"

namespace gt {

/// The place where a robot's processes run (report 5.2): in this program, with input from the
/// simulator or a log, or in other programs.
enum class RobotKind { simulated, physical };

/// The message queues to and from a robot, wherever it runs. Implemented by the simulator, by logs,
/// and by connections to other programs; used by ObservedRobot.
class RobotLink {
 public:
  using Taker = std::function<void(const MessageQueue&)>;

  virtual ~RobotLink() = default;
  virtual RobotKind kind() const { return RobotKind::simulated; }
  /// Messages for the robot's processes.
  virtual MessageQueue& toRobot() = 0;
  /// Sends the messages to the robot, and passes its messages to `take`. A robot in this program
  /// answers immediately, between two of its cycles. For a robot in another program, the messages
  /// received so far are passed; its answers follow later.
  virtual void exchange(const Taker& take) = 0;
  /// Greatest time (ms) to wait for an answer.
  virtual std::chrono::milliseconds patience() const { return {}; }
};

}  // namespace gt
