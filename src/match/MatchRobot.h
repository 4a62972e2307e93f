#pragma once
#include "representations/behavior/TeamMessage.h"
#include "robot/platform/Body.h"
#include "simulation/Simulation.h"

namespace gt {

/// A robot of a match, wherever its processes run, with its beliefs and actions.
class MatchRobot : public RobotController {
 public:
  const Belief& belief() const { return belief_; }
  /// The behavior's message to its teammates; null if there is none.
  virtual const BehaviorTeamMessage* decision() const { return nullptr; }
  /// Whether its programs run, as far as is known. A robot that is off does not answer.
  virtual bool isOn() const { return true; }

 protected:
  Belief belief_;
};

/// Images from one team message of a robot to the next: it sends some eight messages a second.
constexpr std::int64_t imagesPerTeamMessage = 3;

}  // namespace gt
