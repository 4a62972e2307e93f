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
  /// How a robot's steps differ from what it believes.
  struct Walking {
    double forward = 1, sideways = 1, turn = 1;
    StepNoise noise;
    Gait gait;
    double speed = 0;  ///< mm/s, as it believes; a turn of 1 rad/s counts as 100 mm/s.
    double ahead = 0;  ///< The share of it that is straight ahead; below 0: straight back.
  };

  KinematicWorld(const SceneDescription& scene, Model model, const Random& random);

  /// A place, and how far it is from there to the nearest obstacle (mm): until a robot has gone
  /// that far, it can meet none.
  struct Clearance {
    Vector2d from = Vector2d::Zero();
    double distance = 0;
  };

  /// A kick that a robot performs.
  struct Kicking {
    const KickDescription* kick = nullptr;
    int ticks = 0;  ///< Since it began.
    Pose2D from;    ///< Where the robot stood then.
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
  /// Sets height, tilt and roll by the joints and by how the body sways: as it does after this tick
  /// if `goesOn`, or as it does now.
  void setStance(std::size_t i, bool goesOn);

  NoiseParameters noise_;
  BodyParameters body_;
  WalkingParameters walkingParameters_;
  BallPhysics ballPhysics_;
  std::vector<Walking> walking_;
  std::vector<Kicking> kicking_;
  /// Whose kick plays a ball by its description: no part of them touches one that lies there or
  /// rolls from the strike. One that somebody else has set rolling meets their bodies.
  std::vector<bool> plays_;
  std::vector<Clearance> clear_;
  std::vector<Vector2d> from_, ways_;  ///< Of each robot in this tick, on the field (mm).
};

}  // namespace gt
