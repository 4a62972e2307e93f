#include "simulation/Referee.h"

#include <gtest/gtest.h>

#include "simulation/TestScenes.h"

namespace gt {
namespace {

/// A match that nobody plays, with a referee.
class RefereeMatch : public testing::Test {
 protected:
  void SetUp() override {
    scene_ = matchScene();
    scene_.game.minutes = 1;
    start();
  }
  void start() {
    world_ = worldOf(scene_);
    std::vector<Player> players;
    for (const SceneRobot& robot : scene_.robots) players.push_back(robot.player());
    referee_ = std::make_unique<Referee>(scene_.game, FieldDimensions{}, players);
    commands_.assign(scene_.robots.size(), standingCommand());
  }
  void tick() {
    world_->step(commands_);
    referee_->update(*world_);
  }
  /// Waits until a state is reached; false if it takes longer than a time.
  bool until(GameState state, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / tickSeconds); ++i) {
      if (referee_->state() == state) return true;
      tick();
    }
    return referee_->state() == state;
  }
  int count(GameEventType type) const {
    int n = 0;
    for (const GameEvent& event : referee_->events()) n += event.type == type;
    return n;
  }

  SceneDescription scene_;
  std::unique_ptr<World> world_;
  std::unique_ptr<Referee> referee_;
  std::vector<RobotCommand> commands_;
};

TEST_F(RefereeMatch, initialReadySetPlaying) {
  EXPECT_EQ(referee_->dataFor(0).state, GameState::initial);
  ASSERT_TRUE(until(GameState::ready, 2));
  EXPECT_EQ(referee_->dataFor(0).state, GameState::ready);
  EXPECT_EQ(referee_->dataFor(0).kickOff, KickOff::own);
  EXPECT_EQ(referee_->dataFor(4).kickOff, KickOff::opponent);
  const Time ready = world_->time();
  ASSERT_TRUE(until(GameState::set, 21));
  EXPECT_LT(world_->time() - ready, 6000);  // all stand already
  const Time set = world_->time();
  EXPECT_EQ(referee_->dataFor(3).timeOfLastChange, set);
  ASSERT_TRUE(until(GameState::playing, 10));
  EXPECT_NEAR(static_cast<double>(world_->time() - set), 3000, 10);
  EXPECT_EQ(count(GameEventType::kickOff), 1);
  EXPECT_EQ(world_->ball(0).position, Vector2d(0, 0));
}

TEST_F(RefereeMatch, badlyPlacedRobotsArePutByHand) {
  ASSERT_TRUE(until(GameState::ready, 2));
  world_->placeRobot(1, {0, 900, 300});     // red in the other half
  world_->placeRobot(7, {pi, 200, 0});      // blue in the circle, though red kicks off
  world_->placeRobot(4, {pi, 1000, -900});  // the blue goalie far out
  world_->placeRobot(2, {0, -1900, 100});   // a red striker in the own penalty area
  ASSERT_TRUE(until(GameState::set, 21));
  EXPECT_EQ(count(GameEventType::placedRobot), 4);
  EXPECT_LT(world_->robot(1).pose.translation.x(), -100);
  EXPECT_GT(world_->robot(7).pose.translation.norm(), 290);
  EXPECT_GT(world_->robot(7).pose.translation.x(), 100);
  EXPECT_GT(world_->robot(4).pose.translation.x(), 1600);
  EXPECT_GT(world_->robot(2).pose.translation.x(), -1600);
  EXPECT_EQ(world_->robot(3).pose.translation, Vector2d(-300, -300));  // well placed: untouched
  tick();
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t b = a + 1; b < 8; ++b)
      EXPECT_GT((world_->robot(a).pose.translation - world_->robot(b).pose.translation).norm(),
                150);
}

TEST_F(RefereeMatch, goalsCountForWhoScoresAndTheOtherTeamKicksOff) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeRobot(4, {pi, 1500, 900});  // the blue goalie is away
  tick();
  world_->placeBall(0, {2050, 0}, {600, 0});
  ASSERT_TRUE(until(GameState::ready, 1));
  EXPECT_EQ(referee_->score(TeamColor::red), 1);
  EXPECT_EQ(referee_->score(TeamColor::blue), 0);
  EXPECT_EQ(referee_->dataFor(0).ownScore, 1);
  EXPECT_EQ(referee_->dataFor(5).opponentScore, 1);
  EXPECT_EQ(referee_->dataFor(5).kickOff, KickOff::own);
  const GameEvent& goal = referee_->events().back();
  EXPECT_EQ(goal.type, GameEventType::goal);
  EXPECT_EQ(goal.team, TeamColor::red);
  EXPECT_EQ(goal.number, 0);
  EXPECT_GT(goal.ballPosition.x(), 2143);
}

