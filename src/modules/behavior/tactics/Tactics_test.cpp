#include "modules/behavior/tactics/Tactics.h"

#include <gtest/gtest.h>

#include <optional>

#include "modules/behavior/tactics/FreeSpace.h"
#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {
namespace {

class TacticsTest : public ::testing::Test {
 protected:
  TacticsTest() {
    world.player = {TeamColor::red, PlayerRole::striker1};
    world.frame.time = world.ball.lastSeen = {1000};
  }

  /// After a cycle on the world as it is.
  const Tactics& tactics() {
    state.emplace(world.state());
    tactics_.update(*state);
    return tactics_;
  }
  TeamMessage& hear(int number, const BehaviorTeamMessage& behavior, const Pose2D& pose = {}) {
    auto& received = world.team.byPlayer[static_cast<std::size_t>(number - 1)];
    received.timeReceived = world.frame.time;
    received.message.playerNumber = number;
    received.message.behavior = behavior;
    received.message.robotPose = pose;
    return received.message;
  }

  ImaginedWorld world;
  std::optional<WorldState> state;
  Tactics::Parameters parameters;
  Tactics tactics_{parameters};
};

TEST_F(TacticsTest, TheNearestRobotIsTheStriker) {
  world.ball.position = {300, 0};
  hear(2, {DynamicRole::offensiveSupporter, 30000});
  EXPECT_EQ(tactics().role(), DynamicRole::striker);
  hear(2, {DynamicRole::striker, 100}, {0, 1000, 0});
  EXPECT_EQ(tactics().role(), DynamicRole::offensiveSupporter);
  world.frame.time = world.frame.time + 3000;
  EXPECT_EQ(tactics().role(), DynamicRole::striker) << "the teammate was not heard for 3 s";
}

TEST_F(TacticsTest, TheStrikerStaysStrikerWhereOthersAreHardlyNearer) {
  world.ball.position = {300, 0};
  ASSERT_EQ(tactics().role(), DynamicRole::striker);
  const double own = tactics().estimatedTimeToReachBall();
  hear(2, {DynamicRole::offensiveSupporter, own - parameters.strikerAdvantage + 10});
  EXPECT_EQ(tactics().role(), DynamicRole::striker);
  hear(2, {DynamicRole::offensiveSupporter, own - parameters.strikerAdvantage - 10});
  EXPECT_NE(tactics().role(), DynamicRole::striker);
}

TEST_F(TacticsTest, TheGoalieStaysGoalieAndIsNoRival) {
  world.player.role = PlayerRole::goalie;
  world.ball.position = {100, 0};
  EXPECT_EQ(tactics().role(), DynamicRole::goalie);
  world.player.role = PlayerRole::striker1;
  hear(1, {DynamicRole::goalie, 1}, {0, 2000, 0});
  EXPECT_EQ(tactics().role(), DynamicRole::striker);
}

TEST_F(TacticsTest, KnowsTheTeamsBallWhereItsOwnIsOld) {
  world.self.pose = {pi / 2, 500, 0};
  world.ball.position = {300, 0};
  world.teamBall.position = {500, 900};
  world.teamBall.lastSeen = {1500};
  world.frame.time = {2900};
  EXPECT_NEAR((tactics().knownBallOnField() - Vector2d{500, 300}).norm(), 0, 1e-9);
  EXPECT_EQ(tactics().knownBallAge(), 1400);
  world.frame.time = {3100};
  EXPECT_NEAR((tactics().knownBall() - Vector2d{900, 0}).norm(), 0, 1e-9);
}

TEST_F(TacticsTest, TeammatesAreObstaclesWhereTheyTellThatTheyAre) {
  world.players.ownTeam = {{{500, 0}, world.frame.time, 0.9, 4}};
  EXPECT_NEAR(corridor(tactics().obstacles(), 0, 100), 420, 30);
  EXPECT_EQ(corridor(world.obstacles, 0, 100), ObstaclesModel::farAway);
  world.players.ownTeam.front().number = 0;  // seen, but it told nothing
  EXPECT_EQ(corridor(tactics().obstacles(), 0, 100), ObstaclesModel::farAway);
}

TEST_F(TacticsTest, TheToleranceGrowsTowardsTheGoal) {
  world.ball.position = {-1500, 0};
  const double far = tactics().kickTolerance();
  EXPECT_NEAR(toDegrees(far), parameters.leastTolerance, 1e-9);
  world.ball.position = {1700, 0};
  EXPECT_GT(tactics().kickTolerance(), far);
  EXPECT_LE(toDegrees(tactics().kickTolerance()), parameters.mostTolerance + 1e-9);
}

TEST_F(TacticsTest, NeverPlaysTheBallAtTheOwnGoal) {
  for (double y = -1250; y <= 1250; y += 50)
    for (double x = -2000; x < 2000; x += 50) {
      world.ball.position = {x, y};
      // Where the ball would cross the own ground line.
      const Vector2d way = direction(tactics().kickDirection());
      if (way.x() >= 0) continue;
      const double crossing = y + way.y() / way.x() * (-2100 - x);
      EXPECT_GT(std::abs(crossing), 250) << x << ' ' << y;
    }
}

// Report 3.8.2: the kick depends on the obstacle model and on the free part of the goal.
TEST_F(TacticsTest, PlaysTheBallPastObstacles) {
  world.self.pose = {0, 1000, 0};
  world.ball.position = {200, 0};
  const Vector2d ballOnField{1200, 0};
  // The keeper stands on the left: the middle of what is free lies on the right.
  for (const double y : {0., 60., 120., 180.})
    world.obstacles.enter(relative(world.self.pose, {1950, y}), true, world.frame.time);
  const double crossing = std::tan(tactics().kickDirection()) * (2100 - ballOnField.x());
  EXPECT_LT(crossing, -70);
  EXPECT_GT(crossing, -300);
  // Far from the goal: past the opponent right before the ball, whichever way is shorter.
  world.obstacles = {};
  world.self.pose = {0, -1000, 0};
  const double free = tactics().kickDirection();
  for (const double y : {-80., -40., 0., 40.})
    world.obstacles.enter({550, y}, true, world.frame.time);
  EXPECT_GT(tactics().kickDirection(), free + fromDegrees(10));
  EXPECT_LT(tactics().kickDirection(), free + fromDegrees(40));
  // One behind does not matter.
  world.obstacles = {};
  world.obstacles.enter({-300, 0}, true, world.frame.time);
  EXPECT_EQ(tactics().kickDirection(), free);
}

TEST_F(TacticsTest, FindsRoomBehindABallAtTheWall) {
  for (const Vector2d& place :
       {Vector2d{494, 1269}, Vector2d{-1723, -1272}, Vector2d{1584, -1109}}) {
    world.ball.position = place;
    const Vector2d behind = place - direction(tactics().kickDirection()) * 280;
    EXPECT_LT(std::abs(behind.y()), 1350) << place.transpose();
    EXPECT_LT(std::abs(behind.x()), 2100) << place.transpose();
  }
}

TEST_F(TacticsTest, ShootsAtTheGoalButPlaysABallBesideItBack) {
  for (const double y : {-700., -500., 500., 700.}) {
    world.ball.position = {1400, y};
    const double crossing = y + std::tan(tactics().kickDirection()) * (2100 - 1400);
    EXPECT_LT(std::abs(crossing), 300) << "in the goal";
    EXPECT_LT(crossing * y, 0) << "on the side that the keeper does not guard";
    world.ball.position = {1900, y};
    const Vector2d way = direction(tactics().kickDirection());
    EXPECT_LT(way.x(), 0);
    EXPECT_LT(way.y() * y, 0);
  }
}

}  // namespace
}  // namespace gt
