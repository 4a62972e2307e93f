#include "modules/behavior/skills/ContinuousBehaviors.h"

#include <algorithm>

#include "modules/behavior/testing/SkillTest.h"
#include "streams/Config.h"

namespace gt {
namespace {

class ContinuousBehaviorsTest : public SkillTest {
 protected:
  ContinuousBehaviorsTest() { EXPECT_TRUE(readConfig("config/potentialfields.cfg", world.fields)); }

  /// Puts the ball on the field; the robot sees it all the time.
  void seeBall(const Vector2d& ball) {
    world.frame.time = world.frame.time + 40;
    world.ball.position = relative(world.self.pose, ball);
    world.ball.lastSeen = world.frame.time;
  }
  Vector2d robot() const { return world.self.pose.translation; }
};

TEST_F(ContinuousBehaviorsTest, GoesToTheBallWithoutTheOwnPenaltyArea) {
  const Vector2d ball{-1500, -700};
  skills.goToBallContinuously.direction = 0;
  skills.goToBallContinuously.x = 150;
  skills.goToBallContinuously.y = 0;
  world.self.pose = {pi, -1900, 800};
  bool entered = false;
  double nearest = 1e9;
  for (int image = 0; image < 1000; ++image) {
    seeBall(ball);
    cycle(skills.goToBallContinuously);
    entered |= robot().x() < -1600 && std::abs(robot().y()) < 500;
    nearest = std::min(nearest, (robot() - ball).norm());
  }
  EXPECT_FALSE(entered);
  EXPECT_GT(nearest, 110) << "touches the ball";
  EXPECT_LT((relative(world.self.pose, ball) - Vector2d{150, 0}).norm(), 30);
}

TEST_F(ContinuousBehaviorsTest, GoesToTheOwnGoalWithoutTheBall) {
  const Vector2d ball{-800, 0};
  skills.goToOwnGoal.distance = 150;
  skills.goToOwnGoal.angle = 0;
  skills.goToOwnGoal.maxSpeed = 200;
  world.self.pose = {0, 600, 0};
  double nearest = 1e9;
  for (int image = 0; image < 1000; ++image) {
    seeBall(ball);
    cycle(skills.goToOwnGoal);
    nearest = std::min(nearest, (robot() - ball).norm());
  }
  EXPECT_GT(nearest, 180);
  EXPECT_LT((robot() - Vector2d{-1950, 0}).norm(), 60);
  EXPECT_LT(std::abs(world.self.pose.rotation), fromDegrees(5));
}

TEST_F(ContinuousBehaviorsTest, GoesToAPointPastPlayersAndPosts) {
  for (const double y : {-250., 0., 250.})
    world.players.opponents.push_back({{600, y}, world.frame.time, 1, 0});
  world.players.ownTeam = {{{-500, 50}, world.frame.time, 1, 2}};
  skills.goToPointContinuously.x = 1900;
  skills.goToPointContinuously.y = 0;
  skills.goToPointContinuously.angle = 90;
  skills.goToPointContinuously.maxSpeed = 0;
  world.self.pose = {pi / 2, -1500, 0};
  double nearest = 1e9;
  for (int image = 0; image < 1200; ++image) {
    cycle(skills.goToPointContinuously);
    for (const auto* team : {&world.players.opponents, &world.players.ownTeam})
      for (const LocatedPlayer& player : *team)
        nearest = std::min(nearest, (robot() - player.position).norm());
  }
  EXPECT_GT(nearest, 230);
  EXPECT_LT((robot() - Vector2d{1900, 0}).norm(), 60);
  EXPECT_NEAR(toDegrees(world.self.pose.rotation), 90, 5);
}

}  // namespace
}  // namespace gt
