#include "simulation/world/Oracle.h"

#include <gtest/gtest.h>

#include "support/TestScenes.h"

namespace gt {
namespace {

TEST(Oracle, EachTeamSeesTheFieldFromItsOwnGoal) {
  const SceneDescription scene = matchScene();
  std::vector<Player> players;
  for (const SceneRobot& robot : scene.robots) players.push_back(robot.player());
  const auto world = worldOf(scene);
  world->placeBall(0, {700, -200}, {30, 40});
  OracledWorldState red, blue;
  askOracle(*world, players, 0, red);
  askOracle(*world, players, 4, blue);
  EXPECT_EQ(red.ballPosition, Vector2d(700, -200));
  EXPECT_EQ(red.ballSpeed, Vector2d(30, 40));
  EXPECT_EQ(blue.ballPosition, Vector2d(-700, 200));
  EXPECT_EQ(blue.ballSpeed, Vector2d(-30, -40));
  EXPECT_LT((red.robotPose.translation - Vector2d(-2000, 0)).norm(), 1e-9);
  EXPECT_LT((blue.robotPose.translation - Vector2d(-2000, 0)).norm(), 1e-9);
  EXPECT_NEAR(normalize(blue.robotPose.rotation), 0, 1e-9);
  ASSERT_EQ(red.others.size(), 7u);
  EXPECT_EQ(red.others[3].teamColor, TeamColor::blue);
  EXPECT_EQ(red.others[3].number, 1);
  EXPECT_LT((red.others[3].pose.translation - Vector2d(2000, 0)).norm(), 1e-9);
  EXPECT_NEAR(std::abs(red.others[3].pose.rotation), pi, 1e-9);
  EXPECT_LT((blue.others[0].pose.translation - Vector2d(2000, 0)).norm(), 1e-9);
  // What a robot sees relative to itself does not depend on the team's coordinates.
  EXPECT_LT((relative(blue.robotPose, blue.ballPosition) -
             relative(world->robot(4).pose, world->ball(0).position))
                .norm(),
            1e-9);
}

}  // namespace
}  // namespace gt
