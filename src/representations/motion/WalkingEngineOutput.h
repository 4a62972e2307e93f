#pragma once
#include "base/Geometry.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// The output of the walk for one frame (report 3.9.1). Provided by the WalkingEngine.
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
        field<&WalkingEngineOutput::joints>(
            "angles of the legs, and of the head if `holdsHead` is set"),
        field<&WalkingEngineOutput::odometryStep>(
            Unit::mmRad, "motion of the robot in this frame, relative to the robot"),
        field<&WalkingEngineOutput::speed>(
            Unit::mmRadPerS, "requested speed, limited by step sizes and accelerations"),
        field<&WalkingEngineOutput::walkType>(
            "type of the present step; another requested type begins with the next step"),
        field<&WalkingEngineOutput::mayLeave>(
            "whether another mover may take over, because the robot stands"),
        field<&WalkingEngineOutput::positionInWalkCycle>({0, 1}),
        field<&WalkingEngineOutput::holdsHead>("whether the walk controls head and mouth itself")};
  }
};

}  // namespace gt
