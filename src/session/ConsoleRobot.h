#pragma once
#include <memory>
#include <optional>
#include <string>

#include "observer/ObservedRobot.h"
#include "observer/Recorder.h"
#include "observer/robots/LogRobot.h"
#include "representations/behavior/BehaviorControlRequest.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"

namespace gt {

class SimulatedRobot;

/// A robot that a console works on, wherever its processes run: in the simulator, on a log, or as
/// programs elsewhere. Provided by the Session.
class ConsoleRobot {
 public:
  ConsoleRobot(std::string name, std::unique_ptr<RobotLink> link)
      : observed_{std::move(name), std::move(link)} {}
  virtual ~ConsoleRobot() = default;
  ConsoleRobot(const ConsoleRobot&) = delete;
  ConsoleRobot& operator=(const ConsoleRobot&) = delete;

  const std::string& name() const { return observed_.name(); }
  /// Access to the values that it reports and to the requests that it accepts.
  ObservedRobot& observed() { return observed_; }
  /// Its index among the scene's active robots, if it is one of them.
  virtual std::optional<std::size_t> index() const { return std::nullopt; }
  /// Its platform if it runs in the simulator of this program; otherwise null.
  virtual SimulatedRobot* simulated() { return nullptr; }
  /// The log that it runs on; null if it runs on none.
  virtual LogRobot* onLog() { return nullptr; }
  /// Runs up to a time of the session; an error if it cannot.
  virtual Result<void> step(Time) { return {}; }
  /// Takes messages from the robot.
  virtual void take(const MessageQueue& messages) { observed_.take(messages); }

 private:
  ObservedRobot observed_;

 public:
  Recorder recorder{observed_};
  /// The last requests to the robot by hand, so that a part of them can be changed.
  MotionRequest motion;
  BehaviorControlRequest behavior;
  std::optional<HeadMode> headMode;
  int sequences = 0;        ///< Number of sequences of joint data sent to it.
  bool printsTexts = true;  ///< Report I.5.3: msg.
};

/// A robot of a scene.
std::unique_ptr<ConsoleRobot> makeSimulatedRobot(SimulatedRobot& robot, std::size_t index);

/// A robot that runs on a log from a time of the session on (report I.5.1: sl): a log of this
/// system (.mcap) or one of a real robot of 2009.
Result<std::unique_ptr<ConsoleRobot>> makeLogRobot(const std::string& name, const std::string& file,
                                                   const LogRobotOptions& options, Time begin);

}  // namespace gt
