#pragma once
#include "modules/behavior/skills/Skill.h"

namespace gt {

/// Walks behind the ball so that it lies at (x, y) before the robot, which then faces a direction
/// on the field; goes round the ball where it would else push it in the wrong direction.
struct GoToBall final : Skill<soccer::GoToBall> {
  using Skill::Skill;
  void execute() override;
};

}  // namespace gt
