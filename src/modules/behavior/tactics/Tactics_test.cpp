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

TEST_F(TacticsTest, TheTimeToTheBallCountsWhatIsInTheWay) {
  world.ball.position = {1500, 0};
  const double free = tactics().message().estimatedTimeToReachBall;
  world.obstacles.enter({700, 0}, true, world.frame.time);
  EXPECT_EQ(tactics().message().estimatedTimeToReachBall, free + parameters.blockedWay);
  world.obstacles = {};
  world.obstacles.enter({1400, 0}, true, world.frame.time);
  EXPECT_EQ(tactics().message().estimatedTimeToReachBall, free) << "who is at the ball";
}

TEST_F(TacticsTest, WhoDoesNotPlayLeavesTheBallToOthers) {
  world.ball.position = {300, 0};
  const auto isAvailable = [&] {
    return tactics().message().estimatedTimeToReachBall < RoleNegotiation::notAvailable;
  };
  EXPECT_TRUE(isAvailable());
  EXPECT_EQ(tactics().role(), DynamicRole::striker);
  world.body.state = BodyState::fallen;
  EXPECT_FALSE(isAvailable());
  EXPECT_NE(tactics().role(), DynamicRole::striker);
  world.body.state = BodyState::liftedUp;
  EXPECT_FALSE(isAvailable());
  world.body = {};
  world.motion.executed.type = MotionType::getup;
  EXPECT_FALSE(isAvailable());
  world.motion = {};
  EXPECT_TRUE(isAvailable());
  world.game.penalty = Penalty::ballHolding;
  EXPECT_FALSE(isAvailable());
}

TEST_F(TacticsTest, APenalizedTeammateAtTheBallKeepsNobodyOff) {
  world.player.role = PlayerRole::striker1;
  world.ball.position = {1500, 0};
  hear(4, {DynamicRole::striker, RoleNegotiation::notAvailable, 4, 1}, {0, 1400, 0});
  tactics();
  for (int i = 0; i < 50; ++i) {
    world.frame.time = world.ball.lastSeen = world.frame.time + 40;
    world.team.byPlayer[3].timeReceived = world.frame.time;
    tactics();
  }
  EXPECT_EQ(tactics().role(), DynamicRole::striker);
}

TEST_F(TacticsTest, RolesStayWhileTheRadioIsSilent) {
  world.ball.position = {300, 0};
  hear(4, {DynamicRole::striker, 1000, 4, 1}, {0, 200, 0});
  tactics();
  const DynamicRole before = tactics().role();
  EXPECT_NE(before, DynamicRole::striker);
  for (int i = 0; i < 200; ++i) {  // 8 s
    world.frame.time = world.ball.lastSeen = world.frame.time + 40;
    EXPECT_EQ(tactics().role(), before);
  }
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

TEST_F(TacticsTest, ForgetsWhatWasInTheWayBefore) {
  world.obstacles.enter({500, 0}, true, world.frame.time);
  EXPECT_EQ(corridor(tactics().obstacles(), 0, 100), 500);
  world.frame.time = world.frame.time + static_cast<std::int64_t>(parameters.obstacleMemory) + 1;
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
