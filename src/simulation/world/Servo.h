#pragma once
#include "representations/infrastructure/JointGains.h"

namespace gt {

constexpr bool isOfLeg(Joint joint) {
  return joint >= Joint::legFR1 && joint <= Joint::legHL3;
}

/// A joint's motor, whose torque falls with its speed, as that of any DC motor.
struct Motor {
  double stallTorque;  ///< Nm
  double noLoadSpeed;  ///< rad/s

  /// The decrease of its torque with its speed (Nm s/rad), whatever the battery's strength.
  double damping() const { return stallTorque / noLoadSpeed; }
};
Motor motorOf(Joint joint);

/// The gains of a servo's PID controller.
struct ServoGains {
  double p;  ///< Nm/rad
  double i;  ///< Nm/(rad s)
  double d;  ///< Nm s/rad
};

/// The gains of a joint's servo for the words P, I, D of its command, whose units are not known.
ServoGains gainsOf(const PidGains& words);

/// The output of a servo: a torque, and a damping, which is left to the physics engine because that
/// integrates it implicitly.
struct Drive {
  double torque;   ///< Nm
  double damping;  ///< Nm s/rad
};

/// The servo of a joint: its motor pulls towards the target by the gains, within its torque limit.
class Servo {
 public:
  explicit Servo(Joint joint);

  /// Restarts at an angle (rad), at rest, from which it continues to its target.
  void rest(double angle);
  /// Sets the target angle (rad); clipped to the joint's limits, ignored if it is no number.
  void setTarget(double angle);
  /// Its output in the next `seconds`, at the joint's present angle (rad) and speed (rad/s).
  Drive drive(double angle, double speed, double seconds);

  /// Turns without load for some seconds; returns the new angle (rad).
  double turnFreely(double seconds);
  bool atTarget() const { return free_ == target_; }

  /// Time constant (s) with which it follows its target without load, below its greatest speed.
  double lag() const { return (motor_.damping() + gains_.d) / gains_.p; }

  const ServoGains& gains() const { return gains_; }
  /// Changes the gains from now on.
  void setGains(const PidGains& words);
  /// Sets the factor on torque and P gain, such as for a weak battery.
  void setStrength(double factor);

 private:
  PidGains words_;
  ServoGains gains_;
  Motor motor_;
  double strength_ = 1;
  double low_, high_;
  double target_ = 0;
  double free_ = 0;      ///< rad: moves to the target with the motor's speed without load.
  double integral_ = 0;  ///< Nm
};

}  // namespace gt
