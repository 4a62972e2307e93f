#include "match/RemoteRobot.h"

#include <algorithm>
#include <cmath>

#include "match/BodyCommands.h"

namespace gt {
namespace {

/// No robot of this kind walks or turns faster; what would is no step but a new start.
constexpr double mostSpeed = 2.0;     // mm in 1 ms
constexpr double mostTurning = 0.02;  // rad in 1 ms
/// A robot that gives no commands for so long is off: it gives them in each frame.
constexpr std::int64_t offAfter = 2000;  // ms

}  // namespace

RemoteRobot::RemoteRobot() : wire_{network_, platformProcess} {}

template <typename T>
void RemoteRobot::receive(ReceivedPackage<T>& in, const Plan& plan) {
  if (const std::string from = senderOf(plan, representation<T>()); !from.empty())
    wire_.receive(from, in.receiver);
}

Result<std::unique_ptr<RemoteRobot>> RemoteRobot::make(const RobotAddresses& addresses,
                                                       const Plan& plan,
                                                       const std::optional<Keys>& keys) {
  std::unique_ptr<RemoteRobot> robot{new RemoteRobot};
  robot->name_ = addresses.robot;
  if (auto done = makePrivateFolder(addresses.folder); !done) return done.error();
  if (auto done = robot->wire_.listen(addresses.endpoint(platformProcess), keys); !done)
    return done.error();
  std::apply([&](auto&... inputs) { (robot->wire_.provide(inputs.sender), ...); }, robot->inputs_);
  std::apply([&](auto&... commands) { (robot->receive(commands, plan), ...); }, robot->commands_);
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

bool RemoteRobot::isOn() const {
  return commandedAt_ != never() && now_ - commandedAt_ < offAfter;
}

void RemoteRobot::send(const RobotInput& input) {
  input.forEach([this]<typename T>(const T& package) {
    SentPackage<T>& out = std::get<SentPackage<T>>(inputs_);
    if (&out.value != &package) out.value = package;  // the image lies there already
    out.sender.send();
  });
  std::apply([](auto&... inputs) { (inputs.sender.sendLater(), ...); }, inputs_);
}

void RemoteRobot::takeCommands(const RobotInput& input, RobotOutput& output) {
  auto& joints = command<JointData>();
  auto& odometry = command<OdometryData>();
  auto& leds = command<LedValue>();
  auto& message = command<TeamMessage>();
  const bool newJoints = joints.take();
  now_ = input.now;
  if (newJoints) commandedAt_ = now_;
  if (newJoints && isSane(joints.value)) output.joints = joints.value;
  if (leds.take()) output.leds = leds.value;
  if (auto& gains = command<JointGains>(); gains.take() && isSane(gains.value))
    output.gains = gains.value;
  if (auto& speaker = command<Speaker>(); speaker.take()) output.speaker = speaker.value;
  if (odometry.take() && isSane(odometry.value)) walk(odometry.value, input, output);
  if (auto& camera = command<CameraSettings>(); camera.take() && camera_ != camera.value)
    output.camera = camera_ = camera.value;
  pose_.take();
  ball_.take();
  state_.take();
  if (motion_.take()) output.specialAction = motion_.value.executed.specialAction;
  if (statistics_.frames > 0 || newJoints) {
    ++statistics_.frames;
    statistics_.missedFrames += !newJoints;
  }

  newMessage_ |= message.take();
  if (!input.image) return;
  if (newMessage_ && isSane(message.value) && ++images_ % imagesPerTeamMessage == 0)
    output.message = message.value;
  if (statistics_.pictures > 0 || newMessage_) {
    ++statistics_.pictures;
    statistics_.missedPictures += !newMessage_;
  }
  newMessage_ = false;
}

/// Goes on from where the robot is: after a new start its own odometry begins at the origin.
void RemoteRobot::walk(const OdometryData& odometry, const RobotInput& input, RobotOutput& output) {
  const Pose2D step = odometry.pose.relativeTo(walked_);
  const auto time = static_cast<double>(input.now - walkedAt_);
  const bool possible = step.translation.norm() <= mostSpeed * std::min(time, 200.0) &&
                        std::abs(step.rotation) <= mostTurning * std::min(time, 200.0);
  if (possible && walkedAt_ != never()) output.odometry.pose = output.odometry.pose * step;
  walked_ = odometry.pose;
  walkedAt_ = input.now;
}

}  // namespace gt
