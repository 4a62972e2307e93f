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

/// The name of the requested special action; empty if another motion is requested.
std::string_view specialActionOf(const MotionRequest& request);

/// Solution *GT2003MotionNet* of SpecialActions: traverses the motion net, from one data node to
/// the next, along the transitions that the request selects (report 3.9.2).
class GT2003MotionNetSpecialActions {
 public:
  /// Provides the joint angles of the action being performed and the gains of its `pid` lines. At
  /// extern all joints are "don't care". Gains are the recommended ones at extern and when another
  /// motion begins. A request that is too old or names no motion of the net is ignored; the latter
  /// is reported once.
  void update(const FrameInfo& frame, const MotionRequest& request, const MotionNet& net,
              Previous<MotionInfo> motion, Previous<JointData> joints, SpecialActionsOutput& output,
              Debug& debug);

 private:
  /// The index of the requested motion; extern's if none is requested.
  int requestedMotion(const MotionNet& net, std::string_view name, Debug& debug);
  /// Resets what the lines of the last motion have set, at the begin of a new one.
  void begin();
  void advance(const MotionNet& net, int requested, const JointAngles& now);
  void play(const MotionNet& net, SpecialActionsOutput& output);

  std::string name_;   ///< The motion requested last,
  int requested_ = 0;  ///< and its index; extern's if there is none of that name.

  int node_ = -1;  ///< The data node being played; -1 at extern.
  int framesLeft_ = 0;
  JointAngles from_;  ///< Angles at the beginning of the interpolation.
  Pose2D speed_;
  Pose2D dataStep_;  ///< Step of each frame of the data node, from its displacement.
  JointGains gains_;
};

}  // namespace gt
