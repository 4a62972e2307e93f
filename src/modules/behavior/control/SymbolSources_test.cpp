#include "modules/behavior/control/SymbolSources.h"

#include <gtest/gtest.h>

#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {
namespace {

class SymbolSources : public ::testing::Test {
 protected:
  SymbolSources() {
    const KickDescription kick{.motion = "someKick",
                               .x = 150,
                               .y = 20,
                               .direction = 80,
                               .step = 60,
                               .places = {{150, 20, 1, 80, 30, 700, 100}}};
    world.motions.motions = {{}, {"stand", {}}, {"someKick", kick}};
    world.frame.time = world.ball.lastSeen = {1000};
  }
  const SoccerInputs& inputs() {
    state.emplace(world.state());
    tactics.update(*state);
    return inputs_;
  }

  ImaginedWorld world;
  std::optional<WorldState> state;
  Tactics::Parameters parameters;
  Tactics tactics{parameters};
  SoccerInputs inputs_{tactics};
};

TEST_F(SymbolSources, TellTheSpecialActionByItsIndex) {
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{0});
  world.motion.executed.type = MotionType::specialAction;
  world.motion.executed.specialAction = "someKick";
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{2});
  world.motion.executed.specialAction = "stand";
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{1});
  world.motion.executed.specialAction = "moonwalk";
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{0});
  world.motion.executed.type = MotionType::walk;
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{0});
}

TEST_F(SymbolSources, TellWhereAKickPlaysTheBall) {
  constexpr SpecialAction someKick{2};
  EXPECT_EQ(inputs().kickX(someKick), 150);
  EXPECT_EQ(inputs().kickY(someKick), 20);
}

TEST_F(SymbolSources, TellWhereTheGoalieHasBothPostsAtTheSameAngle) {
  constexpr double line = -1980;
  world.frame.time = world.ball.lastSeen = {1000};
  for (const Vector2d& ball : {Vector2d{-500, 500}, Vector2d{-1300, -450}, Vector2d{0, 0}}) {
    world.ball.position = ball;  // the robot is in the middle of the field
    const Vector2d goalie{line, inputs().ballOwnGoalBisector(line, 400)};
    const auto angleTo = [&](double y) {
      return std::abs(normalize(angleOf(Vector2d{Vector2d{-world.field.xGroundline, y} - ball}) -
                                angleOf(Vector2d{goalie - ball})));
    };
    EXPECT_NEAR(angleTo(world.field.yGoal), angleTo(-world.field.yGoal), 1e-9);
  }
  world.ball.position = {-2050, 300};
  EXPECT_EQ(inputs().ballOwnGoalBisector(line, 400), 300);
  EXPECT_EQ(inputs().ballOwnGoalBisector(line, 200), 200);
}

TEST_F(SymbolSources, TellWhereABallThatComesWillCrossTheRobotsLine) {
  world.ball.position = {1000, 300};
  world.ball.speed = {-1000, -200};
  EXPECT_NEAR(inputs().ballSeenSpeed(), std::hypot(1000, 200), 1e-9);
  EXPECT_NEAR(inputs().ballCrossingLeft(), 100, 1e-9);
  EXPECT_GT(inputs().ballCrossingTime(), 1000);
  EXPECT_LT(inputs().ballCrossingTime(), 1300);
  world.ball.speed = {0, -200};
  EXPECT_GT(inputs().ballCrossingTime(), 1e5);
}

TEST_F(SymbolSources, ReportOtherPlayers) {
  EXPECT_EQ(inputs().opponentDistance(), 1e5) << "there is none";
  world.self.pose = {pi / 2, {100, 0}};
  world.players.opponents = {{.position = {100, 900}}, {.position = {-200, 0}}};
  world.players.ownTeam = {{.position = {100, 500}}};
  EXPECT_NEAR(inputs().opponentDistance(), 300, 1e-9);
  EXPECT_NEAR(inputs().opponentAngle(), 90, 1e-9);
  EXPECT_NEAR(inputs().teammateDistance(), 500, 1e-9);
  EXPECT_NEAR(inputs().teammateAngle(), 0, 1e-9);
  EXPECT_EQ(inputs().opponentsWithin(300.1), 1);
  EXPECT_EQ(inputs().opponentsWithin(1000), 2);
  EXPECT_EQ(inputs().robotPoseDistanceTo(100, -70), 70);
}

TEST_F(SymbolSources, ReportBodyAndGame) {
  world.frame.time = {5000};
  world.body.pressedFor[Switch::headBack] = 40;
  world.body.pressedFor[Switch::chin] = 80;
  world.body.tailPan = fromDegrees(-15);
  world.collision.lastCollision = {4500};
  world.game.penalty = Penalty::obstruction;
  world.game.opponentScore = 2;
  world.ball.speed = {-300, 20};
  EXPECT_EQ(inputs().headSwitchPressedFor(), 40);
  EXPECT_EQ(inputs().chinSwitchPressedFor(), 80);
  EXPECT_NEAR(inputs().tailAngle(), -15, 1e-9);
  EXPECT_EQ(inputs().bodyTimeSinceCollision(), 500);
  EXPECT_EQ(inputs().gamePenalty(), Penalty::obstruction);
  EXPECT_EQ(inputs().gameOwnScore(), 0);
  EXPECT_EQ(inputs().gameOpponentScore(), 2);
  EXPECT_EQ(inputs().ballSeenSpeedX(), -300);
  EXPECT_EQ(inputs().ballSeenSpeedY(), 20);
}

