#pragma once
#include <memory>
#include <optional>
#include <string>

#include "console/Recording.h"
#include "modules/behavior/control/BehaviorControlRequest.h"
#include "observer/ObservedRobot.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/MotionRequest.h"
#include "robot/Configuration.h"

namespace gt {

class SimulatedRobot;

/// A robot as a console knows it, wherever its processes run: in the simulator, on a log, or as
/// programs elsewhere. Provided by the Session.
class ConsoleRobot {
 public:
  ConsoleRobot(std::string name, std::unique_ptr<RobotLink> link);
  virtual ~ConsoleRobot() = default;
  ConsoleRobot(const ConsoleRobot&) = delete;
  ConsoleRobot& operator=(const ConsoleRobot&) = delete;

  const std::string& name() const { return observed_.name(); }
  /// What is known of it, and what it can be asked.
  ObservedRobot& observed() { return observed_; }
  /// Its index among the scene's active robots, if it is one of them.
  virtual std::optional<std::size_t> index() const { return std::nullopt; }
  /// The same as its platform; null if it is none of them.
  virtual SimulatedRobot* simulated() { return nullptr; }
  /// Lives up to a time of the session; an error if it cannot.
  virtual Result<void> step(Time) { return {}; }

  Recording recording;
  /// What was asked of the robot last by hand, so that a part of it can be changed.
  MotionRequest motion;
  BehaviorControlRequest behavior;
  std::optional<HeadMode> headMode;
  bool printsTexts = true;  ///< Report I.5.3: msg.

 private:
  ObservedRobot observed_;
};

/// A robot of a scene.
std::unique_ptr<ConsoleRobot> makeSimulatedRobot(SimulatedRobot& robot, std::size_t index);

/// A robot that lives on a log from a time of the session on (report I.5.1: sl): a log of this
/// system (.mcap) or one of a real robot of 2009.
Result<std::unique_ptr<ConsoleRobot>> makeLogRobot(const std::string& name, const std::string& file,
                                                   const Configuration& configuration, Time begin,
                                                   const DataRoot& root);

}  // namespace gt
