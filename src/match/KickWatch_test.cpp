#include "match/KickWatch.h"

#include "match/TestPlay.h"

namespace gt {
namespace {

class KickWatchTest : public ::testing::Test, protected TestPlay {
 protected:
  std::optional<double> figure(const std::string& name) const {
    PlayFigures figures;
    watch.report(1, figures);
    return figureOf(figures.take(), name);
  }
  void later() { moment.time = moment.time + 1000; }

  KickWatch watch{FieldDimensions{}, testDeceleration};
};

TEST_F(KickWatchTest, KnowsWhoseTheNextTouchIs) {
  kick(watch, {800, 0});
  EXPECT_EQ(figure("red.kicks"), 1);
  EXPECT_EQ(figure("red.kick.hits"), 100);
  EXPECT_FALSE(figure("red.kick.nextTouch.own"));
  touch(1);
  see(watch);
  EXPECT_EQ(figure("red.kick.nextTouch.own"), 0);
  later();
  kick(watch, {800, 0});
  later();
  touch(0);
  see(watch);
  EXPECT_EQ(figure("red.kick.nextTouch.own"), 50);
  EXPECT_EQ(figure("red.kick.pass"), 0) << "the kicker itself";
  moment.robots[1].team = TeamColor::red;
  later();
  kick(watch, {800, 0});
  touch(1);
  see(watch);
  EXPECT_NEAR(*figure("red.kick.pass"), 100 / 3., 1e-9);
}

TEST_F(KickWatchTest, KnowsShotsThatAGoalieSavesFromGoals) {
  kick(watch, {800, 0});
  EXPECT_EQ(figure("red.kick.onGoal"), 100);
  watch.goal(TeamColor::red);
  EXPECT_EQ(figure("blue.goal.saved"), 0);
  EXPECT_EQ(figure("red.kick.nextTouch.own"), 100);
  later();
  kick(watch, {800, 100});
  touch(1);
  see(watch);
  EXPECT_EQ(figure("blue.goal.saved"), 50);
  later();
  kick(watch, {800, 400});
  EXPECT_NEAR(*figure("red.kick.onGoal"), 200 / 3., 1e-9) << "past the post";
  watch.interrupt();
  later();
  kick(watch, {500, 0});
  EXPECT_EQ(figure("red.kick.onGoal"), 50) << "too slow";
}

TEST_F(KickWatchTest, CountsShotsThatEndBeforeTheMotionDoes) {
  moment.robots[0].kicks = true;
  see(watch);
  touch(0);
  moment.ball.speed = {1500, 0};
  see(watch);
  watch.goal(TeamColor::red);
  EXPECT_EQ(figure("red.kick.onGoal"), 100);
  moment.robots[0].kicks = false;
  see(watch);
  moment.robots[0].kicks = true;
  see(watch);
  touch(0);
  see(watch);
  touch(1);
  moment.ball.speed = {-500, 0};
  see(watch);
  EXPECT_EQ(figure("red.kick.onGoal"), 100) << "as the kicker's touch had it roll";
  EXPECT_EQ(figure("blue.goal.saved"), 50);
}

TEST_F(KickWatchTest, ComparesTheWayWithTheOneThatTheRobotPlanned) {
  moment.robots[0].kickTarget = {1000, 800};
  kick(watch, {800, 0});
  moment.ball.position = {1400, 0};
  see(watch);
  touch(1);
  see(watch);
  EXPECT_NEAR(*figure("red.kick.ofPlanned.median"), 50, 1e-9);
  EXPECT_NEAR(*figure("red.kick.offPlanned.median"), 90, 1e-9);
  moment.robots[0].hasRole = false;
  later();
  kick(watch, {800, 0});
  touch(1);
  see(watch);
  EXPECT_NEAR(*figure("red.kick.ofPlanned.median"), 50, 1e-9) << "its plan is not known";
}

TEST_F(KickWatchTest, CountsKicksThatMissTheBall) {
  moment.robots[0].kicks = true;
  see(watch);
  moment.robots[0].kicks = false;
  see(watch, 9000);
  see(watch);
  EXPECT_EQ(figure("red.kick.hits"), 0);
  EXPECT_FALSE(figure("red.kick.way.mean"));
}

TEST_F(KickWatchTest, MeasuresHowFarAndWhetherBackTheBallGoes) {
  kick(watch, {400, 300});
  moment.ball.position = {1300, 400};
  see(watch);
  touch(1);
  see(watch);
  EXPECT_DOUBLE_EQ(*figure("red.kick.way.mean"), 500);
  EXPECT_EQ(figure("red.kick.back"), 0);
  moment.ball.position = {1000, 0};
  later();
  kick(watch, {-400, 0});
  moment.ball.position = {700, 0};
  see(watch);
  touch(1);
  see(watch);
  EXPECT_DOUBLE_EQ(*figure("red.kick.way.mean"), 400);
  EXPECT_EQ(figure("red.kick.back"), 50);
}

TEST_F(KickWatchTest, ABallThatIsKickedNextHasEndedItsWay) {
  kick(watch, {800, 0});
  moment.ball.position = {2000, 0};
  moment.ball.speed = {0, 0};
  later();
  see(watch);
  moment.robots[1].kicks = true;
  see(watch);
  EXPECT_EQ(figure("red.kick.nextTouch.own"), 0);
  EXPECT_EQ(figure("red.kick.way.mean"), 1000);
  EXPECT_EQ(figure("blue.kicks"), 1);
}

TEST_F(KickWatchTest, MeasuresFromTheLastTouchOfAnotherRobotToTheNextKick) {
  kick(watch, {100, 0});
  EXPECT_FALSE(figure("red.kick.afterTouch.mean")) << "nobody else touched it";
  moment.robots[0].position = {0, 0};
  moment.ball.speed = {60, 0};
  touch(1);
  see(watch, 1500);
  see(watch, 500);
  moment.ball.speed = {0, 0};
  see(watch, 1000);
  moment.robots[0].position = {850, 0};
  touch(0);
  see(watch, 1000);
  kick(watch, {100, 0});
  EXPECT_DOUBLE_EQ(*figure("red.kick.afterTouch.mean"), 4);
  EXPECT_DOUBLE_EQ(*figure("red.kick.afterTouch.rolls.mean"), 1.5);
  EXPECT_DOUBLE_EQ(*figure("red.kick.afterTouch.comes.mean"), 0.5);
  EXPECT_DOUBLE_EQ(*figure("red.kick.afterTouch.linesUp.mean"), 2);
  watch.interrupt();
  kick(watch, {100, 0});
  EXPECT_DOUBLE_EQ(*figure("red.kick.afterTouch.worst"), 4) << "the ball was put there by hand";
}

}  // namespace
}  // namespace gt
