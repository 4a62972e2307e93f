#pragma once
#include <vector>

#include "environments/Environment.h"
#include "environments/JointSpace.h"

namespace gt {

/// An environment of one robot in the dynamic fidelity without a program: the agent decides the
/// angles of its joints in each tick.
class Limbs : public Environment {
 protected:
  /// `joints` are those that the agent turns; all others keep their standing angles. `ball` states
  /// whether there is a ball.
  Limbs(EnvironmentOptions options, SceneDescription scene, std::vector<Joint> joints, bool ball);

  void act(std::span<const float> actions) override;
  void observe(std::size_t agent, std::span<float> numbers) override;
  SceneCamera camera() const override;

  /// Attaches the motors, sets the joints to their standing angles with small random differences,
  /// and puts the robot at a pose (mm, rad, on the field) in a posture; then `ticks` pass.
  Result<void> put(Random& random, const Pose2D& pose, Posture posture, int ticks);
  /// Requests angles (rad) and lets a tick pass.
  void drive(const JointAngles& angles);

  const std::vector<Joint>& joints() const { return joints_; }
  const RobotBody& body() const { return world().robot(0); }
  /// The vertical component of the body's vertical axis: 1 upright, 0 on the side.
  double upright() const { return std::cos(body().tilt) * std::cos(body().roll); }
  /// The body's speed on the field (m/s).
  Vector3d speed() const;
  /// The mean squared difference between the requested angles and the previous ones (rad^2).
  double effort() const;

 private:
  class Motors;

  void observeState(std::span<float> numbers) const;
  void observeBeliefs(std::span<float> numbers) const;
  /// MuJoCo's speeds of the body: 3 along the field's axes, 3 about the body's, then the joints'.
  const mjtNum* speeds() const;
  double jointSpeed(Joint joint) const;

  std::vector<Joint> joints_;
  bool withBall_;
  JointAngles requested_{}, before_{};
  Motors* motors_ = nullptr;  ///< Owned by the simulation.
};

}  // namespace gt
