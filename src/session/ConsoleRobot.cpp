#include "session/ConsoleRobot.h"

#include "match/SimulatedRobot.h"

namespace gt {
namespace {

class RobotOfScene : public ConsoleRobot {
 public:
  RobotOfScene(SimulatedRobot& robot, std::size_t index)
      : ConsoleRobot{robot.name(), robot.link()}, robot_{robot}, index_{index} {
    robot_.observe([this](const MessageQueue& messages) { take(messages); });
  }
  std::optional<std::size_t> index() const override { return index_; }
  SimulatedRobot* simulated() override { return &robot_; }

 private:
  SimulatedRobot& robot_;
  std::size_t index_;
};

/// A robot that runs on a log, which is played as the session's time passes.
class RobotOnLog : public ConsoleRobot {
 public:
  RobotOnLog(const std::string& name, Time begin, std::unique_ptr<LogRobot> robot)
      : ConsoleRobot{name, robot->link()}, robot_{std::move(robot)}, time_{begin} {}

  ~RobotOnLog() override { recorder.stop(); }

  LogRobot* onLog() override { return robot_.get(); }
  Result<void> step(Time now) override {
    const auto passed = static_cast<double>(now - std::exchange(time_, now));
    const bool before = robot_->player().atEnd();
    if (auto done = robot_->pass(passed, [this](const auto& queue) { take(queue); }); !done)
      return done;
    if (const auto warning = robot_->takeWarning()) return *warning;
    if (before || !robot_->player().atEnd() || robot_->player().loop()) return {};
    return Error{.field = name(), .what = "its log has ended"};
  }
  void take(const MessageQueue& messages) override {
    if (std::exchange(beginnings_, robot_->beginnings()) != robot_->beginnings())
      observed().forget();
    ConsoleRobot::take(messages);
  }

 private:
  std::unique_ptr<LogRobot> robot_;
  Time time_;
  int beginnings_ = 0;
};

}  // namespace

std::unique_ptr<ConsoleRobot> makeSimulatedRobot(SimulatedRobot& robot, std::size_t index) {
  return std::make_unique<RobotOfScene>(robot, index);
}

Result<std::unique_ptr<ConsoleRobot>> makeLogRobot(const std::string& name, const std::string& file,
                                                   const LogRobotOptions& options, Time begin) {
  auto robot = LogRobot::open(file, options);
  if (!robot) return robot.error();
  return std::unique_ptr<ConsoleRobot>{
      std::make_unique<RobotOnLog>(name, begin, std::move(*robot))};
}

}  // namespace gt
