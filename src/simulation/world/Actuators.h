#pragma once
#include <array>
#include <string>
#include <vector>

#include "simulation/world/World.h"

namespace gt {

/// What an actuator moves (report 5.1.1).
enum class ActuatorKind { rotational, translational, space, vehicle };

/// The actuators of a scene beside the robots' own: all joints of the field's model that belong to
/// no robot and no ball. A hinge is a rotational joint, a slide a translational one, a free joint
/// moves in space, or as a vehicle with a driving and a steering axle. They follow their commands
/// in both fidelities and are moved by nothing else.
///
/// A command is a number in -1 .. 1 for each direction; it is kept until the next one. How fast the
/// greatest is stands in the model, as `<numeric name="speed/JOINT" data="…"/>`: deg/s for a hinge,
/// mm/s for a slide, three mm/s and three deg/s for a free joint (x ahead, y left, z up; turns
/// about them). `<numeric name="vehicle/JOINT" data="SPEED ANGLE BASE"/>` makes a free joint a
/// vehicle: mm/s, the greatest steering angle in deg, and mm between the axles.
class Actuators {
 public:
  using Coordinates = std::array<mjtNum, 7>;  ///< As MuJoCo counts: 1, or 7 of a free joint.

  struct Actuator {
    std::string name;
    ActuatorKind kind = ActuatorKind::rotational;
    int joint = 0;
    int body = 0;
    std::array<double, 6> speed{};  ///< m/s and rad/s at a command of 1.
    double wheelBase = 0;           ///< m, of a vehicle.
    std::array<double, 6> command{};
    Coordinates coordinates{};  ///< Where it was left.
    bool executed = true;       ///< Whether the last tick's motion met nothing.

    /// How many numbers a command has: driving and steering for a vehicle.
    std::size_t directions() const {
      return kind == ActuatorKind::space ? 6 : kind == ActuatorKind::vehicle ? 2 : 1;
    }
  };

  explicit Actuators(const World& world);

  /// One tick: moves all as requested, as far as nothing is in the way.
  void step(World& world);
  /// Puts all where `step` left them, whatever forces did to them since.
  void hold(World& world) const;

  const std::vector<Actuator>& all() const { return actuators_; }
  /// Null if there is none of that name.
  Actuator* find(const std::string& name);

 private:
  void move(World& world, Actuator& actuator);
  /// Where a share of a tick brings an actuator from where it is.
  static Coordinates moved(const World& world, const Actuator& actuator, double share);
  bool collides(const World& world, const Actuator& actuator) const;

  std::vector<Actuator> actuators_;
  std::vector<std::vector<int>> geoms_;  ///< That each of them moves.
};

}  // namespace gt
