#pragma once
#include <array>
#include <cstddef>

#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionInfo.h"

namespace gt {

/// The joints of all legs, from this one on.
constexpr std::size_t firstLegJoint = static_cast<std::size_t>(Joint::legFR1), legJoints = 12;

/// Linear models of the motors of the legs' joints: the shares of a joint's last commands, the
/// newest first, in the angle that is measured, and a constant (rad).
constexpr std::size_t motorLag = 14;
using LegMotors = std::array<std::array<double, motorLag + 1>, legJoints>;

/// What tells a robot that something holds up from a free one: how far its legs are from where
/// models of their motors expect them, how it shakes, and how it walks. All of the last half
/// second.
class CollisionFeatures {
 public:
  static constexpr std::array<std::size_t, 2> windows{20, 50};  ///< Frames: in a step, and in two.
  static constexpr std::size_t frames = motorLag + windows.back();

  /// How far legs are off, how the body shakes, speeds, and how much these have changed.
  static constexpr std::size_t states = 6 * windows.size() + 3 + 2;
  static constexpr std::size_t count =
      legJoints * windows.size() + states + states * (states + 1) / 2;
  /// The logarithms of what each joint is off, for each window; the states; their products.
  using Values = std::array<double, count>;

  /// Takes a frame in which the legs were measured and commanded. Begins anew when the motion
  /// is none of the walking engine's, is on its way there, or has another walk type.
  void add(const SensorData& measured, const JointData& commanded, const MotionInfo& motion,
           const LegMotors& motors);
  /// Whether there were enough frames.
  bool ready() const { return frames_ >= frames; }
  Values values() const;

  /// The last commands of a joint of the legs, newest first.
  std::array<double, motorLag> commandsOf(std::size_t joint) const;
  /// The leg that is farther off than any other.
  Leg mostOff() const;

 private:
  struct Frame {
    std::array<double, legJoints> commands{};
    std::array<double, legJoints> squares{};  ///< rad^2: of what the joints are off.
    Vector3d acceleration = Vector3d::Zero(), speed = Vector3d::Zero();
  };

  const Frame& before(std::size_t ago) const {
    return last_[(newest_ + last_.size() - ago) % last_.size()];
  }

  std::array<Frame, windows.back() + 1> last_;
  std::size_t newest_ = 0, frames_ = 0;
  WalkType walkType_ = WalkType::normal;
};

}  // namespace gt
