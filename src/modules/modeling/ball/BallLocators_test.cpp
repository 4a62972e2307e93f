#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/modeling/ball/BallChallengeBallLocator.h"
#include "modules/modeling/ball/ProbabilisticBallLocator.h"
#include "modules/modeling/team/FusedTeamBallLocator.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

/// A ball and a robot on the field, and a locator between them.
template <typename Locator>
struct Scene {
  void step(const Pose2D& walk = {}, const Vector2d& noise = {0, 0}, bool seen = true) {
    frame.time = frame.time + 40;
    const double v = ballSpeed.norm();
    ball += ballSpeed * 0.04;
    if (v > 0) ballSpeed *= std::max(0., 1 - deceleration * 0.04 / v);
    odometry.pose = odometry.pose * walk;
    percept.time = frame.time;
    percept.seen = seen;
    percept.offset = relative(odometry.pose, ball) + noise;
    update();
  }
  void update() {
    if constexpr (std::is_same_v<Locator, ProbabilisticBallLocator>)
      locator.update(percept, camera, odometry, frame, model, debug);
    else
      locator.update(percept, odometry, frame, model, debug);
  }
  double error() const { return (model.position - relative(odometry.pose, ball)).norm(); }
  double speedError() const {
    return (model.speed - rotated(ballSpeed, -odometry.pose.rotation)).norm();
  }

  Locator locator;
  Vector2d ball{800, 100}, ballSpeed{0, 0};
  double deceleration = 0;
  CameraMatrix camera;
  OdometryData odometry;
  BallPercept percept;
  FrameInfo frame;
  BallModel model;
  Debug debug{1024};
};

template <typename Locator>
class BallLocators : public ::testing::Test {};
using Locators = ::testing::Types<BallChallengeBallLocator, ProbabilisticBallLocator>;
TYPED_TEST_SUITE(BallLocators, Locators);

TYPED_TEST(BallLocators, ABallNeverSeenWasNeverSeen) {
  Scene<TypeParam> scene;
  scene.step({}, {0, 0}, false);
  EXPECT_EQ(scene.model.lastSeen, never());
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 0);
}

// Report 3.4.2: seen, not perceived for a short time, not seen for some time.
TYPED_TEST(BallLocators, TellWhichOfTheThreeSituationsHolds) {
  Scene<TypeParam> scene;
  for (int i = 0; i < 26; ++i) scene.step();
  EXPECT_EQ(scene.model.lastSeen, scene.frame.time);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1000);
  const Time last = scene.frame.time;
  for (int i = 0; i < 3; ++i) scene.step({0.02, 6, 2}, {0, 0}, false);
  EXPECT_EQ(scene.model.lastSeen, last);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1000) << "a short period of time";
  EXPECT_LT(scene.error(), 10) << "odometry corrects the position";
  scene.step();
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 1160);
  for (int i = 0; i < 50; ++i) scene.step({0.02, 6, 2}, {0, 0}, false);
  EXPECT_EQ(scene.model.consecutiveTimeSeen, 0);
  EXPECT_LT(scene.error(), 10);
}

TYPED_TEST(BallLocators, FindTheSpeedOfARollingBallWhileTheRobotWalks) {
  Random random{3};
  Scene<TypeParam> scene;
  scene.ball = {600, -400};
  scene.ballSpeed = {150, 250};
  scene.deceleration = 50;
  double position = 0, speed = 0;
  for (int i = 0; i < 60; ++i) {
    scene.step({0.02, 6, 2}, {8 * random.gaussian(), 8 * random.gaussian()});
    if (i < 30) continue;
    position += scene.error() / 30;
    speed += scene.speedError() / 30;
  }
  EXPECT_LT(position, 30);
  EXPECT_LT(speed, 120);
}

TYPED_TEST(BallLocators, SmoothNoise) {
  Random random{4};
  Scene<TypeParam> scene;
  double raw = 0, smoothed = 0;
  for (int i = 0; i < 1000; ++i) {
    const Vector2d noise{30 * random.gaussian(), 15 * random.gaussian()};
    scene.step({}, noise);
    raw += noise.norm();
    smoothed += scene.error();
  }
  EXPECT_LT(smoothed, 0.7 * raw);
}

