#pragma once
#include "representations/motion/MotionNet.h"

namespace gt {

/// A special action as XABSL's enumeration special_action has it: its index in MotionNet::motions.
enum class SpecialAction : int {};

/// The motion of a special action; one without a name for none, and where there is none.
inline const MotionNet::Motion& motionOf(const MotionNet& net, SpecialAction action) {
  static const MotionNet::Motion none;
  const auto index = static_cast<std::size_t>(action);
  return index < net.motions.size() ? net.motions[index] : none;
}

}  // namespace gt
