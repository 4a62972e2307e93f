#include "match/RemoteRobot.h"

#include <algorithm>
#include <cmath>

#include "match/BodyCommands.h"

namespace gt {
namespace {

/// Greatest speeds of a robot; a step that would be faster comes from a restart of its program.
constexpr double mostSpeed = 2.0;     // mm in 1 ms
constexpr double mostTurning = 0.02;  // rad in 1 ms
/// Time without commands after which a robot is off; otherwise it gives them in each frame.
constexpr std::int64_t offAfter = 2000;  // ms

}  // namespace

RemoteRobot::RemoteRobot() : wire_{network_, platformProcess} {}

template <typename T>
bool RemoteRobot::receive(ReceivedPackage<T>& in, const Plan& plan) {
  const std::string from = senderOf(plan, representation<T>());
  if (from.empty()) return false;
  wire_.receive(from, in.receiver);
  return true;
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
  robot->belief_.forEach([&]<typename T>(const T*& part) {
    auto& in = std::get<ReceivedPackage<T>>(robot->believed_);
    if (robot->receive(in, plan)) part = &in.value;
  });
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
  now_ = input.now;
  output.forEach([&](auto& command) { take(command, input); });
  std::apply([](auto&... parts) { (parts.take(), ...); }, believed_);
  if (belief_.motion) output.specialAction = belief_.motion->executed.specialAction;
}

template <typename T>
void RemoteRobot::take(T& command, const RobotInput&) {
  auto& in = received<T>();
  if (in.take() && isSane(in.value)) command = in.value;
}

void RemoteRobot::take(JointData& joints, const RobotInput& input) {
  auto& in = received<JointData>();
  const bool isNew = in.take();
  if (isNew) commandedAt_ = input.now;
  if (isNew && isSane(in.value)) joints = in.value;
  if (statistics_.frames > 0 || isNew) {
    ++statistics_.frames;
    statistics_.missedFrames += !isNew;
  }
}

/// Continues from the robot's present pose: after a restart its own odometry begins at the origin.
void RemoteRobot::take(OdometryData& odometry, const RobotInput& input) {
  auto& in = received<OdometryData>();
  if (!in.take() || !isSane(in.value)) return;
  const Pose2D step = in.value.pose.relativeTo(walked_);
  const double time = std::min(static_cast<double>(input.now - walkedAt_), 200.0);
  const bool possible =
      step.translation.norm() <= mostSpeed * time && std::abs(step.rotation) <= mostTurning * time;
  if (possible && walkedAt_ != never()) odometry.pose = odometry.pose * step;
  walked_ = in.value.pose;
  walkedAt_ = input.now;
}

void RemoteRobot::take(std::optional<TeamMessage>& message, const RobotInput& input) {
  auto& in = received<TeamMessage>();
  newMessage_ |= in.take();
  if (!input.image) return;
  if (newMessage_ && isSane(in.value) && ++images_ % imagesPerTeamMessage == 0) message = in.value;
  if (statistics_.pictures > 0 || newMessage_) {
    ++statistics_.pictures;
    statistics_.missedPictures += !newMessage_;
  }
  newMessage_ = false;
}

void RemoteRobot::take(std::optional<CameraSettings>& settings, const RobotInput&) {
  auto& in = received<CameraSettings>();
  if (in.take() && camera_ != in.value) settings = camera_ = in.value;
}

}  // namespace gt
