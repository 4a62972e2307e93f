#pragma once
#include "representations/behavior/MotionRequest.h"

namespace gt {

/// What the motion is doing. Provided by MotionControl.
struct MotionInfo {
  MotionRequest executed;
  double positionInWalkCycle = 0;
  bool stable = true;
  bool arriving = false;

  static constexpr auto fields() {
    return Fields{
        field<&MotionInfo::executed>("the request that is being carried out"),
        field<&MotionInfo::positionInWalkCycle>({0, 1}),
        field<&MotionInfo::stable>("the camera matrix can be trusted: neither kick nor getup"),
        field<&MotionInfo::arriving>(
            "the legs are on their way to the stand, from which a walk begins")};
  }
};

}  // namespace gt
