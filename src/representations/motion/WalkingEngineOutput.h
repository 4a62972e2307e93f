#pragma once
#include "base/Geometry.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// What the walk does in this frame (report 3.9.1). Provided by the WalkingEngine.
struct WalkingEngineOutput {
  JointData joints;
  Pose2D odometryStep;
  Pose2D speed;
  WalkType walkType = WalkType::normal;
  bool mayLeave = true;
  double positionInWalkCycle = 0;
  bool holdsHead = false;

  static constexpr auto fields() {
    return Fields{field<&WalkingEngineOutput::joints>("the legs, and the head if it is held"),
                  field<&WalkingEngineOutput::odometryStep>(Unit::mmRad, "of this frame"),
                  field<&WalkingEngineOutput::speed>(
                      Unit::mmRadPerS, "the request as far as step sizes and accelerations allow"),
                  field<&WalkingEngineOutput::walkType>(
                      "of this step; another one that is requested begins with the next"),
                  field<&WalkingEngineOutput::mayLeave>("the robot stands"),
                  field<&WalkingEngineOutput::positionInWalkCycle>({0, 1}),
                  field<&WalkingEngineOutput::holdsHead>("the walk turns head and mouth itself")};
  }
};

}  // namespace gt
