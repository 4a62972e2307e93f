#pragma once
#include <functional>

#include "base/Random.h"
#include "representations/infrastructure/SensorData.h"
#include "simulation/parameters/NoiseParameters.h"
#include "simulation/world/RobotBuild.h"
#include "simulation/world/World.h"

namespace gt {

/// Simulates the sensors of one robot's body, with noise of its own (report 5.1.1).
class Sensors {
 public:
  Sensors(const NoiseParameters& noise, const Random& random, const RobotBuild& build = {});

  /// Fills the readings of this tick. May run for several robots at once: the world is only read.
  void read(const World& world, std::size_t robot, SensorData& readings);

  /// Presses or releases a switch by hand (report I.3); paws are also pressed by the ground.
  void press(Switch which, bool pressed) { pressed_[which] = pressed; }
  bool isPressed(Switch which) const { return pressed_[which]; }
  /// Pushes the tail to the left against its servo (rad), or lets it go (0). Only the sensor feels
  /// it.
  void pushTail(double angle) { tailPush_ = angle; }
  double tailPush() const { return tailPush_; }

  const RobotBuild& build() const { return build_; }
  /// Changes the noise, and the build of the robot, from now on.
  void change(const NoiseParameters& noise, const RobotBuild& build) {
    noise_ = noise;
    build_ = build;
  }

 private:
  NoiseParameters noise_;
  Random random_, reflections_;
  RobotBuild build_;
  JointAngles geared_{};  ///< Angles at the sensors' sides of the joints' backlash (rad).
  EnumArray<Switch, bool> pressed_;
  double tailPush_ = 0;
};

/// Distance (mm) from a point on the field (mm) along a unit vector to the first surface, at most
/// `range` (mm). `passes` returns whether a geom is transparent.
double rayDistance(const World& world, const Vector3d& from, const Vector3d& direction,
                   double range, const std::function<bool(int geom)>& passes);

/// Distance (mm) from a robot's distance sensor to the first surface ahead, at most `range` (mm).
/// The robot's own body is transparent.
double rayDistance(const World& world, std::size_t robot, double range);

}  // namespace gt
