#pragma once
#include "representations/infrastructure/JointGains.h"

namespace gt {

constexpr bool isOfLeg(Joint joint) {
  return joint >= Joint::legFR1 && joint <= Joint::legHL3;
}

/// What a joint's motor can: its torque falls with its speed, as that of each DC motor does.
struct Motor {
  double stallTorque;  ///< Nm
  double noLoadSpeed;  ///< rad/s

  /// By which its torque falls with its speed (Nm s/rad), however strong the battery is.
  double damping() const { return stallTorque / noLoadSpeed; }
};
Motor motorOf(Joint joint);

/// What a servo does with the error of its angle.
struct ServoGains {
  double p;  ///< Nm/rad
  double i;  ///< Nm/(rad s)
  double d;  ///< Nm s/rad
};

/// The gains of a joint's servo by the words P, I, D that it takes, whose units are not known.
ServoGains gainsOf(const PidGains& words);

/// What a servo does with its joint: a torque, and damping, which is left to the physics engine,
/// since that integrates it implicitly.
struct Drive {
  double torque;   ///< Nm
  double damping;  ///< Nm s/rad
};

/// The servo of a joint: its motor pulls towards the target as the gains say, as far as it can.
class Servo {
 public:
  explicit Servo(Joint joint);

  /// Begins anew at an angle, where it rests until it goes on to its target.
  void rest(double angle);
  /// The angle to go to (rad); limited to what the joint can do, ignored if it is no number.
  void setTarget(double angle);
  /// What it does in the next `seconds`, at the joint's present angle (rad) and speed (rad/s).
  Drive drive(double angle, double speed, double seconds);

  /// Turns without load for some seconds; returns the new angle.
  double turnFreely(double seconds);
  bool atTarget() const { return free_ == target_; }

  /// The time constant (s) with which it follows its target without load, below its greatest speed.
  double lag() const { return (motor_.damping() + gains_.d) / gains_.p; }

  const ServoGains& gains() const { return gains_; }
  /// Works with other gains from now on.
  void setGains(const PidGains& words);
  /// A factor on torque and P gain, such as of a weak battery.
  void setStrength(double factor);

 private:
  PidGains words_;
  ServoGains gains_;
  Motor motor_;
  double strength_ = 1;
  double low_, high_;
  double target_ = 0;
  double free_ = 0;      ///< Runs to the target with the motor's speed.
  double integral_ = 0;  ///< Nm
};

}  // namespace gt
