#pragma once
#include <unistd.h>

#include <memory>
#include <string>
#include <vector>

#include "base/TemporaryFolder.h"
#include "network/RobotAddresses.h"
#include "network/Wire.h"
#include "robot/Robot.h"
#include "robot/Solutions.h"
#include "robot/platform/Body.h"

namespace gt::testing {

/// A robot with a body that sees gray images, whose joints follow and which reports what it was
/// commanded. It runs in steps of 8 ms; all requests and answers go by messages.
class SteppedRobot {
 public:
  virtual ~SteppedRobot() = default;

  /// Runs for some ms.
  void runFor(std::int64_t ms) {
    for (const Time end = input_.now + ms; input_.now < end;) {
      input_.now = input_.now + 8;
      SensorData frame = input_.sensors.newest();
      frame.time = input_.now;
      frame.joints = output.joints.angles;
      frame.acceleration = {0, 0, 9810};
      input_.sensors.push(frame);
      image.time = input_.now;
      input_.image = input_.now.ms % 40 == 0 ? &image : nullptr;
      step(input_);
    }
  }
  /// Runs until something holds; false if it does not in time.
  template <typename Condition>
  bool runUntil(Condition condition, std::int64_t ms = 100'000) {
    for (const Time end = input_.now + ms; input_.now < end; runFor(8))
      if (condition()) return true;
    return condition();
  }
  template <typename Request>
  void ask(const Request& request) {
    fromTools().write(input_.now, request);
  }

  virtual MessageQueue& fromTools() = 0;
  virtual MessageQueue& toTools() = 0;

  Image image;
  RobotOutput output;  ///< The robot's commands.

 protected:
  SteppedRobot() { image.allocate(); }
  virtual void step(const RobotInput& input) = 0;

 private:
  RobotInput input_;
};

/// All of its processes in this program.
class RobotInOneProgram : public SteppedRobot {
 public:
  explicit RobotInOneProgram(const RobotSetup& setup) : robot_{std::move(*Robot::make(setup))} {}
  MessageQueue& fromTools() override { return robot_->fromTools(); }
  MessageQueue& toTools() override { return robot_->toTools(); }
  Robot& robot() { return *robot_; }

 protected:
  void step(const RobotInput& input) override {
    input.forEach([this](const auto& package) { robot_->send(package); });
    robot_->step(input.now);
    if (const auto* joints = robot_->provided<JointData>()) output.joints = *joints;
    if (const auto* camera = robot_->provided<CameraSettings>()) output.camera = *camera;
  }

 private:
  std::unique_ptr<Robot> robot_;
};

/// Each process with a network of its own, as if it were a program of its own; and so the body.
class RobotAsPrograms : public SteppedRobot {
 public:
  explicit RobotAsPrograms(const RobotSetup& setup) {
    const RobotAddresses addresses{folder_.path().string(), "robot", {}};
    std::vector<std::string> before{platformProcess};
    body_ = std::make_unique<Body>(addresses, setup);
    for (const ProcessLayout& process : setup.layout.processes) {
      auto& part = *parts_.emplace_back(std::make_unique<Part>(addresses, setup, process, before));
      if (process.collectsMessages) debug_ = part.robot.get();
      before.push_back(process.name);
    }
  }
  MessageQueue& fromTools() override { return debug_->fromTools(); }
  MessageQueue& toTools() override { return debug_->toTools(); }

 protected:
  /// Lets packages go to and fro for a while: real time passes between programs.
  void step(const RobotInput& input) override {
    body_->send(input);
    for (int round = 0; round < 4; ++round) {
      body_->exchange(input.now, output);
      for (const auto& part : parts_) part->step();
      usleep(500);
    }
  }

 private:
  struct Part {
    Part(const RobotAddresses& addresses, const RobotSetup& setup, const ProcessLayout& process,
         const std::vector<std::string>& before)
        : wire{network, process.name},
          isDebug{process.collectsMessages},
          robot{std::move(*Robot::make(setup, allModules(), {process.name}))} {
      static_cast<void>(wire.listen(addresses.endpoint(process.name)));
      for (const std::string& peer : before)
        static_cast<void>(wire.connect(peer, addresses.endpoint(peer)));
      robot->join(wire);
    }
    void step() {
      network.wait(0);
      wire.takeIn();
      network.now = isDebug ? Time{network.elapsed()} : wire.clockOf(platformProcess).time;
      robot->step(network.now);
      wire.askForMore();
    }
    Network network;
    Wire wire;
    bool isDebug;
    std::unique_ptr<Robot> robot;
  };

  struct Body {
    Body(const RobotAddresses& addresses, const RobotSetup& setup)
        : wire{network, platformProcess} {
      static_cast<void>(wire.listen(addresses.endpoint(platformProcess)));
      std::apply([&](auto&... out) { (wire.provide(out.sender), ...); }, inputs);
      const Plan plan = *robotPlan(setup.layout, setup.platform);
      const auto receive = [&](auto& in) {
        if (const std::string from = senderOf(plan, in.receiver.type()); !from.empty())
          wire.receive(from, in.receiver);
      };
      std::apply([&](auto&... in) { (receive(in), ...); }, commands);
    }
    void send(const RobotInput& input) {
      input.forEach([this]<typename T>(const T& package) {
        std::get<SentPackage<T>>(inputs).value = package;
        std::get<SentPackage<T>>(inputs).sender.send();
      });
    }
    void exchange(Time now, RobotOutput& output) {
      network.now = now;
      network.wait(0);
      wire.takeIn();
      if (auto& joints = std::get<ReceivedPackage<JointData>>(commands); joints.take())
        output.joints = joints.value;
      if (auto& camera = std::get<ReceivedPackage<CameraSettings>>(commands); camera.take())
        output.camera = camera.value;
      wire.askForMore();
      std::apply([](auto&... out) { (out.sender.sendLater(), ...); }, inputs);
    }
    Network network;
    Wire wire;
    InputSlots<SentPackage> inputs;
    CommandSlots<ReceivedPackage> commands;
  };

  const TemporaryFolder folder_;
  std::unique_ptr<Body> body_;
  std::vector<std::unique_ptr<Part>> parts_;
  Robot* debug_ = nullptr;
};

}  // namespace gt::testing
