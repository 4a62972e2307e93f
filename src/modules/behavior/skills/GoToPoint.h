#pragma once
#include "modules/behavior/skills/Skill.h"

namespace gt {

/// Walks to a pose on the field, past obstacles. It slows down near the pose; far away it walks
/// ahead. After it has arrived, a small drift of the robot's pose does not make it walk again.
class GoToPoint final : public Skill<soccer::GoToPoint> {
 public:
  using Skill::Skill;
  void execute() override;

 private:
  bool arrived_ = false;
};

}  // namespace gt
