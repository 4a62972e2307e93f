#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The 20 driven joints of the ERS-210; the first 18 in the order of a `.mof` data line
/// (report 5.4). Legs: F fore, H hind; R right, L left; 1 rotator (+ forward-up fore, + backward-up
/// hind), 2 elevator
/// (+ outward), 3 knee. Head tilt + up, pan + left, roll + right ear down. Ears: 0 or 1.
enum class Joint {
  headTilt,
  headPan,
  headRoll,
  mouth,
  tailPan,
  tailTilt,
  legFR1,
  legFR2,
  legFR3,
  legFL1,
  legFL2,
  legFL3,
  legHR1,
  legHR2,
  legHR3,
  legHL1,
  legHL2,
  legHL3,
  earL,
  earR
};

/// The four legs in the order of their joints.
enum class Leg { foreRight, foreLeft, hindRight, hindLeft };

constexpr bool isFore(Leg leg) {
  return leg == Leg::foreRight || leg == Leg::foreLeft;
}
constexpr bool isLeft(Leg leg) {
  return leg == Leg::foreLeft || leg == Leg::hindLeft;
}

/// The joint of a leg by its number 1 to 3.
constexpr Joint legJoint(Leg leg, int number) {
  return static_cast<Joint>(static_cast<int>(Joint::legFR1) + 3 * static_cast<int>(leg) + number -
                            1);
}

using JointAngles = EnumArray<Joint, double>;

/// The target angles of the motors in one frame of 8 ms. Provided by MotionControl.
struct JointData {
  JointAngles angles;

  static constexpr auto fields() {
    return Fields{field<&JointData::angles>(Unit::rad, "target angles, in the order of Joint")};
  }
};

}  // namespace gt
