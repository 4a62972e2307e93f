#pragma once
#include "modules/behavior/skills/ContinuousBehaviors.h"
#include "modules/behavior/skills/GoToBall.h"
#include "modules/behavior/skills/GoToPoint.h"

namespace gt {

struct Stand final : Skill<soccer::Stand> {
  using Skill::Skill;
  void execute() override { movement_.stand(); }
};

struct Getup final : Skill<soccer::Getup> {
  using Skill::Skill;
  void execute() override { movement_.getup(); }
};

struct Walk final : Skill<soccer::Walk> {
  using Skill::Skill;
  void execute() override { movement_.walk({x, y}, fromDegrees(turn)); }
};

struct PerformSpecialAction final : Skill<soccer::PerformSpecialAction> {
  using Skill::Skill;
  void execute() override { movement_.perform(id); }
};

/// One instance of each basic behavior.
struct BasicBehaviors {
  explicit BasicBehaviors(Movement& movement)
      : stand{movement},
        getup{movement},
        walk{movement},
        performSpecialAction{movement},
        goToPoint{movement},
        goToBall{movement},
        goToPointContinuously{movement},
        goToBallContinuously{movement, goToBall},
        goToOwnGoal{movement} {}

  soccer::BasicBehaviors all() {
    return {stand,
            getup,
            walk,
            performSpecialAction,
            goToPoint,
            goToBall,
            goToPointContinuously,
            goToBallContinuously,
            goToOwnGoal};
  }

  Stand stand;
  Getup getup;
  Walk walk;
  PerformSpecialAction performSpecialAction;
  GoToPoint goToPoint;
  GoToBall goToBall;
  GoToPointContinuously goToPointContinuously;
  GoToBallContinuously goToBallContinuously;
  GoToOwnGoal goToOwnGoal;
};

}  // namespace gt
