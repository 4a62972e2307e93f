#include "match/RemoteRobot.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gt {
namespace {

/// No robot of this kind walks or turns faster; what would is no step but a new start.
constexpr double mostSpeed = 2.0;     // mm in 1 ms
constexpr double mostTurning = 0.02;  // rad in 1 ms

bool isSane(double value, double most) {
  return std::abs(value) <= most;  // not so for NaN
}

bool isSane(const Pose2D& pose) {
  constexpr double farAway = 1e6;  // mm
  return isSane(pose.rotation, farAway) && isSane(pose.translation.x(), farAway) &&
         isSane(pose.translation.y(), farAway);
}

bool isSane(const JointData& joints) {
  return std::ranges::all_of(joints.angles.values,
                             [](double angle) { return isSane(angle, std::numbers::pi); });
}

bool isSane(const TeamMessage& message) {
  return isSane(message.robotPose) && isSane({0, message.ballPosition}) &&
         isSane(message.robotPoseValidity, 1) &&
         !std::isnan(message.behavior.estimatedTimeToReachBall);
}

/// The process that provides a representation; empty if none does.
std::string providerOf(const Plan& plan, const RepresentationType& type) {
  for (const Plan::Process& process : plan.processes)
    for (const Plan::Step& step : process.order)
      if (std::ranges::find(step.task->outputs, &type) != step.task->outputs.end())
        return process.layout.name;
  return "";
}

}  // namespace

RemoteRobot::RemoteRobot() : wire_{network_, platformProcess} {}

template <typename T>
void RemoteRobot::receive(In<T>& in, const Plan& plan) {
  in.from = providerOf(plan, representation<T>());
  if (!in.from.empty()) wire_.receive(in.from, in.receiver);
}

Result<std::unique_ptr<RemoteRobot>> RemoteRobot::make(const RobotAddresses& addresses,
                                                       const Plan& plan,
                                                       const std::optional<Keys>& keys) {
  std::unique_ptr<RemoteRobot> robot{new RemoteRobot};
  robot->name_ = addresses.robot;
  if (auto done = makePrivateFolder(addresses.folder); !done) return done.error();
  if (auto done = robot->wire_.listen(addresses.endpoint(platformProcess), keys); !done)
    return done.error();
  for (PackageSender* sender : {&robot->sensors_.sender, &robot->image_.sender,
                                &robot->game_.sender, &robot->team_.sender, &robot->oracle_.sender})
    robot->wire_.provide(*sender);
  robot->receive(robot->joints_, plan);
  robot->receive(robot->odometry_, plan);
  robot->receive(robot->leds_, plan);
  robot->receive(robot->message_, plan);
  robot->receive(robot->pose_, plan);
  robot->receive(robot->ball_, plan);
  robot->receive(robot->state_, plan);
  robot->receive(robot->motion_, plan);
  return robot;
}

void RemoteRobot::cycle(const RobotInput& input, RobotOutput& output) {
  network_.now = input.now;
  network_.wait(0);
  wire_.takeIn();
  takeCommands(input, output);
  wire_.askForMore();
  send(input);
}

void RemoteRobot::send(const RobotInput& input) {
  sensors_.value = input.sensors;
  sensors_.sender.send();
  if (input.image) {
    game_.value = input.game;
    team_.value = input.team;
    oracle_.value = input.oracle;
    image_.value = *input.image;
    // The picture last: it starts a cycle, which shall have all that belongs to it.
    for (PackageSender* sender : {&game_.sender, &team_.sender, &oracle_.sender, &image_.sender})
      sender->send();
  }
  for (PackageSender* sender :
       {&sensors_.sender, &game_.sender, &team_.sender, &oracle_.sender, &image_.sender})
    sender->sendLater();
}

void RemoteRobot::takeCommands(const RobotInput& input, RobotOutput& output) {
  const bool newJoints = joints_.take();
  if (newJoints && isSane(joints_.value)) output.joints = joints_.value;
  if (leds_.take()) output.leds = leds_.value;
  if (odometry_.take() && isSane(odometry_.value.pose)) walk(input, output);
  pose_.take();
  ball_.take();
  state_.take();
  motion_.take();
  if (statistics_.frames > 0 || newJoints) {
    ++statistics_.frames;
    statistics_.missedFrames += !newJoints;
  }

  newMessage_ |= message_.take();
  if (!input.image) return;
  if (newMessage_ && isSane(message_.value) && ++pictures_ % picturesPerTeamMessage == 0)
    output.message = message_.value;
  if (statistics_.pictures > 0 || newMessage_) {
    ++statistics_.pictures;
    statistics_.missedPictures += !newMessage_;
  }
  newMessage_ = false;
}

/// Goes on from where the robot is: after a new start its own odometry begins at the origin.
void RemoteRobot::walk(const RobotInput& input, RobotOutput& output) {
  const Pose2D step = odometry_.value.pose.relativeTo(walked_);
  const auto time = static_cast<double>(input.now - walkedAt_);
  const bool possible = isSane(step.translation.norm(), mostSpeed * std::min(time, 200.0)) &&
                        isSane(step.rotation, mostTurning * std::min(time, 200.0));
  if (possible && walkedAt_ != never()) output.odometry.pose = output.odometry.pose * step;
  walked_ = odometry_.value.pose;
  walkedAt_ = input.now;
}

}  // namespace gt