TYPED_TEST(BallLocators, AllocateNothing) {
  Scene<TypeParam> scene;
  for (int i = 0; i < 10; ++i) scene.step();
  const auto before = allocations();
  for (int i = 0; i < 10; ++i) scene.step({0.02, 6, 2}, {i * 30., 0}, i % 3 != 0);
  EXPECT_EQ(allocations(), before);
}

TEST(BallChallengeBallLocator, AveragesPositionsAndSpeeds) {
  Scene<BallChallengeBallLocator> scene;
  scene.locator.parameters.positions = 2;
  scene.locator.parameters.speeds = 2;
  scene.ball = {500, 0};
  for (const double noise : {0., 10., 40.}) scene.step({}, {noise, 0});
  EXPECT_DOUBLE_EQ(scene.model.position.x(), 525);
  EXPECT_DOUBLE_EQ(scene.model.speed.x(), (10 + 30) / 0.04 / 2);
}

TEST(ProbabilisticBallLocator, NoticesAKickWithinFourPictures) {
  Scene<ProbabilisticBallLocator> scene;
  scene.ball = {200, 0};
  scene.deceleration = 250;
  for (int i = 0; i < 25; ++i) scene.step();
  EXPECT_LT(scene.model.speed.norm(), 30);
  scene.ballSpeed = {1500, 300};
  for (int i = 0; i < 4; ++i) scene.step();
  EXPECT_LT(scene.error(), 40);
  EXPECT_LT(scene.speedError(), 350);
  for (int i = 0; i < 20; ++i) scene.step();
  EXPECT_LT(scene.speedError(), 60);
  for (int i = 0; i < 10; ++i) scene.step({}, {0, 0}, false);  // It rolls on unseen.
  EXPECT_LT(scene.error(), 80);
  EXPECT_GT(scene.model.deviation, 20) << "and becomes uncertain";
}

TEST(ProbabilisticBallLocator, WrongPerceptsAreNoBallUntilTheyAgree) {
  Scene<ProbabilisticBallLocator> scene;
  for (int i = 0; i < 25; ++i) scene.step();
  const Time before = scene.frame.time;
  scene.step({}, {-100, 1500});
  EXPECT_LT(scene.error(), 1);
  EXPECT_EQ(scene.model.lastSeen, before);
  scene.step({}, {900, -700});
  EXPECT_LT(scene.error(), 1);
  scene.ball = {300, -1200};
  for (int i = 0; i < 3; ++i) scene.step();
  EXPECT_LT(scene.error(), 10);
}

TEST(ProbabilisticBallLocator, FindsABallAgainThatLayElsewhereForLong) {
  for (const int pictures : {10, 100, 1000}) {
    Scene<ProbabilisticBallLocator> scene;
    scene.ball = {2500, 400};
    for (int i = 0; i < 25; ++i) scene.step();
    for (int i = 0; i < pictures; ++i) scene.step({0.02, 6, 2}, {0, 0}, false);
    scene.ball = scene.odometry.pose * Vector2d{600, -300};
    for (int i = 0; i < 4; ++i) scene.step();
    EXPECT_LT(scene.error(), 20) << pictures;
  }
}

TEST(ProbabilisticBallLocator, ABallThatShouldBeSeenAndIsNotGivesWay) {
  const auto steps = [](bool looksThere) {
    Scene<ProbabilisticBallLocator> scene;
    for (int i = 0; i < 25; ++i) scene.step();
    scene.step({}, {0, -900});  // Perhaps it is elsewhere.
    scene.camera.valid = looksThere;
    scene.camera.pose = {rotationY(0.25), {100, 0, 200}};
    int n = 0;
    while (scene.error() < 100 && n < 100) {
      scene.step({}, {0, 0}, false);
      ++n;
    }
    return n;
  };
  EXPECT_LT(steps(true), 40);
  EXPECT_EQ(steps(false), 100);
}

