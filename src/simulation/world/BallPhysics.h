#pragma once
#include <span>
#include <vector>

#include "simulation/parameters/BallParameters.h"
#include "simulation/world/Carpet.h"
#include "simulation/world/Obstacles.h"
#include "simulation/world/World.h"

namespace gt {

/// Moves a ball on the ground: it rolls, slows down, bounces off walls, and is pushed and kicked by
/// any part of a robot that touches it. MuJoCo computes where sphere and geoms touch; this class
/// chooses the pairs by distance.
class BallPhysics {
 public:
  /// The things that a ball can meet in this tick.
  struct Surroundings {
    const std::vector<RobotParts>& parts;
    const std::vector<RobotBody>& robots;
    const std::vector<bool>& placed;
    const std::vector<bool>& apart;  ///< The robots that do not touch balls.
    const Obstacles& obstacles;
    Time time;
  };

  BallPhysics(const BallParameters& parameters, const mjModel& model, std::uint64_t carpetSeed);

  void change(const BallParameters& parameters) { parameters_ = parameters; }
  double deceleration() const { return parameters_.deceleration; }

  /// Stores, at the end of a tick, the poses of the parts that a ball may meet in the next one. The
  /// parts' speeds are computed from them.
  void rememberGeoms(const mjData& data, std::span<const RobotParts> parts,
                     std::span<const RobotBody> robots, std::span<const BallState> balls);

  /// Moves the ball by one tick. `data` holds the robots' poses after their own motion; the ball's
  /// own pose in it is overwritten by the tests for contacts.
  void step(BallState& ball, const BallParts& parts, mjData& data, const Surroundings& around);

  /// Whether a robot overlaps the ball by more than a depth (mm), so that it would push the ball.
  bool overlaps(const BallParts& ball, const mjData& data, const RobotParts& robot,
                double depth) const;

 private:
  bool touchRobots(BallState& ball, const BallParts& parts, mjData& data,
                   const Surroundings& around, double& pushLeft);
  /// Finds where the ball's geom and another one touch; returns the number of contacts.
  int contactsWith(const mjData& data, int ballGeom, int geom, mjContact* contacts) const;
  bool touchGeom(BallState& ball, const BallParts& parts, mjData& data, int geom, bool still,
                 const Vector2d& robotCenter, double& pushLeft);
  void bounceOffWalls(BallState& ball, double radius, const Obstacles& obstacles) const;
  void bounce(BallState& ball, const Vector2d& normal, const Vector2d& surfaceSpeed,
              double restitution) const;
  Vector2d speedOfGeom(const mjData& data, int geom, const mjtNum* point) const;

  BallParameters parameters_;
  const mjModel& model_;
  std::uint64_t carpetSeed_;
  std::vector<mjtNum> positions_, rotations_;
};

}  // namespace gt
