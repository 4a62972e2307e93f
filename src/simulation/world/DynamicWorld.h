#pragma once
#include <array>
#include <vector>

#include "simulation/parameters/BallParameters.h"
#include "simulation/parameters/DynamicsParameters.h"
#include "simulation/parameters/NoiseParameters.h"
#include "simulation/world/Carpet.h"
#include "simulation/world/Servo.h"
#include "simulation/world/StepNoise.h"
#include "simulation/world/World.h"

namespace gt {

/// The dynamic fidelity: servo motors, masses, contacts and friction move everything, by MuJoCo.
/// Robots walk with their legs, kick with their bodies, can fall over and get up. The step that a
/// robot believes to make does not move it, but the carpet drags at a robot that walks (StepNoise).
/// Geoms collide if the models mark them by `contype`; the parts of one robot do not collide with
/// each other.
class DynamicWorld : public World {
 public:
  static Result<std::unique_ptr<World>> make(const SceneDescription& scene, Model model,
                                             const Random& random);

  void step(std::span<const RobotCommand> commands) override;
  void push(std::size_t robot, const Vector3d& force, const Vector3d& at) override;
  void change(const SceneDescription& scene) override;

 private:
  /// A robot's motors, and the state that its measurements need.
  struct Motors {
    StepNoise noise;
    std::vector<Servo> servos{};  ///< In the order of Joint.
    std::vector<int> solidGeoms{};
    int firstDof = 0;  ///< Of the body; those of the joints follow it.
    Vector3d speed = Vector3d::Zero();
    /// Ticks for which its legs have rested since it was switched on; the robot is held at first.
    int rested = 0;
  };

  DynamicWorld(const SceneDescription& scene, Model model, const Random& random);

  void putDown(std::size_t robot) override;
  bool robotsOverlap(std::size_t a, std::size_t b) const override;
  bool robotOverlapsField(std::size_t robot) const override;
  bool ballOverlapsRobot(std::size_t ball, std::size_t robot) const override;
  bool ballOverlapsField(std::size_t ball) const override;

  void prepareModel(const Random& random);
  void prepareContacts();
  void lookAround();
  /// Whether a wall is nearer to a point on the field (mm) than a distance (mm), approximately.
  bool wallIsNear(int wall, const Vector2d& point, double distance) const;
  int jointDof(std::size_t robot, std::size_t joint) const;
  void setFriction();
  void setDynamics(const DynamicsParameters& dynamics);
  void drive();
  /// Pulls rolling balls into the carpet's dents.
  void pullBalls();
  /// Moves a robot as the carpet drags at it while it believes to make `step` (mm, rad).
  void drag(std::size_t robot, const Pose2D& step);
  void holdRobots();
  void putByHand();
  void putRobot(std::size_t i);
  void putBall(std::size_t i);
  double lowestPoint(std::size_t i) const;
  void readRobot(std::size_t i);
  void readBall(std::size_t i);
  void forgetContacts();
  /// Adds the contacts of this step of the physics.
  void readContacts();
  /// Notes for the robot of the first geom that it touches the other one.
  void touch(int geom, int other);
  /// Notes that a robot touches another one, or a wall (-1).
  void meet(std::size_t robot, int other);
  void undoIfBroken();
  /// Puts a body that moves impossibly fast back to where it was before the tick, at rest.
  void slowDown(int poseAddress, int body);
  Vector3d speedOf(std::size_t robot) const;

  NoiseParameters noise_;
  BallParameters ballParameters_;
  std::uint64_t carpetSeed_;
  DynamicsParameters dynamics_;  ///< That the model has now.
  std::vector<Motors> motors_;
  std::vector<int> walls_;             ///< Solid geoms that stand still, but for floors.
  std::vector<int> robotOfBody_;       ///< By root body; -1: none.
  std::vector<int> ballOfBody_;        ///< By root body; -1: none.
  std::vector<mjtNum> goodPositions_;  ///< qpos after the last tick.
};

}  // namespace gt
