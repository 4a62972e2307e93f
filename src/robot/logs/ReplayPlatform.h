#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "robot/Robot.h"
#include "robot/RobotLog.h"
#include "streams/Mcap.h"
#include "streams/MessageDefinition.h"

namespace gt {

/// How a log is replayed; by default as it was recorded.
struct ReplayOptions {
  std::string log;
  /// Another configuration than the log's own, where it has one.
  std::shared_ptr<const Configuration> configuration{};
  std::string layout{};  ///< Another layout; needed where the log has none.
  /// Other solutions of tasks.
  std::vector<Configuration::SolutionChoice> solutions{};
};

/// The platform of a robot that lives on a log: sends what the log's robot got from its platform
/// (/input/…), at the recorded times, into whatever modules the layout has, as fast as it goes.
/// With the same modules all that they compute is the same, bit for bit. Recorded types may have
/// changed since: they are read by name.
class ReplayPlatform {
 public:
  static Result<ReplayPlatform> make(const ReplayOptions& options);

  /// Sends what belongs to the next moment and lets the robot step; false at the log's end.
  Result<bool> step();
  Time now() const { return now_; }
  Robot& robot() { return *robot_; }
  /// What the robot sends to its tools: the recorded representations that it has, too, and all that
  /// its modules compute.
  const std::vector<const RepresentationType*>& watched() const { return watched_; }

 private:
  /// A recorded channel that the platform sends.
  struct Input {
    const RepresentationType* type;
    std::optional<MessageDefinition> definition;  ///< If the recorded type is another one.
    std::shared_ptr<void> value;
  };

  ReplayPlatform(std::string path, McapReader log) : path_{std::move(path)}, log_{std::move(log)} {}
  Result<void> findInputs();
  Result<void> makeRobot(const ReplayOptions& options);
  void watchAll();
  Result<void> send(const McapMessage& message);

  std::string path_;
  McapReader log_;
  std::unique_ptr<Robot> robot_;
  std::vector<std::optional<Input>> inputs_;  ///< By the channels' ids.
  std::vector<const RepresentationType*> watched_;
  std::optional<McapMessage> message_;  ///< The first of the next moment.
  Time now_;
};

}  // namespace gt
