#pragma once
#include <array>
#include <string>
#include <vector>

#include "simulation/world/World.h"

namespace gt {

/// The kind of motion of an actuator (report 5.1.1).
enum class ActuatorKind { rotational, translational, space, vehicle };

/// The actuators of a scene beside the robots' own: all joints of the field's model that belong to
/// no robot and no ball. A hinge is a rotational joint, a slide a translational one, a free joint
/// moves in space, or as a vehicle with a driving and a steering axle. They follow their commands
/// in both fidelities and are moved by nothing else.
///
/// A command is a number in -1 .. 1 for each direction; it is kept until the next one. The model
/// states the speed at a command of 1, as `<numeric name="speed/JOINT" data="…"/>`: deg/s for a
/// hinge, mm/s for a slide, three mm/s and three deg/s for a free joint (x ahead, y left, z up;
/// turns about them). `<numeric name="vehicle/JOINT" data="SPEED ANGLE BASE"/>` makes a free joint
/// a vehicle: mm/s, the greatest steering angle in deg, and mm between the axles.
class Actuators {
 public:
  using Coordinates = std::array<mjtNum, 7>;  ///< In MuJoCo's units: 1, or 7 of a free joint.

  struct Actuator {
    std::string name;
    ActuatorKind kind = ActuatorKind::rotational;
    int joint = 0;
    int body = 0;
    std::array<double, 6> speed{};  ///< m/s and rad/s at a command of 1.
    double wheelBase = 0;           ///< m, of a vehicle.
    std::array<double, 6> command{};
    Coordinates coordinates{};  ///< At the end of the last `step`.
    bool executed = true;       ///< Whether nothing blocked the last tick's motion.

    /// The number of values of a command; a vehicle has two: driving and steering.
    std::size_t directions() const {
      return kind == ActuatorKind::space ? 6 : kind == ActuatorKind::vehicle ? 2 : 1;
    }
  };

  explicit Actuators(const World& world);

  /// Moves all actuators by one tick as commanded, as far as nothing is in the way.
  void step(World& world);
  /// Puts all actuators where `step` left them, undoing what forces did to them since.
  void hold(World& world) const;

  const std::vector<Actuator>& all() const { return actuators_; }
  /// The actuator with a name; null if there is none.
  Actuator* find(const std::string& name);

 private:
  void move(World& world, Actuator& actuator);
  /// The coordinates to which a share of a tick moves an actuator.
  static Coordinates moved(const World& world, const Actuator& actuator, double share);
  bool collides(const World& world, const Actuator& actuator) const;

  std::vector<Actuator> actuators_;
  std::vector<std::vector<int>> geoms_;  ///< The geoms that each actuator moves.
};

}  // namespace gt
