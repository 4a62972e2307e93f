#include "match/MatchStatistics.h"

#include <gtest/gtest.h>

#include "match/TestPlay.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

/// A robot that stands, and believes to be 300 mm beside where it is.
class Believer : public MatchRobot {
 public:
  Believer() { belief_ = {.pose = &pose_, .state = &state_}; }
  void cycle(const RobotInput& input, RobotOutput& output) override {
    output.joints.angles = standing();
    pose_.pose = input.oracle.robotPose;
    pose_.pose.translation.y() += 300 + (input.now > Time{lostFrom} ? 1000 : 0);
    state_.state = input.now > Time{lostFrom} ? BodyState::fallen : BodyState::standing;
  }

  static constexpr std::int64_t lostFrom = 1200;

 private:
  RobotPose pose_;
  RobotState state_;
};

TEST(MatchStatistics, ErrorsAreSummarized) {
  EXPECT_EQ(statisticsOf({}).maximum, 0);
  const ErrorStatistics statistics = statisticsOf({4, 1, 3, 2, 10});
  EXPECT_EQ(statistics.count, 5);
  EXPECT_EQ(statistics.mean, 4);
  EXPECT_EQ(statistics.median, 3);
  EXPECT_EQ(statistics.maximum, 10);
}

TEST(MatchStatistics, ComparesEachImageWithTheTruth) {
  SceneDescription scene = duelScene({0, -800, 0}, {0, 0});
  scene.robots[0].team = TeamColor::blue;
  scene.game.referee = false;
  auto simulation = Simulation::make(scene, 1);
  ASSERT_TRUE(simulation) << simulation.error().text();
  auto robot = std::make_unique<Believer>();
  const std::vector<MatchRobot*> robots{robot.get()};
  (*simulation)->attach(0, std::move(robot));
  MatchStatistics statistics{**simulation, robots, {{}}};
  for (int i = 0; i < 250; ++i) {
    (*simulation)->step();
    statistics.update();
  }
  MatchSummary summary;
  statistics.summarize(summary);
  ASSERT_EQ(summary.robots.size(), 1u);
  EXPECT_EQ(summary.robots[0].localizationError.count, 50) << "images in two seconds";
  EXPECT_NEAR(summary.robots[0].localizationError.median, 300, 1);
  EXPECT_NEAR(summary.robots[0].localizationError.maximum, 1300, 1);
  EXPECT_NEAR(summary.robots[0].rotationError.maximum, 0, 0.01);
  EXPECT_EQ(summary.robots[0].falls, 1);
  EXPECT_EQ(summary.robots[0].samples.size(), 2u) << "one a second";
  EXPECT_NEAR(summary.robots[0].distanceWalked, 0, 1);
  EXPECT_NEAR(statistics.longestLost(), 0.8, 0.05) << "seconds off by more than a meter";
  EXPECT_EQ(figureOf(summary.play, "ball.left"), 100) << "nobody goes to the ball";
  EXPECT_FALSE(figureOf(summary.play, "blue.strikers.none")) << "the robot has no roles";
  EXPECT_EQ(statistics.localizationErrors().size(), 50u);
}

TEST(MatchStatistics, TheDistanceWalkedKnowsNeitherSwayingNorReferees) {
  auto simulation = Simulation::make(duelScene({0, -800, 0}, {0, 0}), 1);
  ASSERT_TRUE(simulation) << simulation.error().text();
  auto robot = std::make_unique<Believer>();
  const std::vector<MatchRobot*> robots{robot.get()};
  (*simulation)->attach(0, std::move(robot));
  MatchStatistics statistics{**simulation, robots, {{}}};
  // Ten seconds at 100 mm/s, 10 mm to and fro each tick; meanwhile somebody carries it by 2 m.
  for (int i = 0; i < 10 * 125; ++i) {
    const double carried = i < 5 * 125 ? 0 : 2000;
    (*simulation)->world().placeRobot(0, {0, -800 + 0.8 * i, carried + (i % 2 == 0 ? 10. : 0.)});
    (*simulation)->step();
    statistics.update();
  }
  MatchSummary summary;
  statistics.summarize(summary);
  EXPECT_NEAR(summary.robots[0].distanceWalked, 800, 110);
}

}  // namespace
}  // namespace gt
