#include "PlayWatch.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

/// A red and a blue robot and a ball that lies before the red one.
class PlayWatchTest : public ::testing::Test {
 protected:
  PlayWatchTest() {
    moment.robots = {{.team = TeamColor::red, .position = {850, 0}},
                     {.team = TeamColor::blue, .position = {1900, 0}}};
    moment.ball.position = {1000, 0};
  }
  void see(int ms = 8) {
    watch.see(moment);
    moment.time = moment.time + ms;
  }
  /// The red robot kicks the ball, which leaves with a speed.
  void kick(const Vector2d& speed) {
    moment.robots[0].kicks = true;
    see();
    touch(0);
    moment.ball.speed = speed;
    see(300);
    moment.robots[0].kicks = false;
    see();
  }
  void touch(int robot) {
    moment.ball.lastToucher = robot;
    moment.ball.lastTouched = moment.time;
  }
  double percent(const std::string& name) { return watch.tally().rates.at(name).percent(); }

  PlayMoment moment;
  PlayWatch watch{FieldDimensions{}, 250};
};

TEST_F(PlayWatchTest, TellsWhoseTheNextTouchIs) {
  kick({800, 0});
  EXPECT_EQ(watch.kicks(TeamColor::red), 1);
  EXPECT_EQ(percent("red.kick.hits"), 100);
  touch(1);
  see();
  EXPECT_EQ(percent("red.kick.nextTouch.own"), 0);
  moment.time = moment.time + 1000;
  kick({800, 0});
  moment.time = moment.time + 1000;
  touch(0);
  see();
  EXPECT_EQ(percent("red.kick.nextTouch.own"), 50);
}

TEST_F(PlayWatchTest, TellsShotsThatAGoalieSavesFromGoals) {
  kick({800, 0});
  EXPECT_EQ(percent("red.kick.onGoal"), 100);
  watch.goal(TeamColor::red);
  EXPECT_EQ(percent("blue.goal.saved"), 0);
  EXPECT_EQ(percent("red.kick.nextTouch.own"), 100);
  moment.time = moment.time + 1000;
  kick({800, 100});
  touch(1);
  see();
  EXPECT_EQ(percent("blue.goal.saved"), 50);
  moment.time = moment.time + 1000;
  kick({800, 400});
  EXPECT_NEAR(percent("red.kick.onGoal"), 200 / 3., 1e-9) << "past the post";
  watch.interrupt();
  moment.time = moment.time + 1000;
  kick({500, 0});
  EXPECT_EQ(percent("red.kick.onGoal"), 50) << "too slow";
}

TEST_F(PlayWatchTest, CountsShotsThatEndBeforeTheMotionDoes) {
  moment.robots[0].kicks = true;
  see();
  touch(0);
  moment.ball.speed = {1500, 0};
  see();
  watch.goal(TeamColor::red);
  EXPECT_EQ(percent("red.kick.onGoal"), 100);
  moment.robots[0].kicks = false;
  see();
  moment.robots[0].kicks = true;
  see();
  touch(0);
  see();
  touch(1);
  moment.ball.speed = {-500, 0};
  see();
  EXPECT_EQ(percent("red.kick.onGoal"), 100) << "as the kicker's touch had it roll";
  EXPECT_EQ(percent("blue.goal.saved"), 50);
}

TEST_F(PlayWatchTest, CountsKicksThatMissTheBall) {
  moment.robots[0].kicks = true;
  see();
  moment.robots[0].kicks = false;
  see(9000);
  see();
  EXPECT_EQ(percent("red.kick.hits"), 0);
}

TEST_F(PlayWatchTest, TellsARoleThatFlickers) {
  moment.robots[0].role = DynamicRole::striker;
  moment.time = moment.time + 5000;
  see(1500);
  moment.robots[0].role = DynamicRole::defensiveSupporter;
  see(500);
  EXPECT_EQ(percent("red.roles.kept"), 100);
  moment.robots[0].role = DynamicRole::striker;
  see();
  EXPECT_NEAR(percent("red.roles.kept"), 200 / 3., 1e-9);
}

