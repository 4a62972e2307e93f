#pragma once
#include <chrono>
#include <functional>
#include <optional>
#include <string_view>

#include "streams/MessageQueue.h"
#include "streams/Type.h"

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
  /// A representation as it is now, where the robot's memory is in this program: neither sent nor
  /// copied. Valid until the robot's next cycle. Empty if it lies elsewhere, or does not exist.
  virtual std::optional<ConstValue> peek(std::string_view /*representation*/) const { return {}; }
  /// Greatest time (ms) to wait for an answer.
  virtual std::chrono::milliseconds patience() const { return {}; }
};

}  // namespace gt
