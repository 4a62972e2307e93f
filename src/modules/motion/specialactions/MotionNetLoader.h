#pragma once
#include <string>

#include "base/Result.h"
#include "motionnet/Compiler.h"
#include "representations/motion/JointDataSequence.h"
#include "representations/motion/MotionNet.h"

namespace gt {

/// The columns of the ERS-210's data lines with their limits (report 5.4, facts 1.2).
motionnet::Rules motionRules();

/// Converts a checked net to the robot's representation. Returns an error if a motion is missing
/// that the motion modules need: stand or getup.
Result<MotionNet> motionNetOf(const motionnet::Net&, const std::string& source);

/// Parses lines of joint data, to be tried on a robot (report J.5.4), with the postures of a
/// folder's motion descriptions. Returns the first error, if there are any. `file` is the name in
/// errors.
Result<JointDataSequence> jointDataOf(const std::string& text, const std::string& file,
                                      const std::string& folder);

/// Compiles all motion descriptions of a folder. Returns the first error, if there are any.
Result<MotionNet> loadMotionNet(const std::string& folder);

}  // namespace gt
