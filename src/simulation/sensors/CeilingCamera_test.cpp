#include "simulation/sensors/CeilingCamera.h"

#include <gtest/gtest.h>

#include "base/TemporaryFolder.h"
#include "simulation/sensors/CeilingTracker.h"
#include "streams/mcap/Mcap.h"
#include "support/TestScenes.h"

namespace gt {
namespace {

std::vector<Player> playersOf(const SceneDescription& scene) {
  std::vector<Player> players;
  for (const SceneRobot& robot : scene.robots) players.push_back(robot.player());
  return players;
}

TEST(CeilingCamera, MeasuresWhatIsThereWithItsOwnErrors) {
  const SceneDescription scene = matchScene();
  const auto world = worldOf(scene);
  world->placeBall(0, {700, -200});
  CeilingCameraParameters parameters;
  CeilingCamera camera{parameters, playersOf(scene), Random{3}};
  CeilingCameraPercept percept;
  int pictures = 0, seen = 0;
  double error = 0;
  for (int i = 0; i < 1000; ++i) {
    world->step({});
    if (!camera.look(*world, percept)) continue;
    ++pictures;
    for (const MarkedRobot& robot : percept.robots) {
      const std::size_t index = (robot.teamColor == TeamColor::blue ? 4u : 0u) +
                                static_cast<std::size_t>(robot.number - 1);
      error += (robot.pose.translation - world->robot(index).pose.translation).norm();
      ++seen;
    }
  }
  EXPECT_EQ(pictures, 200);
  EXPECT_NEAR(seen, 200 * 8 * 0.98, 30);
  EXPECT_GT(error / seen, 4);
  EXPECT_LT(error / seen, 20);
}

TEST(CeilingCamera, DoesNotSeeTheOtherHalfNorABallBelowARobot) {
  const SceneDescription scene = matchScene();
  const auto world = worldOf(scene);
  CeilingCameraParameters half;
  half.lowX = 0;
  half.overlooked = 0;
  CeilingCamera camera{half, playersOf(scene), Random{3}};
  CeilingCameraPercept percept;
  world->placeBall(0, world->robot(4).pose * Vector2d{100, 0});
  ASSERT_TRUE(camera.look(*world, percept));
  EXPECT_EQ(percept.robots.size(), 4u);
  EXPECT_FALSE(percept.ballSeen);
}

TEST(CeilingTracker, TellsWhatAnOracleWould) {
  CeilingTracker tracker;
  Random random{2};
  OracledWorldState state;
  EXPECT_FALSE(tracker.fill(TeamColor::blue, 3, Time{0}, state));
  CeilingCameraPercept percept;
  Vector2d ball{-500, 0};
  for (int i = 0; i < 100; ++i) {
    percept.time = Time{40 * i};
    ball.x() += 20;  // 500 mm/s
    percept.ballSeen = i % 10 != 9;
    percept.ball = ball + Vector2d{4 * random.gaussian(), 4 * random.gaussian()};
    percept.robots = {{TeamColor::blue, 3, {pi / 2, 1000, 300}},
                      {TeamColor::red, 1, {0, -2000, 0}}};
    tracker.update(percept);
  }
  ASSERT_TRUE(tracker.fill(TeamColor::blue, 3, percept.time, state));
  EXPECT_LT((state.ballPosition + ball).norm(), 15) << "turned by 180 degrees for blue";
  EXPECT_LT((state.ballSpeed - Vector2d{-500, 0}).norm(), 60);
  EXPECT_LT((state.robotPose.translation - Vector2d{-1000, -300}).norm(), 1e-6);
  EXPECT_NEAR(state.robotPose.rotation, -pi / 2, 1e-6);
  ASSERT_EQ(state.others.size(), 1u);
  EXPECT_EQ(state.others[0].number, 1);
  EXPECT_FALSE(tracker.fill(TeamColor::blue, 3, percept.time + 600, state));
  // What no camera can have seen is passed over.
  percept.time = percept.time + 40;
  percept.robots = {{TeamColor::blue, 77, {}}, {TeamColor::blue, 3, {std::nan(""), 0, 0}}};
  tracker.update(percept);
  ASSERT_TRUE(tracker.fill(TeamColor::blue, 3, percept.time, state));
  EXPECT_LT((state.robotPose.translation - Vector2d{-1000, -300}).norm(), 1e-6);
}

TEST(CeilingTracker, ReadsLogs) {
  const TemporaryFolder folder;
  const std::string path = (folder.path() / "ceiling.mcap").string();
  {
    auto log = McapWriter::open(path);
    ASSERT_TRUE(log);
    CeilingCameraPercept percept;
    percept.robots = {{TeamColor::blue, 2, {1, 2, 3}}};
    for (int i = 0; i < 3; ++i) {
      percept.time = Time{40 * i};
      log->write("/CeilingCameraPercept", percept.time, percept);
    }
    ASSERT_TRUE(log->close());
  }
  const auto percepts = readCeilingLog(path);
  ASSERT_TRUE(percepts) << percepts.error().text();
  ASSERT_EQ(percepts->size(), 3u);
  EXPECT_EQ((*percepts)[2].time, Time{80});
  EXPECT_EQ((*percepts)[2].robots[0].pose.translation, Vector2d(2, 3));
  const std::string other = (folder.path() / "other.mcap").string();
  ASSERT_TRUE(McapWriter::open(other)->close());
  EXPECT_FALSE(readCeilingLog(other));
  EXPECT_FALSE(readCeilingLog((folder.path() / "none.mcap").string()));
}

}  // namespace
}  // namespace gt
