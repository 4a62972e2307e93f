#pragma once
#include <optional>
#include <string>
#include <tuple>

#include "framework/Package.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/SoundRequest.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/CameraSettings.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/JointGains.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"

namespace gt {

/// What a robot gets from its body in one tick: packages, as from sensors, camera and network. The
/// one list of them: simulator, programs on a wire, logs and recorders follow from it.
struct RobotInput {
  Time now;
  SensorDataBuffer sensors;
  const Image* image = nullptr;  ///< Null in ticks without an image; valid during the cycle only.
  GameControlData game;
  TeamMessages team;
  /// The truth, with each image. No body senses it, so it is in none of the lists: the simulator
  /// hands it on to robots that were given it by name (SimulatedRobot::giveTruth).
  OracledWorldState oracle;

  /// What comes in each tick, and what comes with each image; the image last: it starts a
  /// cycle, which shall have all that belongs to it.
  static constexpr auto eachTick() { return std::tuple{&RobotInput::sensors}; }
  static constexpr auto eachImage() {
    return std::tuple{&RobotInput::game, &RobotInput::team, &RobotInput::image};
  }

  /// Hands over the packages of this tick in their order, take(package); those of an image only if
  /// there is one and it is wanted.
  template <typename Take>
  void forEach(Take&& take, bool withImage = true) const;
};

/// What a robot gives to its body. It stays as it is until a cycle changes it; `message` and
/// `camera` are empty before each cycle.
struct RobotOutput {
  JointData joints;
  OdometryData odometry;  ///< Moves the robot, in the kinematic fidelity: its change is the step.
  LedValue leds;
  JointGains gains{};
  Speaker speaker{};
  /// The special action that is performed, or none: in the kinematic fidelity kicks play the ball
  /// as their table says. No body takes it, so it is in no list.
  std::string specialAction{};
  std::optional<TeamMessage> message;
  std::optional<CameraSettings> camera;  ///< If the camera shall be set in another way.

  static constexpr auto commands() {
    return std::tuple{&RobotOutput::joints, &RobotOutput::odometry, &RobotOutput::leds,
                      &RobotOutput::gains,  &RobotOutput::speaker,  &RobotOutput::message,
                      &RobotOutput::camera};
  }
  /// Visits each command, visit(command); those that not each cycle gives are optional.
  template <typename Visit>
  void forEach(Visit&& visit) {
    std::apply([&](auto... commands) { (visit(this->*commands), ...); }, commands());
  }
};

/// What a robot believes and does, as it is at the end of its last cycle, for who watches it; null
/// what it does not provide.
struct Belief {
  const RobotPose* pose = nullptr;
  const BallModel* ball = nullptr;
  const RobotState* state = nullptr;
  const MotionInfo* motion = nullptr;

  static constexpr auto parts() {
    return std::tuple{&Belief::pose, &Belief::ball, &Belief::state, &Belief::motion};
  }
  /// Visits each part, visit(part), with the type of its value.
  template <typename Visit>
  void forEach(Visit&& visit) {
    std::apply([&](auto... parts) { (visit(this->*parts), ...); }, parts());
  }
};

namespace detail {

template <typename T>
struct PackageType {
  using Type = T;
};
template <typename T>
struct PackageType<const T*> {
  using Type = T;
};
template <typename T>
struct PackageType<std::optional<T>> {
  using Type = T;
};
template <typename Member>
struct PackageOfMember;
template <typename Body, typename T>
struct PackageOfMember<T Body::*> : PackageType<T> {};

template <typename T>
const T& packageIn(const T& value) {
  return value;
}
template <typename T>
const T& packageIn(const T* value) {
  return *value;
}

template <template <typename> class Slot, typename... Members>
std::tuple<Slot<typename PackageOfMember<Members>::Type>...> slotsFor(std::tuple<Members...>);

}  // namespace detail

/// A tuple with a Slot<T> for each package that a body sends or takes.
template <template <typename> class Slot>
using InputSlots = decltype(detail::slotsFor<Slot>(
    std::tuple_cat(RobotInput::eachTick(), RobotInput::eachImage())));
template <template <typename> class Slot>
using CommandSlots = decltype(detail::slotsFor<Slot>(RobotOutput::commands()));
/// The same for what is believed.
template <template <typename> class Slot>
using BeliefSlots = decltype(detail::slotsFor<Slot>(Belief::parts()));

/// A package with the sender or the receiver by which a body exchanges it with the robot's
/// processes.
template <typename T>
struct SentPackage {
  T value;
  PackageSender sender{representation<T>(), &value};
};
template <typename T>
struct ReceivedPackage {
  T value;
  PackageReceiver receiver{representation<T>(), &value};

  /// Whether a new one has come since the last call.
  bool take() {
    receiver.receive();
    receiver.request();
    return receiver.receivedNew();
  }
};

template <typename Take>
void RobotInput::forEach(Take&& take, bool withImage) const {
  const auto all = [&](auto... members) { (take(detail::packageIn(this->*members)), ...); };
  std::apply(all, eachTick());
  if (image && withImage) std::apply(all, eachImage());
}

}  // namespace gt
