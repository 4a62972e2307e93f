#pragma once
#include <algorithm>

#include "simulation/parameters/BodyParameters.h"
#include "simulation/parameters/NoiseParameters.h"
#include "simulation/parameters/WalkingParameters.h"
#include "simulation/world/BallPhysics.h"
#include "simulation/world/Gait.h"
#include "simulation/world/StepNoise.h"
#include "simulation/world/World.h"

namespace gt {

/// The kinematic fidelity (report 5.1.1): robots move by their own motion model, with slip and
/// noise, and are blocked by robots, walls and goals; their feet set height and tilt of the body.
/// Only the balls have physics; a ball that a kick plays goes where the kick's description says.
class KinematicWorld : public World {
 public:
  static Result<std::unique_ptr<World>> make(const SceneDescription& scene, Model model,
                                             const Random& random);

  void step(std::span<const RobotCommand> commands) override;
  void change(const SceneDescription& scene) override;
  void moveGeom(int geom, const Vector3d& position) override {
    World::moveGeom(geom, position);
    std::fill(clear_.begin(), clear_.end(), Clearance{});
  }

 private:
  /// Differences of a robot's real steps from those it believes to make.
  struct Walking {
    double forward = 1, sideways = 1, turn = 1;  ///< Factors on its steps.
    StepNoise noise;
    Gait gait;
    double speed = 0;  ///< mm/s, as it believes; a turn of 1 rad/s counts as 100 mm/s.
    double ahead = 0;  ///< The share of `speed` that is straight ahead; below 0: straight back.
  };

  KinematicWorld(const SceneDescription& scene, Model model, const Random& random);

  /// A place, and its distance to the nearest obstacle (mm). A robot that has moved by less than
  /// this distance since cannot meet an obstacle.
  struct Clearance {
    Vector2d from = Vector2d::Zero();
    double distance = 0;
  };

  /// A kick that a robot performs.
  struct Kicking {
    const KickDescription* kick = nullptr;
    int ticks = 0;  ///< Since it began.
    Pose2D from;    ///< Pose of the robot when it began.
    bool hasStruck = false;
    Random random;
  };

  void putDown(std::size_t robot) override;
  bool robotsOverlap(std::size_t a, std::size_t b) const override;
  bool robotOverlapsField(std::size_t robot) const override;
  bool ballOverlapsRobot(std::size_t ball, std::size_t robot) const override;
  bool ballOverlapsField(std::size_t ball) const override;

  void kick(std::size_t i, const KickDescription* kick);
  bool mayMeetObstacle(std::size_t i);
  void moveJoints(RobotBody& robot, const JointAngles& targets) const;
  void walk(std::size_t i, const Pose2D& step);
  void noteBlocked(std::size_t i);
  void partRobots();
  bool partPair(std::size_t a, std::size_t b);
  /// Sets height, tilt and roll from the joints and the sway of the body: the sway after this tick
  /// if `goesOn`, otherwise the present one.
  void setStance(std::size_t i, bool goesOn);

  NoiseParameters noise_;
  BodyParameters body_;
  WalkingParameters walkingParameters_;
  BallPhysics ballPhysics_;
  std::vector<Walking> walking_;
  std::vector<Kicking> kicking_;
  /// Robots whose kick plays a ball by its description. No part of them touches a ball that lies
  /// there or rolls from the strike; a ball that another robot has set rolling meets their bodies.
  std::vector<bool> plays_;
  std::vector<Clearance> clear_;
  std::vector<Vector2d> from_, ways_;  ///< Start and motion of each robot in this tick (mm).
};

}  // namespace gt
