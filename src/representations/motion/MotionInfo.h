#pragma once
#include "representations/behavior/MotionRequest.h"

namespace gt {

/// The state of the motion. Provided by MotionControl.
struct MotionInfo {
  MotionRequest executed;
  double positionInWalkCycle = 0;
  bool stable = true;
  bool arriving = false;

  static constexpr auto fields() {
    return Fields{
        field<&MotionInfo::executed>("the request that is being executed"),
        field<&MotionInfo::positionInWalkCycle>({0, 1}),
        field<&MotionInfo::stable>(
            "whether the camera matrix is reliable: neither during a kick nor while getting up"),
        field<&MotionInfo::arriving>(
            "whether the legs are moving to the stand from which a walk begins")};
  }
};

}  // namespace gt
