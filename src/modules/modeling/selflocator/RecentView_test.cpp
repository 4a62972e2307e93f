#include "modules/modeling/selflocator/RecentView.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

/// What a robot sees while it turns its head agrees with its pose; with the pose on the other half
/// only what is no goal.
TEST(RecentView, TellsPosesApart) {
  SyntheticRobot robot{3, {.outliers = 0, .flags = false, .turnsHeadAlways = true, .walks = false}};
  robot.pose = {0.3, 200, -400};
  EdgeModel edges;
  RecentView view;
  Random random{1};
  edges.prepare(robot.field, robot.player.teamColor);
  const Pose2D mirrored = Pose2D{pi, 0, 0} * robot.pose;
  bool goalSeen = false;
  for (int i = 0; i < 40; ++i) {
    robot.step();
    const Bearings bearings = bearingsIn(robot.percept, robot.player.teamColor, robot.field);
    goalSeen |= bearings.count > 0;
    edges.choose(robot.lines, 8, 3000, random);
    view.add(bearings, robot.percept.cameraOffset.head<2>());
    view.add(edges.chosen(), random);
    if (bearings.count < 2) continue;
    EXPECT_GT(view.score(robot.pose, edges.tables()), 0.7);
    EXPECT_LT(view.score(mirrored, edges.tables()), view.score(robot.pose, edges.tables()) - 0.05);
  }
  ASSERT_TRUE(goalSeen);
  double most = 0;
  int given = 0;
  for (int i = 0; i < 2000; ++i)
    if (const auto pose = view.drawPose(edges.tables(), robot.field, random)) {
      const double score = view.score(*pose, edges.tables());
      most = std::max(most, score);
      for (const double least : {score, 0.9 * score})
        EXPECT_EQ(view.score(*pose, edges.tables(), least), score);
      EXPECT_EQ(view.score(*pose, edges.tables(), score + 1e-6), 0);
      ++given;
    }
  EXPECT_GT(given, 1000);
  EXPECT_GT(most, 0.6);
  view.clear();
  EXPECT_EQ(view.score(robot.pose, edges.tables()), 0);
  EXPECT_FALSE(view.drawPose(edges.tables(), robot.field, random));
}

}  // namespace
}  // namespace gt
