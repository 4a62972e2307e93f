#include <gtest/gtest.h>

#include <filesystem>

#include "support/TestScenes.h"

namespace gt {
namespace {

constexpr Fidelity bothFidelities[] = {Fidelity::kinematic, Fidelity::dynamic};

/// A match that nobody plays, whose robots stand firmly.
class Placing : public ::testing::TestWithParam<Fidelity> {
 protected:
  void start(SceneDescription scene) {
    scene.fidelity = GetParam();
    world_ = worldOf(scene);
    commands_.assign(world_->activeRobots(), {firmStand(), {}});
  }
  void tick(int ticks = 1) {
    for (int i = 0; i < ticks; ++i) world_->step(commands_);
  }
  /// Whether an overlap or the lack of one has moved nothing in the tick since it was put.
  void expectRest(const std::string& what) {
    const std::vector<Put> puts{world_->puts().begin(), world_->puts().end()};
    tick();
    for (const Put& put : puts) {
      if (!put.ball) {
        const RobotBody& robot = world_->robot(put.index);
        EXPECT_LT((robot.pose.translation - put.place).norm(), 2) << what;
        continue;
      }
      const BallState& ball = world_->ball(put.index);
      EXPECT_LT((ball.position - put.place).norm(), 1 + put.askedSpeed * tickSeconds) << what;
      EXPECT_LT(ball.speed.norm(), put.askedSpeed + 60) << what;  // legs give a little
    }
    for (int n = 0; n < world_->data().ncon; ++n) {
      const mjContact& contact = world_->data().contact[n];
      const auto isBall = [&](int geom) {
        return world_->ballCount() > 0 && world_->model().geom_bodyid[geom] == world_->ballBody(0);
      };
      if (isBall(contact.geom1) || isBall(contact.geom2)) continue;  // it may roll into something
      EXPECT_GT(contact.dist, -0.004)
          << what << " " << nameOf(world_->model(), mjOBJ_GEOM, contact.geom1) << " "
          << nameOf(world_->model(), mjOBJ_GEOM, contact.geom2);
    }
  }

