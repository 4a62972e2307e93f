#pragma once
#include <functional>
#include <utility>

#include "observer/RobotLink.h"
#include "robot/Robot.h"

namespace gt {

/// The message queues of a robot whose processes run in this program. The robot must outlive the
/// link. `answered` is called when the robot has carried out messages.
class LocalLink : public RobotLink {
 public:
  explicit LocalLink(Robot& robot, std::function<void()> answered = {})
      : robot_{robot}, answered_{std::move(answered)} {}
  MessageQueue& toRobot() override { return robot_.fromTools(); }
  void exchange(const Taker& take) override {
    robot_.answer();
    if (answered_) answered_();
    take(robot_.toTools());
    robot_.toTools().clear();
  }
  std::optional<ConstValue> peek(std::string_view representation) const override {
    return robot_.value(representation);
  }

 private:
  Robot& robot_;
  std::function<void()> answered_;
};

}  // namespace gt
