#pragma once
#include "base/Geometry.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// The lengths of the ERS-210 (facts, 1.1 and 1.2). Configuration. Body frame: origin midway
/// between the shoulder axes.
struct RobotDimensions {
  double shoulderX = 59.5;
  double shoulderY = 59.2;
  Vector3d upperLeg{12.8, 0.5, -64.0};
  Vector3d lowerLegFore{-18.88, 0, -66.0};
  Vector3d lowerLegHind{-29.36, 0, -70.88};
  double footRadius = 13.96;
  double neckX = 75;
  double neckZ = 50;
  double neckToPan = 48;
  double panToCamera = 66.6;

  static constexpr auto fields() {
    return Fields{
        field<&RobotDimensions::shoulderX>(
            Unit::mm, "x of the fore legs' shoulders in the body frame; the hind ones are at -x"),
        field<&RobotDimensions::shoulderY>(
            Unit::mm, "y of the left legs' shoulders in the body frame; the right ones are at -y"),
        field<&RobotDimensions::upperLeg>(
            Unit::mm,
            "shoulder to knee of the left fore leg, joints 0; right legs mirror y, hind legs "
            "mirror x"),
        field<&RobotDimensions::lowerLegFore>(Unit::mm, "knee to foot ball, knee 0"),
        field<&RobotDimensions::lowerLegHind>(
            Unit::mm, "knee to foot ball, knee 0, before the mirroring of x"),
        field<&RobotDimensions::footRadius>(Unit::mm),
        field<&RobotDimensions::neckX>(
            Unit::mm, "distance of the neck's tilt axis in front of the body's origin"),
        field<&RobotDimensions::neckZ>(Unit::mm,
                                       "height of the neck's tilt axis above the body's origin"),
        field<&RobotDimensions::neckToPan>(
            Unit::mm, "distance from the tilt axis to the pan axis, along the neck"),
        field<&RobotDimensions::panToCamera>(Unit::mm,
                                             "distance from the pan axis to the camera, forward")};
  }
};

/// Limits of a joint (facts, 1.2).
struct JointLimits {
  double low, high;  ///< rad
  double speed;      ///< rad/s
};

/// Limits of a joint's angle and speed (facts, 1.2; Sony's recommendation).
constexpr JointLimits limitsOf(Joint joint) {
  constexpr auto degrees = [](double low, double high, double speed) {
    return JointLimits{fromDegrees(low), fromDegrees(high), speed};
  };
  switch (joint) {
    case Joint::headTilt:
      return degrees(-82, 43, 2.1053);
    case Joint::headPan:
      return degrees(-89.6, 89.6, 3.0107);
    case Joint::headRoll:
      return degrees(-29, 29, 3.0107);
    case Joint::mouth:
      return degrees(-47, -3, 4.3742);
    case Joint::tailPan:
    case Joint::tailTilt:
      return degrees(-22, 22, 4.4724);
    case Joint::earL:
    case Joint::earR:
      return {0, 1, 1e3};
    default:
      break;
  }
  switch ((static_cast<int>(joint) - static_cast<int>(Joint::legFR1)) % 3) {
    case 0:
      return degrees(-117, 117, 2.8143);
    case 1:
      return degrees(-11, 89, 2.4980);
    default:
      return degrees(-27, 147, 2.8362);
  }
}

}  // namespace gt