  std::unique_ptr<World> world_;
  std::vector<RobotCommand> commands_;
};

TEST_P(Placing, WhatIsFreeIsPutThereToTheLastDigit) {
  start(matchScene());
  tick(100);
  const Pose2D pose{0.3, 100 / 3., -700 / 3.};
  world_->placeRobot(2, pose);
  world_->placeBall(0, pose * Vector2d{190, 1 / 3.}, {-40, 30});
  EXPECT_EQ(world_->robot(2).pose.translation, pose.translation);
  EXPECT_EQ(world_->ball(0).position, pose * Vector2d(190, 1 / 3.));
  EXPECT_EQ(world_->ball(0).speed, Vector2d(-40, 30));
  // As near as the tables of kicks put it: between the fore legs.
  world_->placeBall(0, pose * Vector2d{150, 0});
  EXPECT_EQ(world_->ball(0).position, pose * Vector2d(150, 0));
  expectRest("free");
}

TEST_P(Placing, WhoeverIsPutLaterMakesWayForWhatWasPutEarlier) {
  start(matchScene());
  tick(100);
  // Each is put where the other one stood: both get their places.
  const Pose2D first = world_->robot(1).pose, second = world_->robot(2).pose;
  world_->placeRobot(1, second);
  EXPECT_GT((world_->robot(1).pose.translation - second.translation).norm(), 50);
  world_->placeRobot(2, first);
  EXPECT_EQ(world_->robot(1).pose.translation, second.translation);
  EXPECT_EQ(world_->robot(2).pose.translation, first.translation);
  const Vector2d foreleg = first * Vector2d{60, 65};
  world_->placeBall(0, foreleg);
  EXPECT_EQ(world_->robot(2).pose.translation, first.translation);
  EXPECT_EQ(world_->puts().back().asked, foreleg);
  EXPECT_NE(world_->puts().back().place, foreleg);
  expectRest("later");
}

TEST_P(Placing, TwoRobotsOfASceneAtOnePlaceAreParted) {
  SceneDescription scene = matchScene();
  scene.robots[5].x = scene.robots[1].x;
  scene.robots[5].y = scene.robots[1].y;
  scene.balls[0].x = scene.robots[2].x + 60;
  scene.balls[0].y = scene.robots[2].y - 60;
  start(scene);
  commands_.assign(8, {});  // on the straight legs with which all begin
  EXPECT_EQ(world_->robot(1).pose.translation, scene.robots[1].pose().translation);
  EXPECT_GT((world_->robot(5).pose.translation - world_->robot(1).pose.translation).norm(), 50);
  expectRest("scene");
}

TEST_P(Placing, EverybodyStandsAsEachSceneSaysAtItsFirstObservation) {
  int scenes = 0;
  for (const auto& entry : std::filesystem::directory_iterator{"scenes"}) {
    if (entry.path().extension() != ".scene") continue;
    ++scenes;
    const auto loaded = loadScene(entry.path().string());
    ASSERT_TRUE(loaded) << loaded.error().text();
    start(*loaded);
    const auto robots = world_->robotCount();
    for (const Put& put : world_->puts()) EXPECT_EQ(put.place, put.asked) << entry.path();
    expectRest(entry.path().string());
    for (std::size_t i = 0; i < robots; ++i) {
      const RobotBody& robot = world_->robot(i);
      EXPECT_EQ(robot.posture, Posture::standing) << entry.path() << " " << i;
      EXPECT_GT(robot.height, 110) << entry.path() << " " << i;
      EXPECT_GT((robot.origin().rotation.transpose() * robot.specificForce).z(), 9000);
    }
  }
  EXPECT_GE(scenes, 12);
}

TEST_P(Placing, HeightTiltAndRollAreThoseItStandsWith) {
  start(matchScene());
  tick(100);
  world_->throwOver(3, Posture::onLeftSide);
  tick(100);
  ASSERT_EQ(world_->robot(3).posture, Posture::onLeftSide);
  world_->placeRobot(3, {0, 0, 700});
  const RobotBody put = world_->robot(3);
  EXPECT_EQ(put.posture, Posture::standing);
  EXPECT_EQ(put.roll, 0);
  EXPECT_GT(put.height, 110);
  tick();
  EXPECT_NEAR(world_->robot(3).height, put.height, 2);
  EXPECT_NEAR(world_->robot(3).tilt, put.tilt, 0.02);
  world_->throwOver(3, Posture::onRightSide);
  EXPECT_NEAR(world_->robot(3).roll, pi / 2, 1e-9);
}

TEST_P(Placing, ABallIsAsFastAsABallMayBe) {
  start(matchScene());
  const double fastest = matchScene().physics.maxSpeed;
  world_->placeBall(0, {0, 900}, {3 * fastest, 4 * fastest});
  EXPECT_NEAR(world_->ball(0).speed.x(), 0.6 * fastest, 1e-9);
  EXPECT_NEAR(world_->ball(0).speed.y(), 0.8 * fastest, 1e-9);
  EXPECT_EQ(world_->puts().back().askedSpeed, 5 * fastest);
}

TEST_P(Placing, NobodyFallsAndNothingIsShotAwayWhereverItIsPut) {
  start(matchScene());
  tick(100);
  Random random{11};
  const auto about = [&](const Vector2d& place, double far) {
    return Vector2d{place + far * Vector2d{random.symmetric(), random.symmetric()}};
  };
  const Vector2d awkward[] = {{2100, 300},  {2250, 0},     {2400, 310},   {2035, 1285},
                              {2100, 1400}, {0, 1400},     {1996, -1246}, {-2150, 835},
                              {0, 2325},    {3225, -1000}, {0, 5000},     {-2250, -305}};
  for (int n = 0; n < 1000 && !HasFailure(); ++n) {
    const Vector2d other = world_->robot(random.index(8)).pose.translation;
    const Vector2d place = random.chance(0.5) ? about(other, 150)
                           : random.chance(0.3)
                               ? about({0, 0}, 2500)
                               : about(awkward[random.index(std::size(awkward))], 120);
    const std::string what = "placement " + std::to_string(n);
    if (random.chance(0.5)) {
      world_->placeRobot(random.index(8), {random.uniform(-pi, pi), place});
    } else {
      const double speed = random.chance(0.5) ? 0 : random.uniform(0, 3000);
      world_->placeBall(0, place, speed * direction(random.uniform(-pi, pi)));
    }
    if (n % 2 == 1) expectRest(what);
    if (n % 50 == 0) tick(60);  // so long it takes to fall
    for (std::size_t i = 0; i < 8; ++i)
      EXPECT_EQ(world_->robot(i).posture, Posture::standing) << what << " robot " << i;
  }
}

INSTANTIATE_TEST_SUITE_P(Fidelities, Placing, ::testing::ValuesIn(bothFidelities),
                         [](const auto& info) { return std::string{enumName(info.param)}; });

}  // namespace
}  // namespace gt
