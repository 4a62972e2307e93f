#include "simulation/Challenge.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gt {
namespace {

class ChallengeTest : public ::testing::Test {
 protected:
  void begin(ChallengeKind kind, const std::vector<Vector2d>& targets = {}, bool random = false) {
    SceneDescription scene;
    scene.file = "scenes/test.scene";
    scene.game.referee = false;
    SceneRobot& robot = scene.robots.emplace_back();
    robot.name = "red3";
    robot.role = PlayerRole::striker1;
    robot.x = -1900;
    if (kind == ChallengeKind::obstacles) {
      SceneRobot& obstacle = scene.extras.emplace_back();
      obstacle.name = "obstacle";
      obstacle.team = TeamColor::blue;
      obstacle.y = 500;
    }
    if (kind == ChallengeKind::ball) scene.balls.emplace_back().x = 500;
    auto made = Simulation::make(scene, 1);
    ASSERT_TRUE(made) << made.error().text();
    simulation = std::move(*made);
    ChallengeParameters parameters;
    parameters.kind = kind;
    parameters.random = random;
    parameters.start = 0.4;
    auto owned = std::make_unique<Challenge>(parameters, targets, Random{7});
    challenge = owned.get();
    simulation->add(std::move(owned));
  }
  void run(double seconds) {
    for (int tick = 0; tick < seconds / tickSeconds; ++tick) simulation->step();
  }
  World& world() { return simulation->world(); }
  void wag() {
    for (int swing = 0; swing < 60; ++swing) {
      world().turnJoint(0, Joint::tailPan, fromDegrees(swing % 2 == 0 ? 20 : -20));
      simulation->step();
    }
  }

  std::unique_ptr<Simulation> simulation;
  const Challenge* challenge = nullptr;
};

TEST_F(ChallengeTest, PressesTheBackSwitchAtTheStart) {
  begin(ChallengeKind::ball);
  run(0.3);
  EXPECT_FALSE(simulation->sensors(0).isPressed(Switch::back));
  EXPECT_TRUE(challenge->notes().empty());
  run(0.2);
  EXPECT_TRUE(simulation->sensors(0).isPressed(Switch::back));
  run(0.3);
  EXPECT_FALSE(simulation->sensors(0).isPressed(Switch::back));
  EXPECT_EQ(challenge->notes().size(), 1u);
}

TEST_F(ChallengeTest, EndsWithTheGoal) {
  begin(ChallengeKind::ball);
  run(1);
  world().placeBall(0, {2120, 0});
  run(0.1);
  EXPECT_FALSE(challenge->finished()) << "not with all of the ball";
  world().placeBall(0, {-2200, 0});
  run(0.1);
  EXPECT_FALSE(challenge->finished()) << "red's own goal";
  world().placeBall(0, {2200, 100});
  run(0.1);
  EXPECT_TRUE(challenge->succeeded());
  EXPECT_NEAR(challenge->seconds(), 0.8, 0.05);
}

TEST_F(ChallengeTest, CountsContactsUntilTheOtherGoal) {
  begin(ChallengeKind::obstacles);
  run(2);
  EXPECT_EQ(challenge->contacts(), 0);
  Pose2D pushed = world().robot(1).pose;
  pushed.translation.x() += 20;
  world().placeRobot(1, pushed);
  run(0.5);
  EXPECT_EQ(challenge->contacts(), 1);
  world().placeRobot(0, {0, -1000, 0});
  run(2);
  world().placeRobot(0, {0, 1950, 400});
  run(0.1);
  EXPECT_FALSE(challenge->finished()) << "beside the goal";
  world().placeRobot(0, {0, 1950, 0});
  run(0.1);
  EXPECT_TRUE(challenge->succeeded());
  EXPECT_EQ(challenge->contacts(), 1);
}

TEST_F(ChallengeTest, CountsPointsWhereTheTailWags) {
  begin(ChallengeKind::localization, {{500, 0}, {0, 700}, {-900, 0}});
  run(1);
  EXPECT_EQ(challenge->points(), 0);
  world().placeRobot(0, {0, 530, 0});
  run(0.6);
  EXPECT_EQ(challenge->points(), 0) << "it does not wag its tail";
  wag();
  EXPECT_EQ(challenge->points(), 3);
  wag();
  EXPECT_EQ(challenge->points(), 3) << "each stop counts once";
  world().placeRobot(0, {0, 70, 700});
  run(0.6);
  wag();
  EXPECT_EQ(challenge->points(), 4);
  EXPECT_FALSE(challenge->finished());
  world().placeRobot(0, {0, -900, 300});
  run(0.6);
  wag();
  EXPECT_EQ(challenge->points(), 4);
  EXPECT_TRUE(challenge->finished());
  EXPECT_NEAR(challenge->targets()[1].distance, 70, 10);
}

TEST_F(ChallengeTest, DrawsPlacesThatARobotReaches) {
  const FieldDimensions field;
  const auto places = randomTargets(field, Random{3});
  EXPECT_EQ(places.size(), 5u);
  EXPECT_NE(places, randomTargets(field, Random{4}));
  for (const Vector2d& place : places) {
    EXPECT_LT(std::abs(place.x()), field.xGroundline - 200);
    EXPECT_LT(std::abs(place.y()), field.ySideline - 200);
  }
  begin(ChallengeKind::obstacles, {}, true);
  const Vector2d before = world().robot(1).pose.translation;
  run(0.1);
  EXPECT_NE(world().robot(1).pose.translation, before);
  EXPECT_EQ(world().robot(0).pose.translation.x(), -1900);
}

}  // namespace
}  // namespace gt
