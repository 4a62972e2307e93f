#pragma once
#include <array>
#include <cstddef>

#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionInfo.h"

namespace gt {

/// The first of the joints of the legs, and their number.
constexpr std::size_t firstLegJoint = static_cast<std::size_t>(Joint::legFR1), legJoints = 12;

/// Linear models of the motors of the legs' joints: the weights of a joint's last commands, the
/// newest first, in the measured angle, and a constant (rad).
constexpr std::size_t motorLag = 14;
using LegMotors = std::array<std::array<double, motorLag + 1>, legJoints>;

/// Features that distinguish a robot that is held up from a free one: the differences of its legs'
/// joints from the predictions of models of their motors, the shaking of the body, and the walk.
/// All refer to the last half second.
class CollisionFeatures {
 public:
  /// Numbers of frames: of a step, and of two.
  static constexpr std::array<std::size_t, 2> windows{20, 50};
  static constexpr std::size_t frames = motorLag + windows.back();

  /// Number of states: differences of the legs, shaking of the body, speeds, and their changes.
  static constexpr std::size_t states = 6 * windows.size() + 3 + 2;
  static constexpr std::size_t count =
      legJoints * windows.size() + states + states * (states + 1) / 2;
  /// The logarithm of each joint's mean squared difference, for each window; the states; their
  /// products.
  using Values = std::array<double, count>;

  /// Adds a frame with measurements and commands of the legs. Starts again if the motion is not the
  /// walking engine's, is still changing to it, or has another walk type.
  void add(const SensorData& measured, const JointData& commanded, const MotionInfo& motion,
           const LegMotors& motors);
  /// Whether enough frames were added.
  bool ready() const { return frames_ >= frames; }
  Values values() const;

  /// The last commands of a joint of the legs, newest first.
  std::array<double, motorLag> commandsOf(std::size_t joint) const;
  /// The leg with the largest difference from the models.
  Leg mostOff() const;

 private:
  struct Frame {
    std::array<double, legJoints> commands{};
    /// Squared differences of the joints from the models, rad^2.
    std::array<double, legJoints> squares{};
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
