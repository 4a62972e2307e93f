#pragma once
#include <string>

#include "representations/infrastructure/JointGains.h"

namespace gt {

/// The output of the GetupEngine for one frame, while the robot gets up (report 3.9). Provided by
/// the GetupEngine.
struct GetupEngineOutput {
  JointData joints;
  EnumArray<Joint, bool> dontCare;
  JointGains gains;
  bool mayLeave = true;
  std::string action;

  static constexpr auto fields() {
    return Fields{field<&GetupEngineOutput::joints>(),
                  field<&GetupEngineOutput::dontCare>("joints left to other requests"),
                  field<&GetupEngineOutput::gains>(),
                  field<&GetupEngineOutput::mayLeave>(
                      "whether another mover may take over, because no action is performed"),
                  field<&GetupEngineOutput::action>(
                      "special action that makes the robot get up; empty if it is up")};
  }
};

}  // namespace gt
