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
    return Fields{
        field("joints", &WalkingEngineOutput::joints, "", "the legs, and the head if it is held"),
        field("odometryStep", &WalkingEngineOutput::odometryStep, "mm, rad", "of this frame"),
        field("speed", &WalkingEngineOutput::speed, "mm/s, rad/s",
              "the request as far as step sizes and accelerations allow"),
        field("walkType", &WalkingEngineOutput::walkType, "",
              "of this step; another one that is requested begins with the next"),
        field("mayLeave", &WalkingEngineOutput::mayLeave, "", "the robot stands"),
        field("positionInWalkCycle", &WalkingEngineOutput::positionInWalkCycle, "", "", {0, 1}),
        field("holdsHead", &WalkingEngineOutput::holdsHead, "",
              "the walk turns head and mouth itself")};
  }
};

}  // namespace gt
