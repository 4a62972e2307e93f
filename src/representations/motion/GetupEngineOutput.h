#pragma once
#include <string>

#include "representations/infrastructure/JointGains.h"

namespace gt {

/// What the robot does to get up, in this frame (report 3.9). Provided by the GetupEngine.
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
                  field<&GetupEngineOutput::mayLeave>("no action is being performed"),
                  field<&GetupEngineOutput::action>(
                      "the special action that gets it up from where it lies; empty if it is up")};
  }
};

}  // namespace gt
