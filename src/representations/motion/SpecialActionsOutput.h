#pragma once
#include "base/Geometry.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

/// What the special actions do in this frame (report 3.9.2). Provided by SpecialActions.
struct SpecialActionsOutput {
  JointData joints;
  EnumArray<Joint, bool> dontCare;
  Pose2D odometryStep;
  bool mayLeave = true;
  SpecialAction action = SpecialAction::none;

  static constexpr auto fields() {
    return Fields{
        field("joints", &SpecialActionsOutput::joints),
        field("dontCare", &SpecialActionsOutput::dontCare, "", "joints left to other requests"),
        field("odometryStep", &SpecialActionsOutput::odometryStep, "mm, rad", "of this frame"),
        field("mayLeave", &SpecialActionsOutput::mayLeave, "", "the net is at extern"),
        field("action", &SpecialActionsOutput::action, "", "being performed; none at extern")};
  }
};

}  // namespace gt
