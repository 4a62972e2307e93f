#pragma once
#include <string>

#include "base/Geometry.h"
#include "representations/infrastructure/JointGains.h"

namespace gt {

/// What the special actions do in this frame (report 3.9.2). Provided by SpecialActions.
struct SpecialActionsOutput {
  JointData joints;
  EnumArray<Joint, bool> dontCare;
  JointGains gains;
  Pose2D odometryStep;
  bool mayLeave = true;
  std::string action;

  static constexpr auto fields() {
    return Fields{
        field("joints", &SpecialActionsOutput::joints),
        field("dontCare", &SpecialActionsOutput::dontCare, "", "joints left to other requests"),
        field("gains", &SpecialActionsOutput::gains),
        field("odometryStep", &SpecialActionsOutput::odometryStep, "mm, rad", "of this frame"),
        field("mayLeave", &SpecialActionsOutput::mayLeave, "", "the net is at extern"),
        field("action", &SpecialActionsOutput::action, "",
              "name of what is performed; empty at extern")};
  }
};

}  // namespace gt
