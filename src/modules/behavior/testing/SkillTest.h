#pragma once
#include <gtest/gtest.h>

#include "modules/behavior/skills/BasicBehaviors.h"
#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {

/// Test fixture for skills: the robot moves exactly as requested.
class SkillTest : public ::testing::Test {
 protected:
  /// Executes a skill and moves the robot, for one image (40 ms).
  void cycle(auto& skill) {
    const WorldState state = world.state();
    tactics.update(state);
    skill.execute();
    if (request.type == MotionType::walk)
      world.self.pose =
          world.self.pose * Pose2D{request.walk.rotation * 0.04, request.walk.translation * 0.04};
  }

  ImaginedWorld world;
  Tactics::Parameters tacticsParameters;
  Tactics tactics{tacticsParameters};
  MotionRequest request;
  WalkManner manner;
  Movement::Parameters parameters;
  Movement movement{tactics, request, manner, parameters};
  BasicBehaviors skills{movement};
};

}  // namespace gt