struct Team {
  Team() {
    frame.time = {100000};
    player.role = PlayerRole::striker1;
    robotPose = {{pi / 2, 500, 0}, 0.95};
  }
  void tell(int n, const Vector2d& where, std::int64_t age = 0, double validity = 0.95,
            const Vector2d& robot = {0, 0}) {
    TeamMessages::Received& received = messages.byPlayer[static_cast<std::size_t>(n - 1)];
    received.timeReceived = frame.time;
    TeamMessage& m = received.message;
    m.playerNumber = n;
    m.timeSent = {777777 * n};  // Each robot's clock is its own.
    m.ballLastSeen = m.timeSent - age;
    m.ballPosition = where;
    m.robotPose.translation = robot;
    m.robotPoseValidity = validity;
  }
  void seeBall(const Vector2d& onField, std::int64_t ago = 0) {
    ball.position = relative(robotPose.pose, onField);
    ball.lastSeen = frame.time - ago;
  }
  TeamBallModel locate() {
    TeamBallModel result;
    locator.update(ball, robotPose, messages, frame, player, result, debug);
    return result;
  }

  FusedTeamBallLocator locator;
  BallModel ball;
  RobotPose robotPose;
  TeamMessages messages;
  FrameInfo frame;
  Player player;
  Debug debug{1024};
};

TEST(FusedTeamBallLocator, NobodyKnowsTheBallOrOneRobotAlone) {
  Team team;
  EXPECT_EQ(team.locate().seenBy, 0);
  team.seeBall({900, 200}, 60000);
  EXPECT_EQ(team.locate().seenBy, 3) << "an old one is better than none";
  team.tell(1, {-1000, 0}, 500);
  EXPECT_EQ(team.locate().seenBy, 1);
  EXPECT_LT((team.locate().position - Vector2d{-1000, 0}).norm(), 1e-9);
  EXPECT_EQ(team.locate().lastSeen, team.frame.time - 500);
}

TEST(FusedTeamBallLocator, IsSurerThanEachRobotAlone) {
  Random random{5};
  double fused = 0, alone = 0;
  for (int i = 0; i < 300; ++i) {
    Team team;
    const Vector2d ball{-500, 300};
    const auto wrong = [&] {
      return Vector2d{ball + Vector2d{120 * random.gaussian(), 120 * random.gaussian()}};
    };
    const Vector2d first = wrong();
    team.tell(1, first);
    const double before = team.locate().deviation;
    team.tell(2, wrong());
    team.tell(4, wrong());
    const TeamBallModel result = team.locate();
    EXPECT_LT(result.deviation, before);
    fused += (result.position - ball).norm();
    alone += (first - ball).norm();
  }
  EXPECT_LT(fused, 0.75 * alone);
}

TEST(FusedTeamBallLocator, OneLostRobotDoesNoHarm) {
  Team team;
  team.tell(1, {-510, 300});
  team.tell(2, {1500, -900});  // Sure, and wrong.
  team.tell(4, {-490, 280});
  EXPECT_LT((team.locate().position - Vector2d{-500, 290}).norm(), 30);
  team.seeBall({-480, 320});
  EXPECT_LT((team.locate().position - Vector2d{-490, 305}).norm(), 40);
}

TEST(FusedTeamBallLocator, TheOwnBallCountsWhileItIsSeen) {
  Team team;
  team.seeBall({700, 300}, 200);
  team.tell(1, {-500, 300});
  team.tell(2, {-500, 300});
  EXPECT_LT((team.locate().position - Vector2d{700, 300}).norm(), 1e-6);
  team.seeBall({700, 300}, 1500);
  EXPECT_LT((team.locate().position - Vector2d{-500, 300}).norm(), 1) << "the team knows better";
}

TEST(FusedTeamBallLocator, NewAndSureBallsCountMore) {
  Team team;
  team.tell(1, {100, 0}, 2000);
  team.tell(2, {0, 0}, 0);
  EXPECT_LT(team.locate().position.x(), 40);
  team.tell(2, {0, 0}, 0, 0.2);
  EXPECT_GT(team.locate().position.x(), 50);
}

TEST(FusedTeamBallLocator, MovesABallOnForAsLongAsItsMessageTook) {
  Team team;
  team.tell(1, {0, 0});
  team.messages.byPlayer[0].message.ballSpeed = {500, 0};
  team.messages.byPlayer[0].timeReceived = team.frame.time - 200;
  EXPECT_NEAR(team.locate().position.x(), 500 * 0.2 - 250 * 0.2 * 0.2 / 2, 1e-6);
  team.messages.byPlayer[0].message.ballPosition.x() = std::nan("");
  EXPECT_EQ(team.locate().seenBy, 0) << "a message that is no number";
}

}  // namespace
}  // namespace gt
