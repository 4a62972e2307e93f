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
  /// After so many ms in which the robot sees the ball.
  const Tactics& later(int ms) {
    world.frame.time = world.ball.lastSeen = world.frame.time + ms;
    return tactics();
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
  EXPECT_EQ(tactics().role(), DynamicRole::offensiveSupporter) << "at once";
}

TEST_F(TacticsTest, WhoIsNotHeardForSomeTimeIsNoRival) {
  hear(2, {DynamicRole::striker, 100}, {0, 1000, 0});
  EXPECT_NE(later(2000).role(), DynamicRole::striker);
  EXPECT_NE(later(4000).role(), DynamicRole::striker);
  EXPECT_EQ(later(1000).role(), DynamicRole::striker);
}

TEST_F(TacticsTest, ARobotThatIsNearerTakesTheRoleAfterAWhile) {
  world.ball.position = {300, 0};
  hear(2, {DynamicRole::striker, 100});
  ASSERT_NE(tactics().role(), DynamicRole::striker);
  const double own = tactics().estimatedTimeToReachBall();
  for (int i = 0; i <= 10; ++i) {
    hear(2, {DynamicRole::striker, own + parameters.strikerAdvantage + 10});
    EXPECT_EQ(later(100).role() == DynamicRole::striker, i == 10) << i;
  }
}

TEST_F(TacticsTest, TheStrikerStaysStrikerWhereOthersAreHardlyNearer) {
  world.ball.position = {300, 0};
  ASSERT_EQ(tactics().role(), DynamicRole::striker);
  const double own = tactics().estimatedTimeToReachBall();
  hear(2, {DynamicRole::offensiveSupporter, own / 2});
  EXPECT_EQ(later(500).role(), DynamicRole::striker) << "nobody else is striker";
  hear(2, {DynamicRole::striker, own / 2});
  EXPECT_NE(later(40).role(), DynamicRole::striker);
}

TEST_F(TacticsTest, WhoIsPenalizedOrHasFallenLeavesTheBallToOthers) {
  world.ball.position = {300, 0};
  const double own = tactics().estimatedTimeToReachBall();
  world.body.state = BodyState::fallen;
  EXPECT_EQ(tactics().estimatedTimeToReachBall(), own + parameters.gettingUp);
  world.body = {};
  world.game.penalty = Penalty::ballHolding;
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
  world.frame.time = {1550};
  EXPECT_NEAR((tactics().knownBallOnField() - Vector2d{500, 300}).norm(), 0, 1e-9);
  EXPECT_EQ(tactics().knownBallAge(), 50);
  world.frame.time = {1650};
  EXPECT_NEAR((tactics().knownBall() - Vector2d{900, 0}).norm(), 0, 1e-9);
}

TEST_F(TacticsTest, TeammatesAreObstaclesWhereTheyTellThatTheyAre) {
  world.players.ownTeam = {{{500, 0}, world.frame.time, 0.9, 4}};
  EXPECT_NEAR(corridor(tactics().obstacles(), 0, 100), 420, 30);
  EXPECT_EQ(corridor(world.obstacles, 0, 100), ObstaclesModel::farAway);
  world.players.ownTeam.front().number = 0;  // seen, but it told nothing
  EXPECT_EQ(corridor(tactics().obstacles(), 0, 100), ObstaclesModel::farAway);
}

TEST_F(TacticsTest, KnowsWhenEachTeamScored) {
  world.frame.time = {5000};
  EXPECT_EQ(tactics().ownGoal(), never());
  world.game.ownScore = 1;
  tactics();
  world.frame.time = {7000};
  world.game.opponentScore = 2;
  EXPECT_EQ(tactics().ownGoal(), Time{5000});
  EXPECT_EQ(tactics().opponentGoal(), Time{7000});
  world.frame.time = {8000};
  world.game.ownScore = world.game.opponentScore = 0;  // another game
  EXPECT_EQ(tactics().ownGoal(), Time{5000});
}

}  // namespace
}  // namespace gt
