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

/// The packages that a robot receives from its body in one tick, from sensors, camera and network.
/// This is the only list of them: simulator, programs on a wire, logs and recorders use it.
struct RobotInput {
  Time now;
  SensorDataBuffer sensors;
  const Image* image = nullptr;  ///< Null in ticks without an image; valid during the cycle only.
  GameControlData game;
  TeamMessages team;
  /// Ground truth, with each image. It is in none of the lists, because no body measures it. The
  /// simulator passes it to robots for which it was explicitly requested
  /// (SimulatedRobot::giveTruth).
  OracledWorldState oracle;

  /// The packages of each tick, and those of each image. The image comes last, because it starts a
  /// cycle that needs all the other packages.
  static constexpr auto eachTick() { return std::tuple{&RobotInput::sensors}; }
  static constexpr auto eachImage() {
    return std::tuple{&RobotInput::game, &RobotInput::team, &RobotInput::image};
  }

  /// Calls take(package) for the packages of this tick in their order. The packages of an image are
  /// included only if there is an image and `withImage` is set.
  template <typename Take>
  void forEach(Take&& take, bool withImage = true) const;
};

/// The packages that a robot sends to its body. They keep their values until a cycle changes them;
/// `message` and `camera` are empty before each cycle.
struct RobotOutput {
  JointData joints;
  OdometryData odometry;  ///< Moves the robot in the kinematic fidelity, by its change since the
                          ///< last tick.
  LedValue leds;
  JointGains gains{};
  Speaker speaker{};
  /// The special action that is performed, or none. In the kinematic fidelity, kicks move the ball
  /// according to their table. It is in no list, because no body uses it.
  std::string specialAction{};
  std::optional<TeamMessage> message;
  std::optional<CameraSettings> camera;  ///< Set if the camera's settings shall change.

  static constexpr auto commands() {
    return std::tuple{&RobotOutput::joints, &RobotOutput::odometry, &RobotOutput::leds,
                      &RobotOutput::gains,  &RobotOutput::speaker,  &RobotOutput::message,
                      &RobotOutput::camera};
  }
  /// Calls visit(command) for each command; those that are not given in each cycle are optional.
  template <typename Visit>
  void forEach(Visit&& visit) {
    std::apply([&](auto... commands) { (visit(this->*commands), ...); }, commands());
  }
};

/// The beliefs and decisions of a robot at the end of its last cycle, for observers. Parts that the
/// robot does not provide are null.
struct Belief {
  const RobotPose* pose = nullptr;
  const BallModel* ball = nullptr;
  const RobotState* state = nullptr;
  const MotionInfo* motion = nullptr;

  static constexpr auto parts() {
    return std::tuple{&Belief::pose, &Belief::ball, &Belief::state, &Belief::motion};
  }
  /// Calls visit(part) for each part, with the type of its value.
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

/// A tuple with a Slot<T> for each package that a body sends or receives.
template <template <typename> class Slot>
using InputSlots = decltype(detail::slotsFor<Slot>(
    std::tuple_cat(RobotInput::eachTick(), RobotInput::eachImage())));
template <template <typename> class Slot>
using CommandSlots = decltype(detail::slotsFor<Slot>(RobotOutput::commands()));
/// A tuple with a Slot<T> for each part of Belief.
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

  /// Returns whether a new package has arrived since the last call.
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
