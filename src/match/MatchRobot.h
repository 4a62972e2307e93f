#pragma once
#include "representations/behavior/TeamMessage.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"
#include "representations/motion/MotionInfo.h"
#include "simulation/Simulation.h"

namespace gt {

/// A robot of a match, wherever its processes run, with what it believes and does, as it is at the
/// end of its last cycle; null if it does not provide that.
class MatchRobot : public RobotController {
 public:
  virtual const RobotPose* pose() const = 0;
  virtual const BallModel* ball() const = 0;
  virtual const RobotState* state() const = 0;
  virtual const MotionInfo* motion() const = 0;
  /// What it decided to send its teammates.
  virtual const BehaviorTeamMessage* decision() const { return nullptr; }
  /// Whether its programs run, as far as is known: a robot that is off answers nobody.
  virtual bool isOn() const { return true; }
};

/// A robot sends its teammates what it knows with every third image, some eight times a second.
constexpr std::int64_t imagesPerTeamMessage = 3;

}  // namespace gt
