#pragma once
#include <string>
#include <string_view>

#include "debug/Debug.h"
#include "framework/Module.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Joints.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/MotionNet.h"
#include "representations/motion/SpecialActionsOutput.h"

namespace gt {

/// The special action that a motion request asks for; empty if it asks for another motion.
std::string_view specialActionOf(const MotionRequest& request);

/// Solution *GT2003MotionNet* of SpecialActions: walks through the motion net, from one data node
/// to the next, along the transitions that the request selects (report 3.9.2).
class GT2003MotionNetSpecialActions {
 public:
  /// Provides the joints of the action being performed, all "don't care" at extern, and the gains
  /// of its `pid` lines, all as recommended at extern and when another motion begins. A request
  /// that is too old or names no motion of the net is none; the latter is reported once.
  void update(const FrameInfo& frame, const MotionRequest& request, const MotionNet& net,
              Previous<MotionInfo> motion, Previous<JointData> joints, SpecialActionsOutput& output,
              Debug& debug);

 private:
  /// The index of the requested motion; extern's if none is requested.
  int requestedMotion(const MotionNet& net, std::string_view name, Debug& debug);
  /// A new motion begins: what lines of the last one set ends.
  void begin();
  void advance(const MotionNet& net, int requested, const JointAngles& now);
  void play(const MotionNet& net, SpecialActionsOutput& output);

  std::string name_;   ///< The motion requested last,
  int requested_ = 0;  ///< and its index; extern's if there is none of that name.

  int node_ = -1;  ///< The data node being played; -1 at extern.
  int framesLeft_ = 0;
  JointAngles from_;  ///< Where the interpolation began.
  Pose2D speed_;
  Pose2D dataStep_;  ///< Of each frame of the data node, by a displacement.
  JointGains gains_;
};

}  // namespace gt
