#pragma once
#include <string>

#include "base/Geometry.h"
#include "representations/infrastructure/JointGains.h"

namespace gt {

/// The output of the special actions for one frame (report 3.9.2). Provided by SpecialActions.
struct SpecialActionsOutput {
  JointData joints;
  EnumArray<Joint, bool> dontCare;
  JointGains gains;
  Pose2D odometryStep;
  bool mayLeave = true;
  std::string action;

  static constexpr auto fields() {
    return Fields{field<&SpecialActionsOutput::joints>(),
                  field<&SpecialActionsOutput::dontCare>("joints left to other requests"),
                  field<&SpecialActionsOutput::gains>(),
                  field<&SpecialActionsOutput::odometryStep>(
                      Unit::mmRad, "motion of the robot in this frame, relative to the robot"),
                  field<&SpecialActionsOutput::mayLeave>(
                      "whether another mover may take over, because the net is at extern"),
                  field<&SpecialActionsOutput::action>(
                      "name of the special action that is performed; empty at extern")};
  }
};

}  // namespace gt