TEST_F(RefereeMatch, aBallOnTheLineIsNoGoal) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeRobot(4, {pi, 1500, 900});
  world_->placeBall(0, {2140, 0});
  for (int i = 0; i < 100; ++i) tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 0);
  world_->placeBall(0, {2146, 0});
  tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 1);
}

TEST_F(RefereeMatch, ownGoalsAreTold) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeRobot(0, {-pi, -1700, 0});  // the red goalie walks to its own goal
  world_->placeBall(0, {-1900, 0});
  commands_[0] = standingCommand({0, 2.5, 0});
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    commands_[0].joints[legJoint(leg, 2)] = fromDegrees(50);  // low, so that the chest pushes
  ASSERT_TRUE(until(GameState::ready, 5));
  const GameEvent& goal = referee_->events().back();
  EXPECT_EQ(goal.team, TeamColor::blue);
  EXPECT_TRUE(goal.ownGoal);
  EXPECT_EQ(goal.number, 1);
  EXPECT_EQ(goal.scoreBlue, 1);
}

TEST_F(RefereeMatch, aDeflectedShotIsNoOwnGoal) {
  ASSERT_TRUE(until(GameState::playing, 30));
  const std::size_t shooter = 4;  // the blue goalie pushes the ball at the red goal
  world_->placeRobot(0, {0, 0, 1000});
  world_->placeRobot(shooter, {-pi, -1650, 0});
  world_->placeBall(0, {-1850, 0});
  commands_[shooter] = standingCommand({0, 2.5, 0});
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    commands_[shooter].joints[legJoint(leg, 2)] = fromDegrees(50);
  for (int i = 0; i < 500 && world_->ball(0).position.x() > -2050; ++i) tick();
  ASSERT_EQ(world_->ball(0).lastToucher, 4);
  // The red goalie comes from the side until it has touched the ball, too.
  for (double y = 150; y > 60 && world_->ball(0).lastToucher != 0; y -= 2) {
    world_->placeRobot(0, {0, world_->ball(0).position + Vector2d{0, y}});
    tick();
  }
  ASSERT_EQ(world_->ball(0).lastToucher, 0);
  world_->placeRobot(0, {0, 0, 1000});
  world_->placeBall(0, {-2140, 0}, {-200, 0}, false);
  ASSERT_TRUE(until(GameState::ready, 2));
  const GameEvent& goal = referee_->events().back();
  EXPECT_FALSE(goal.ownGoal);
  EXPECT_EQ(goal.team, TeamColor::blue);
  EXPECT_EQ(goal.number, 1);
}

TEST_F(RefereeMatch, halvesAndEnd) {
  ASSERT_TRUE(until(GameState::playing, 30));
  EXPECT_EQ(referee_->half(), 1);
  const Time first = world_->time();
  ASSERT_TRUE(until(GameState::initial, 31));
  EXPECT_NEAR(static_cast<double>(world_->time() - first), 30'000, 10);
  EXPECT_EQ(count(GameEventType::halfTime), 1);
  ASSERT_TRUE(until(GameState::playing, 30));
  EXPECT_EQ(referee_->half(), 2);
  EXPECT_EQ(referee_->events().back().team, TeamColor::blue);
  ASSERT_TRUE(until(GameState::finished, 31));
  EXPECT_EQ(referee_->events().back().type, GameEventType::gameOver);
  EXPECT_EQ(referee_->dataFor(6).state, GameState::finished);
  const std::size_t events = referee_->events().size();
  for (int i = 0; i < 100; ++i) tick();
  EXPECT_EQ(referee_->events().size(), events);
}

TEST_F(RefereeMatch, aStuckBallIsPutElsewhere) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeBall(0, {1900, -1000});
  for (int i = 0; i < 2400; ++i) tick();
  EXPECT_EQ(count(GameEventType::stuckBall), 0);
  for (int i = 0; i < 200; ++i) tick();
  EXPECT_EQ(count(GameEventType::stuckBall), 1);
  EXPECT_EQ(world_->ball(0).position, Vector2d(1050, -675));
}

TEST_F(RefereeMatch, penaltiesReachTheirRobotOnly) {
  ASSERT_TRUE(until(GameState::playing, 30));
  referee_->setPenalty(2, Penalty::obstruction, world_->time());
  EXPECT_EQ(referee_->dataFor(2).state, GameState::penalized);
  EXPECT_EQ(referee_->dataFor(2).penalty, Penalty::obstruction);
  EXPECT_EQ(referee_->dataFor(3).state, GameState::playing);
  referee_->setPenalty(2, Penalty::none, world_->time());
  EXPECT_EQ(referee_->dataFor(2).state, GameState::playing);
}

TEST_F(RefereeMatch, withoutARefereeAllPlay) {
  scene_.game.referee = false;
  start();
  tick();
  EXPECT_EQ(referee_->dataFor(0).state, GameState::playing);
  world_->placeBall(0, {2300, 0});
  tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 0);
}

}  // namespace
}  // namespace gt
