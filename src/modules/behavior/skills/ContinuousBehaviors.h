#pragma once
#include "modules/behavior/skills/Skill.h"

namespace gt {

// The continuous basic behaviors (report 3.8.3). Their potential fields are composed in
// config/potentialfields.cfg.

/// Walks to a pose on the field.
struct GoToPointContinuously final : Skill<soccer::GoToPointContinuously> {
  using Skill::Skill;
  void execute() override;
};

/// Walks behind the ball so that the robot faces a direction on the field and the ball is at (x, y)
/// relative to the robot. The last part is executed by go_to_ball.
struct GoToBallContinuously final : Skill<soccer::GoToBallContinuously> {
  GoToBallContinuously(Movement& movement, soccer::GoToBall& lastPart)
      : Skill{movement}, lastPart_{lastPart} {}
  void execute() override;

 private:
  soccer::GoToBall& lastPart_;
};

/// Walks to a place in front of the middle of the own goal and faces the opponent's goal.
struct GoToOwnGoal final : Skill<soccer::GoToOwnGoal> {
  using Skill::Skill;
  void execute() override;
};

}  // namespace gt
