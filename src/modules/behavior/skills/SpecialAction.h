#pragma once
#include "representations/motion/MotionNet.h"

namespace gt {

/// A special action, as in XABSL's enumeration special_action: the index in MotionNet::motions.
enum class SpecialAction : int {};

/// The motion of a special action; a motion without a name if the index is out of range.
inline const MotionNet::Motion& motionOf(const MotionNet& net, SpecialAction action) {
  static const MotionNet::Motion none;
  const auto index = static_cast<std::size_t>(action);
  return index < net.motions.size() ? net.motions[index] : none;
}

}  // namespace gt
