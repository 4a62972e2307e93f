#include "modules/behavior/potentialfields/FieldPilot.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "modules/behavior/testing/ImaginedWorld.h"
#include "representations/behavior/PotentialFields.h"
#include "streams/Config.h"

namespace gt {
namespace {

using enum PotentialEffect;
using enum PotentialFunction;
using Object = PotentialObject;

TEST(PotentialRuleTest, AttractsFullyBeyondItsRange) {
  for (const PotentialFunction function : {linear, parabolic}) {
    const PotentialRule rule{attract, Object::target, function, 2, 100};
    EXPECT_DOUBLE_EQ(rule.forceAt(0), 0);
    EXPECT_DOUBLE_EQ(rule.forceAt(100), 2);
    EXPECT_DOUBLE_EQ(rule.forceAt(5000), 2);
  }
  EXPECT_DOUBLE_EQ((PotentialRule{attract, Object::target, linear, 2, 100}.forceAt(50)), 1);
  EXPECT_DOUBLE_EQ((PotentialRule{attract, Object::target, parabolic, 2, 100}.forceAt(50)), 0.5);
  EXPECT_DOUBLE_EQ((PotentialRule{attract, Object::target, asymptotic, 2, 100}.forceAt(100)), 1);
}

TEST(PotentialRuleTest, RepelsWithinItsRangeOnly) {
  for (const PotentialFunction function : {linear, parabolic, asymptotic}) {
    const PotentialRule rule{repel, Object::walls, function, 2, 100};
    EXPECT_DOUBLE_EQ(rule.forceAt(100), 0);
    EXPECT_GT(rule.forceAt(20), rule.forceAt(60));
    EXPECT_DOUBLE_EQ(rule.forceAt(0),
                     function == asymptotic ? 2 * PotentialRule::mostRepulsion : 2);
  }
  EXPECT_DOUBLE_EQ((PotentialRule{repel, Object::walls, linear, 2, 100}.forceAt(50)), 1);
  EXPECT_DOUBLE_EQ((PotentialRule{repel, Object::walls, parabolic, 2, 100}.forceAt(50)), 0.5);
  EXPECT_DOUBLE_EQ((PotentialRule{repel, Object::walls, asymptotic, 2, 100}.forceAt(50)), 2);
}

TEST(PotentialSceneTest, AddsTheForcesOfAllRules) {
  PotentialScene scene;
  scene.setTarget({1000, 0});
  scene.objects[Object::ball] = {{{{0, 100}}, false, 50}};
  const PotentialField field{
      {{attract, Object::target, linear, 1, 100}, {repel, Object::ball, linear, 2, 100}}};
  const Vector2d force = scene.force(field, {0, 0});
  EXPECT_NEAR(force.x(), 1, 1e-9);
  EXPECT_NEAR(force.y(), -1, 1e-9) << "50 mm from the ball's surface";
}

TEST(PotentialSceneTest, LeadsOutOfAnAreaByTheShortestWay) {
  const ImaginedWorld world;
  const PotentialScene scene = PotentialScene::of(world.state(), {}, {0, 0});
  const PotentialRule rule{repel, Object::ownPenaltyArea, linear, 1, 100};
  const Vector2d out = scene.force(rule, {-1650, 100});
  EXPECT_NEAR(out.x(), 1, 1e-9);
  EXPECT_NEAR(out.y(), 0, 1e-9);
  EXPECT_GT(scene.force(rule, {-1550, 100}).x(), 0.4);
  EXPECT_EQ(scene.force(rule, {-1450, 100}), Vector2d(0, 0));
}

TEST(PotentialSceneTest, ManySectorsOfOneObstacleRepelAsOne) {
  ImaginedWorld world;
  ObstaclesModel one, many;
  one.enter({300, 0}, true, {1});
  for (double y = -40; y <= 40; y += 20) many.enter({300, y}, true, {1});
  const PotentialRule rule{repel, Object::obstacles, linear, 1, 400};
  const auto force = [&](const ObstaclesModel& model) {
    return PotentialScene::of(world.state(), model, {0, 0}).force(rule, {0, 0});
  };
  EXPECT_NEAR((force(one) - force(many)).norm(), 0, 1e-9);
}

/// A field without walls with bodies that keep the robot off.
class FieldPilotTest : public ::testing::Test {
 protected:
  void put(const Vector2d& opponent) {
    scene.objects[Object::opponents].push_back({{opponent}, false, 110});
  }
  /// A robot that goes where the force leads it. Returns whether it arrives.
  bool goes(Vector2d at, int steps = 400) {
    nearest = 1e9;
    for (int i = 0; i < steps; ++i) {
      const Vector2d force = pilot.update(field, scene, at, parameters);
      if ((scene.target() - at).norm() < parameters.arrival) return true;
      at += 20 * force.normalized();
      for (const PotentialShape& shape : scene.objects[Object::opponents])
        nearest = std::min(nearest, (at - shape.points.front()).norm());
    }
    return false;
  }

  PotentialScene scene;
  PotentialField field{
      {{attract, Object::target, linear, 1, 300}, {repel, Object::opponents, linear, 2, 200}}};
  FieldPilot pilot;
  FieldPilot::Parameters parameters;
  double nearest = 0;
};

TEST_F(FieldPilotTest, GoesStraightWhereNothingIsInTheWay) {
  scene.setTarget({2000, 0});
  const Vector2d force = pilot.update(field, scene, {0, 0}, parameters);
  EXPECT_NEAR(angleOf(force), 0, 1e-9);
  EXPECT_TRUE(pilot.arrives());
  EXPECT_FALSE(pilot.leavesMinimum());
}

TEST_F(FieldPilotTest, GoesRoundABodyRightInTheWay) {
  scene.setTarget({2000, 0});
  put({1000, 0});
  EXPECT_TRUE(goes({0, 0}));
  EXPECT_GT(nearest, 160);
}

TEST_F(FieldPilotTest, LeavesALocalMinimumBetweenBodies) {
  // A bay that is open to the robot.
  scene.setTarget({2000, 0});
  for (const Vector2d& body :
       {Vector2d{900, 350}, {1200, 300}, {1250, 0}, {1200, -300}, {900, -350}})
    put(body);
  parameters.repulsionCost = 0;
  EXPECT_FALSE(goes({0, 0})) << "the bay is a local minimum";
  parameters.repulsionCost = FieldPilot::Parameters{}.repulsionCost;
  EXPECT_TRUE(goes({0, 0}));
  EXPECT_TRUE(goes({1000, 20})) << "from within the bay";
  EXPECT_GT(nearest, 110);
}

TEST_F(FieldPilotTest, WaitsBeforeATargetThatItMustNotReach) {
  scene.setTarget({2000, 0});
  put({2000, 0});
  EXPECT_FALSE(goes({0, 0}));
  EXPECT_FALSE(pilot.leavesMinimum());
  EXPECT_GT(nearest, 160);
}

TEST(PotentialFieldsTest, TheConfigurationHasAllFields) {
  PotentialFields fields;
  const auto read = readConfig("config/potentialfields.cfg", fields);
  ASSERT_TRUE(read) << read.error().text();
  for (const PotentialField* field : {&fields.goToBall, &fields.goToOwnGoal, &fields.goToPoint})
    EXPECT_EQ(std::ranges::count(field->rules, attract, &PotentialRule::effect), 1);
}

}  // namespace
}  // namespace gt
