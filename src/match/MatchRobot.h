#pragma once
#include "representations/behavior/TeamMessage.h"
#include "robot/platform/Body.h"
#include "simulation/Simulation.h"

namespace gt {

/// A robot of a match, wherever its processes run, with what it believes and does.
class MatchRobot : public RobotController {
 public:
  const Belief& belief() const { return belief_; }
  /// What it decided to send its teammates.
  virtual const BehaviorTeamMessage* decision() const { return nullptr; }
  /// Whether its programs run, as far as is known: a robot that is off answers nobody.
  virtual bool isOn() const { return true; }

 protected:
  Belief belief_;
};

/// A robot sends its teammates what it knows with every third image, some eight times a second.
constexpr std::int64_t imagesPerTeamMessage = 3;

}  // namespace gt
