#pragma once
#include "representations/infrastructure/JointGains.h"

namespace gt {

/// What a servo motor does with the error of its angle.
struct ServoGains {
  double p;       ///< Nm/rad
  double i;       ///< Nm/(rad s)
  double d;       ///< Nm s/rad
  double torque;  ///< Nm, the largest
};

/// The gains of a joint's servo by the words P, I, D that it takes. The unit of those words is not
/// known: P is scaled so that with Sony's words a leg gives way by two to three degrees under a
/// standing robot, and the torques suffice to get up (ESTIMATE).
ServoGains gainsOf(Joint joint, const PidGains& words);

/// The servo motor of a joint: turns towards its target, not faster than the joint can
/// (`limitsOf`), with limited torque. The damping by `ServoGains::d` is left to the physics engine,
/// which integrates it implicitly.
class Servo {
 public:
  explicit Servo(Joint joint);

  /// Begins anew at an angle, where it rests until it goes on to its target.
  void rest(double angle);
  /// The angle to go to (rad); limited to what the joint can do, ignored if it is no number.
  void setTarget(double angle);
  /// The torque (Nm) for the next `seconds`, at the joint's present angle (rad).
  double torque(double angle, double seconds);

  /// Turns without load for some seconds; returns the new angle.
  double turnFreely(double seconds);
  bool atTarget() const { return reference_ == target_; }

  const ServoGains& gains() const { return gains_; }
  /// Works with other gains from now on; returns whether these are others than before.
  bool setGains(const PidGains& words);
  /// A factor on torque and P gain, such as of a weak battery.
  void setStrength(double factor);

 private:
  Joint joint_;
  PidGains words_;
  ServoGains gains_;
  double strength_ = 1;
  double low_, high_, speed_;
  double target_ = 0;
  double reference_ = 0;  ///< Runs to the target at the joint's speed.
  double integral_ = 0;   ///< Nm
};

}  // namespace gt
