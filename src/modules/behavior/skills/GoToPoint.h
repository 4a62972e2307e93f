#pragma once
#include "modules/behavior/skills/Skill.h"

namespace gt {

/// Walks to a pose on the field, past obstacles. The nearer it comes the slower; far away it walks
/// ahead. Once it has arrived, a small drift of its pose does not set it going again.
class GoToPoint final : public Skill<soccer::GoToPoint> {
 public:
  using Skill::Skill;
  void execute() override;

 private:
  bool arrived_ = false;
};

}  // namespace gt
