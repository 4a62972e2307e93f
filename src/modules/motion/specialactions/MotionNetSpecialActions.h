#pragma once
#include "framework/Module.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Joints.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/MotionNet.h"
#include "representations/motion/SpecialActionsOutput.h"

namespace gt {

/// The special action that a motion request asks for; none if it asks for another motion. To get up
/// is a special action, too.
SpecialAction specialActionOf(const MotionRequest&);

/// Solution *GT2003MotionNet* of SpecialActions: walks through the motion net, from one data node
/// to the next, along the transitions that the request selects (report 3.9.2).
class MotionNetSpecialActions {
 public:
  void update(const FrameInfo&, const MotionRequest&, const MotionNet&, Previous<MotionInfo>,
              Previous<JointData>, SpecialActionsOutput&);

 private:
  void advance(const MotionNet&, SpecialAction requested, const JointAngles& now);
  void play(const MotionNet::Node&, SpecialActionsOutput&);

  int node_ = -1;  ///< The data node being played; -1 at extern.
  int framesLeft_ = 0;
  JointAngles from_;  ///< Where the interpolation began.
  Pose2D speed_;
};

}  // namespace gt