TEST_F(PlayWatchTest, TellsWhoDoesNotSeeTheBallAndWhetherItIsIdle) {
  moment.robots[0].role = DynamicRole::striker;
  see();
  moment.robots[0].ballUnseen = 2000;
  moment.robots[0].position = {0, 0};
  see();
  EXPECT_EQ(percent("red.striker.unseen"), 50);
  EXPECT_EQ(percent("ball.idle"), 50);
  moment.robots[1].role = DynamicRole::striker;
  see();
  EXPECT_EQ(percent("red.strikers.two"), 0);
  moment.robots[1].team = TeamColor::red;
  see();
  EXPECT_EQ(percent("red.strikers.two"), 25);
}

TEST_F(PlayWatchTest, TellsWhenNobodyIsStriker) {
  see();
  EXPECT_EQ(percent("red.strikers.none"), 100);
  moment.robots[0].role = DynamicRole::striker;
  see();
  EXPECT_EQ(percent("red.strikers.none"), 50);
  moment.robots[0].plays = false;
  see();
  EXPECT_EQ(percent("red.strikers.none"), 50) << "all are penalized";
  moment.robots[1].team = TeamColor::red;
  see();
  EXPECT_NEAR(percent("red.strikers.none"), 200 / 3., 1e-9) << "who is penalized plays no role";
  moment.robots[1].role = DynamicRole::goalie;
  see();
  EXPECT_NEAR(percent("red.strikers.none"), 200 / 3., 1e-9) << "only the goalie is left";
}

TEST_F(PlayWatchTest, MeasuresFromTheLastTouchOfAnotherRobotToTheNextKick) {
  const auto seconds = [&] { return watch.tally().errors.at("red.kick.afterTouch").values; };
  kick({100, 0});
  EXPECT_FALSE(watch.tally().errors.contains("red.kick.afterTouch")) << "nobody else touched it";
  touch(1);
  see(3000);
  touch(0);
  see(1000);
  kick({100, 0});
  ASSERT_EQ(seconds().size(), 1U);
  EXPECT_DOUBLE_EQ(seconds().front(), 4);
  watch.interrupt();
  moment.ball.lastToucher = -1;
  kick({100, 0});
  EXPECT_EQ(seconds().size(), 1U) << "the ball was put there by hand";
}

TEST_F(PlayWatchTest, CountsTheTimeOfFieldPlayersInTheirOwnPenaltyArea) {
  moment.robots[1].position = {1500, 0};
  const auto inside = [&](const Vector2d& position) {
    const double before = watch.inOwnArea(TeamColor::red);
    moment.robots[0].position = position;
    see();
    return watch.inOwnArea(TeamColor::red) > before;
  };
  EXPECT_TRUE(inside({-1700, 450}));
  EXPECT_FALSE(inside({-1700, 550}));
  EXPECT_FALSE(inside({-1550, 0}));
  EXPECT_FALSE(inside({1700, 0})) << "the opponents' one";
  moment.robots[0].role = DynamicRole::goalie;
  EXPECT_FALSE(inside({-1700, 0}));
  EXPECT_EQ(watch.inOwnArea(TeamColor::blue), 0);
  moment.robots[1].position = {1700, 0};
  see();
  EXPECT_GT(watch.inOwnArea(TeamColor::blue), 0);
}

TEST_F(PlayWatchTest, TellsHowGoalsComeAbout) {
  const auto letIn = [&](GoalCause cause) { return watch.letIn(TeamColor::blue, cause); };
  moment.robots[1].role = DynamicRole::goalie;
  kick({1500, 0});
  watch.goal(TeamColor::red);
  EXPECT_EQ(letIn(GoalCause::shot), 1);
  watch.interrupt();
  kick({1500, 0});
  touch(1);
  see();
  watch.goal(TeamColor::red);
  EXPECT_EQ(letIn(GoalCause::shot), 2) << "the goalie only touched it";
  watch.interrupt();
  touch(1);
  moment.ball.position = {1950, 100};
  moment.ball.speed = {600, 0};
  see();
  watch.goal(TeamColor::red);
  EXPECT_EQ(letIn(GoalCause::touched), 1);
  watch.interrupt();
  moment.ball = {.position = {1950, 250}};
  for (int i = 0; i < 150; ++i) see();
  kick({500, 0});
  watch.goal(TeamColor::red);
  EXPECT_EQ(letIn(GoalCause::beside), 1);
  EXPECT_EQ(watch.letIn(TeamColor::red, GoalCause::shot), 0);
}

}  // namespace
}  // namespace gt
