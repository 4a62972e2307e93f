#include "match/ShotWatch.h"

#include "match/TestPlay.h"

namespace gt {
namespace {

class ShotWatchTest : public ::testing::Test, protected TestPlay {
 protected:
  ShotWatchTest() {
    moment.robots[1].role = DynamicRole::goalie;
    moment.robots[1].position = {1950, 0};
  }
  /// The red robot shoots from where the ball lies.
  void shoot(const Vector2d& speed) {
    touch(0);
    moment.ball.speed = speed;
    see(watch);
  }
  std::optional<double> figure(const std::string& name) const {
    PlayFigures figures;
    watch.report(figures);
    return figureOf(figures.take(), name);
  }

  ShotWatch watch{FieldDimensions{}, testDeceleration};
};

TEST_F(ShotWatchTest, FollowsAShotIntoTheGoal) {
  shoot({1500, 100});
  moment.robots[1].position = {1950, 60};
  moment.robots[1].action = "blockLeft";
  see(watch);
  watch.goal(TeamColor::red);
  ASSERT_EQ(watch.shots().size(), 1u);
  const ShotSummary& shot = watch.shots().front();
  EXPECT_EQ(shot.time, Time{1000});
  EXPECT_EQ(shot.team, TeamColor::red);
  EXPECT_EQ(shot.robot, 0);
  EXPECT_EQ(shot.origin, Vector2d(1000, 0));
  EXPECT_NEAR(shot.speed, 1503, 1);
  EXPECT_DOUBLE_EQ(shot.goalieMoved, 60);
  EXPECT_EQ(shot.goalieAction, "blockLeft");
  EXPECT_EQ(shot.end, ShotEnd::goal);
  EXPECT_EQ(figure("red.shots"), 1);
  EXPECT_EQ(figure("red.shots.goal"), 1);
  EXPECT_EQ(figure("blue.goalie.acts"), 100);
  EXPECT_EQ(figure("blue.goalie.moved.mean"), 60);
  EXPECT_EQ(figure("blue.shots"), 0);
}

TEST_F(ShotWatchTest, CountsWhatAGoalieBeginsToDo) {
  for (const char* action : {"readyToBlock", "blockRight"}) {
    moment.robots[1].action = "readyToBlock";
    shoot({1500, 100});
    moment.robots[1].action = action;
    see(watch);
    watch.goal(TeamColor::red);
  }
  ASSERT_EQ(watch.shots().size(), 2u);
  EXPECT_EQ(watch.shots().front().goalieAction, "");
  EXPECT_EQ(watch.shots().back().goalieAction, "blockRight");
}

TEST_F(ShotWatchTest, KnowsWhoStopsABall) {
  for (const auto role : {DynamicRole::goalie, DynamicRole::striker}) {
    moment.robots[1].role = role;
    shoot({1500, 0});
    touch(1);
    moment.ball.speed = {-200, 0};
    see(watch, 2000);
    see(watch);
    EXPECT_EQ(watch.shots().back().end,
              role == DynamicRole::goalie ? ShotEnd::saved : ShotEnd::stopped);
  }
  EXPECT_EQ(watch.shots().size(), 2u);
}

TEST_F(ShotWatchTest, ABallThatTheGoalieTouchesInWasAGoal) {
  shoot({1500, 0});
  touch(1);
  moment.ball.speed = {300, 0};
  see(watch, 400);
  see(watch);
  watch.goal(TeamColor::red);
  ASSERT_EQ(watch.shots().size(), 1u);
  EXPECT_EQ(watch.shots().front().end, ShotEnd::goal);
}

TEST_F(ShotWatchTest, ABallThatDoesNotArriveIsNoGoal) {
  shoot({1500, 0});
  moment.ball.speed = {300, 0};
  see(watch, 2000);
  see(watch);
  ASSERT_EQ(watch.shots().size(), 1u);
  EXPECT_EQ(watch.shots().front().end, ShotEnd::missed);
  shoot({1500, 0});
  watch.interrupt();
  EXPECT_EQ(watch.shots().size(), 2u);
}

TEST_F(ShotWatchTest, ABallThatRollsPastOrAwayIsNoShot) {
  for (const Vector2d& speed : {Vector2d{300, 0}, Vector2d{1500, 900}, Vector2d{-800, 300}})
    shoot(speed);
  watch.interrupt();
  EXPECT_TRUE(watch.shots().empty());
}

}  // namespace
}  // namespace gt
