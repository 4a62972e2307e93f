#pragma once
#include <memory>
#include <optional>
#include <string>

#include "console/RobotMemory.h"
#include "modules/behavior/control/BehaviorControlRequest.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "robot/Robot.h"

namespace gt {

class SimulatedRobot;

/// A robot as a console knows it, wherever its processes run: in the simulator, on a log, or as
/// programs elsewhere. Provided by the Session.
class ConsoleRobot {
 public:
  explicit ConsoleRobot(std::string name) : name_{std::move(name)} {}
  virtual ~ConsoleRobot() = default;
  ConsoleRobot(const ConsoleRobot&) = delete;
  ConsoleRobot& operator=(const ConsoleRobot&) = delete;

  const std::string& name() const { return name_; }
  /// The robot, if its processes run in this program; null otherwise.
  virtual Robot* robot() { return nullptr; }
  /// Its index among the scene's active robots, if it is one of them.
  virtual std::optional<std::size_t> index() const { return std::nullopt; }
  /// The same as its platform; null if it is none of them.
  virtual SimulatedRobot* simulated() { return nullptr; }
  /// Messages that go to its processes.
  virtual MessageQueue& fromTools() = 0;
  /// Lives up to a time of the session; an error if it cannot.
  virtual Result<void> step(Time) { return {}; }

  /// Hands over a request: at once, with an error if it makes no sense, or as a message.
  template <typename Request>
  Result<void> request(const Request& request) {
    if (Robot* here = robot()) return here->request(request);
    return send(request);
  }
  /// Sends a message to the robot's processes; an error if there is no room for it.
  template <typename T>
  Result<void> send(const T& message) {
    if (fromTools().write({}, message)) return {};
    return Error{"", 0, name_, "the robot has not taken its last messages yet"};
  }

  RobotMemory& memory() { return memory_; }
  /// What was asked of the robot last by hand, so that a part of it can be changed.
  MotionRequest motion;
  BehaviorControlRequest behavior;
  std::optional<HeadMode> headMode;
  bool printsTexts = true;  ///< Report I.5.3: msg.

 private:
  std::string name_;
  RobotMemory memory_;
};

/// A robot of a scene.
std::unique_ptr<ConsoleRobot> makeSimulatedRobot(SimulatedRobot& robot, std::size_t index);

/// A robot that lives on a log from a time of the session on (report I.5.1: sl): a log of this
/// system (.mcap) or one of a real robot of 2009.
Result<std::unique_ptr<ConsoleRobot>> makeLogRobot(const std::string& name, const std::string& file,
                                                   const Configuration& configuration, Time begin);

}  // namespace gt
