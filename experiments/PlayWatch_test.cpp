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

}  // namespace
}  // namespace gt