TEST_F(SymbolSources, TellWhereARobotSupportsByWhatItsTeamHasLearned) {
  EXPECT_FALSE(inputs().teamHasLearned());
  const std::vector<Vector2d> ahead(4, {500, 300}), behind(4, {-500, 100});
  world.values = {.columns = 2,
                  .rows = 2,
                  .ours = {0, 0, 0, 0},
                  .theirs = {0, 0, 0, 0},
                  .ahead = ahead,
                  .behind = behind};
  world.player.role = PlayerRole::striker2;
  world.ball.position = {-100, -900};
  EXPECT_TRUE(inputs().teamHasLearned());
  const bool isAhead = tactics.role() == DynamicRole::offensiveSupporter;
  EXPECT_EQ(inputs().teamPlaceX(), isAhead ? 500 : -500);
  EXPECT_EQ(inputs().teamPlaceY(), isAhead ? -300 : -100) << "mirrored: the ball is on the right";
}

TEST_F(SymbolSources, CountTheTeammatesThatAreHeard) {
  world.player.role = PlayerRole::goalie;
  for (const int number : {1, 2, 4}) {
    auto& received = world.team.byPlayer[static_cast<std::size_t>(number - 1)];
    received.message.playerNumber = number;
    received.timeReceived = world.frame.time;
  }
  EXPECT_EQ(inputs().teamConnections(), 2);
  world.team.byPlayer[1].timeReceived = never();
  EXPECT_EQ(inputs().teamConnections(), 1);
}

TEST_F(SymbolSources, TellWhichKickIsPlanned) {
  KickDescription& kick = world.motions.motions[2].kick;
  kick.direction = 0;
  kick.length = 3000;
  kick.places = {{150, 20, 1, 0, 5, 3000, 100}};
  world.ball.position = {1000, 0};
  EXPECT_EQ(inputs().kickPlanned(), SpecialAction{2});
  EXPECT_NEAR(inputs().kickFacing(), 0, 10);
  EXPECT_EQ(inputs().kickNow(), SpecialAction{0});
}

TEST_F(SymbolSources, GiveAnglesInDegreesFromWhereTheRobotLooks) {
  world.self.pose = {pi / 2, 0, 0};
  world.ball.position = {0, -500};  // at (500, 0) on the field, on the way to the goal
  EXPECT_NEAR(inputs().ballSeenAngle(), -90, 1e-9);
  EXPECT_NEAR(inputs().ballKnownX(), 500, 1e-9);
  EXPECT_NEAR(inputs().ballAngleAround(0), 0, 1e-9);
  EXPECT_NEAR(inputs().ballAngleAround(-90), 90, 1e-9);
}

TEST_F(SymbolSources, ReportTheOwnGoalFromRobotAndBall) {
  const double own = -world.field.xGroundline;
  world.self.pose = {pi / 2, {own + 300, -400}};
  world.ball.position = {400, -500};  // at (own + 800, 0) on the field
  EXPECT_NEAR(inputs().ownGoalDistance(), 500, 1e-9);
  EXPECT_NEAR(inputs().ownGoalAngle(), toDegrees(std::atan2(400, -300)) - 90, 1e-9);
  EXPECT_NEAR(inputs().ballOwnGoalDistance(), 800, 1e-9);
  EXPECT_NEAR(std::abs(inputs().ballOwnGoalDirection()), 180, 1e-9);
  world.ball.position = {800, -500};  // at (own + 800, 400)
  EXPECT_NEAR(inputs().ballOwnGoalDirection(), toDegrees(std::atan2(-400, -800)), 1e-9);
}

TEST_F(SymbolSources, CalculateInDegrees) {
  EXPECT_EQ(inputs().sqrt(9), 3);
  EXPECT_EQ(inputs().sqrt(-9), 0);
  EXPECT_NEAR(inputs().sin(30), 0.5, 1e-12);
  EXPECT_NEAR(inputs().cos(120), -0.5, 1e-12);
  EXPECT_NEAR(inputs().atan2(1, -1), 135, 1e-12);
  EXPECT_EQ(inputs().atan2(0, 0), 0);
}

TEST_F(SymbolSources, SetEachLedTheTailAndTheSound) {
  SoccerOutputs outputs;
  using Set = void (SoccerOutputs::*)(LedMode);
  const std::pair<Led, Set> all[] = {{Led::lowerLeft, &SoccerOutputs::setLedLowerLeft},
                                     {Led::middleLeft, &SoccerOutputs::setLedMiddleLeft},
                                     {Led::upperLeft, &SoccerOutputs::setLedUpperLeft},
                                     {Led::lowerRight, &SoccerOutputs::setLedLowerRight},
                                     {Led::middleRight, &SoccerOutputs::setLedMiddleRight},
                                     {Led::upperRight, &SoccerOutputs::setLedUpperRight},
                                     {Led::top, &SoccerOutputs::setLedTop},
                                     {Led::tailBlue, &SoccerOutputs::setLedTailBlue},
                                     {Led::tailRed, &SoccerOutputs::setLedTailRed}};
  ASSERT_EQ(std::size(all), enumCount<Led>);
  for (const auto& [led, set] : all) {
    outputs = {};
    (outputs.*set)(LedMode::fastBlink);
    for (std::size_t i = 0; i < enumCount<Led>; ++i)
      EXPECT_EQ(outputs.leds.modes.values[i] == LedMode::fastBlink, static_cast<Led>(i) == led);
  }
  outputs.setTail(TailRequest::wagVertical);
  EXPECT_EQ(outputs.tail, TailRequest::wagVertical);
  outputs.setSound(Sound::bing);
  EXPECT_EQ(outputs.sound.sound, Sound::bing);
}

}  // namespace
}  // namespace gt
