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
        field<&SpecialActionsOutput::joints>(),
        field<&SpecialActionsOutput::dontCare>("joints left to other requests"),
        field<&SpecialActionsOutput::gains>(),
        field<&SpecialActionsOutput::odometryStep>(Unit::mmRad, "of this frame"),
        field<&SpecialActionsOutput::mayLeave>("the net is at extern"),
        field<&SpecialActionsOutput::action>("name of what is performed; empty at extern")};
  }
};

}  // namespace gt
