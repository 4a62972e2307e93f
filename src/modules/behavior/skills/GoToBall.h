#pragma once
#include "modules/behavior/skills/Skill.h"

namespace gt {

/// Walks behind the ball so that the ball is at (x, y) relative to the robot and the robot faces a
/// direction on the field. Walks around the ball if it would otherwise push it in the wrong
/// direction.
struct GoToBall final : Skill<soccer::GoToBall> {
  using Skill::Skill;
  void execute() override;
};

}  // namespace gt
