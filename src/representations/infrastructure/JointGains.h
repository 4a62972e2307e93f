#pragma once
#include "representations/infrastructure/Joints.h"

namespace gt {

/// The gains of a joint's servo in the words of Sony's motor interface.
struct PidGains {
  int p = 0, i = 0, d = 0;

  friend bool operator==(const PidGains&, const PidGains&) = default;
  static constexpr auto fields() {
    return Fields{field<&PidGains::p>("word", {0, 255}), field<&PidGains::i>("word", {0, 255}),
                  field<&PidGains::d>("word", {0, 255})};
  }
};

/// The gains that Sony recommends for a joint (facts, 1.2).
constexpr PidGains defaultGains(Joint joint) {
  switch (joint) {
    case Joint::headTilt:
    case Joint::headRoll:
      return {0x0a, 0x08, 0x0c};
    case Joint::headPan:
      return {0x0d, 0x08, 0x0b};
    case Joint::mouth:
      return {0x0e, 0x08, 0x10};
    case Joint::tailPan:
      return {0x0a, 0x00, 0x18};
    case Joint::tailTilt:
    case Joint::earL:
    case Joint::earR:
      return {0x07, 0x00, 0x11};
    default:
      break;
  }
  switch ((static_cast<int>(joint) - static_cast<int>(Joint::legFR1)) % 3) {
    case 0:
      return {0x16, 0x04, 0x08};
    case 1:
      return {0x14, 0x04, 0x06};
    default:
      return {0x23, 0x04, 0x05};
  }
}

/// The gains of the servos' controllers. They are Sony's unless a special action sets others
/// (report 3.9.2). Provided by MotionControl.
struct JointGains {
  EnumArray<Joint, PidGains> gains = recommended();

  static constexpr EnumArray<Joint, PidGains> recommended() {
    EnumArray<Joint, PidGains> all;
    for (std::size_t i = 0; i < all.size(); ++i)
      all.values[i] = defaultGains(static_cast<Joint>(i));
    return all;
  }

  static constexpr auto fields() {
    return Fields{field<&JointGains::gains>("gains of each servo, in the order of Joint")};
  }
};

}  // namespace gt
