#include "modules/modeling/players/TrackingPlayersLocator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/Random.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

/// Number 3 of the red team at (-500, 0), which looks ahead.
struct Tracker {
  Tracker() {
    player = {TeamColor::red, PlayerRole::striker1};
    robotPose = {{0, -500, 0}, 1};
    camera.valid = true;
    camera.pose.translation = {60, 0, 180};
  }
  /// An image with opponents at these places on the field.
  void see(const std::vector<Vector2d>& blue, const std::vector<Vector2d>& red = {}) {
    percept.time = frame.time = frame.time + 40;
    percept.players[TeamColor::red].clear();
    percept.players[TeamColor::blue].clear();
    for (const Vector2d& p : red)
      percept.players[TeamColor::red].push_back(relative(robotPose.pose, p));
    for (const Vector2d& p : blue)
      percept.players[TeamColor::blue].push_back(relative(robotPose.pose, p));
    update();
  }
  TeamMessage& receive(int number, const Vector2d& where, std::int64_t ago = 0) {
    auto& received = messages.byPlayer[static_cast<std::size_t>(number - 1)];
    received.timeReceived = frame.time - ago;
    received.message.playerNumber = number;
    received.message.robotPose = {0, where};
    received.message.robotPoseValidity = 0.9;
    received.message.timeSent = Time{1000000};
    return received.message;
  }
  /// A teammate reports an opponent that it has seen some milliseconds before it sent that.
  void receiveOpponent(int number, const Vector2d& place, std::int64_t age = 0,
                       double standardDeviation = 100) {
    TeamMessage& message = receive(number, {1500, 1000});
    message.opponents[0] = {place, message.timeSent - age, 0.9, standardDeviation};
  }
  void update() {
    locator.update(percept, camera, robotPose, messages, field, player, frame, players, debug);
  }
  const std::vector<LocatedPlayer>& opponents() const { return players.opponents; }

  TrackingPlayersLocator locator;
  PlayersPercept percept;
  CameraMatrix camera;
  RobotPose robotPose;
  TeamMessages messages;
  FieldDimensions field;
  Player player;
  FrameInfo frame;
  PlayersCollection players;
  Debug debug{1024};
};

TEST(TrackingPlayersLocator, APlayerIsTheMeanOfItsPercepts) {
  Tracker tracker;
  Random random{7};
  const Vector2d first{500, 300}, second{700, -600};
  for (int i = 0; i < 30; ++i) {
    const Vector2d noise{60 * random.gaussian(), 60 * random.gaussian()};
    tracker.see({first + noise, second - noise});
  }
  ASSERT_EQ(tracker.opponents().size(), 2u);
  EXPECT_TRUE(tracker.players.ownTeam.empty());
  for (const Vector2d& place : {first, second})
    EXPECT_TRUE(std::ranges::any_of(tracker.opponents(), [&](const LocatedPlayer& p) {
      return (p.position - place).norm() < 50;
    }));
  EXPECT_GT(tracker.opponents()[0].validity, 0.95);
  EXPECT_LT(tracker.opponents()[0].standardDeviation, 100);
  EXPECT_EQ(tracker.opponents()[0].lastSeen, tracker.frame.time);
}

TEST(TrackingPlayersLocator, OnePerceptIsNoPlayer) {
  Tracker tracker;
  tracker.see({{500, 300}});
  EXPECT_TRUE(tracker.opponents().empty());
  tracker.see({{510, 310}});
  EXPECT_EQ(tracker.opponents().size(), 1u);
}

TEST(TrackingPlayersLocator, PlayersBehindAreRememberedAndForgotten) {
  Tracker tracker;
  for (int i = 0; i < 20; ++i) tracker.see({{500, 300}});
  tracker.robotPose.pose.rotation = pi;
  const int images = static_cast<int>(tracker.locator.parameters.memory / 40);
  for (int i = 0; i < images - 2; ++i) tracker.see({});
  ASSERT_EQ(tracker.opponents().size(), 1u);
  EXPECT_GT(tracker.opponents()[0].standardDeviation, 200) << "it may have walked";
  for (int i = 0; i < 4; ++i) tracker.see({});
  EXPECT_TRUE(tracker.opponents().empty());
}

TEST(TrackingPlayersLocator, APlayerThatShouldBeSeenAndIsNotHasGone) {
  Tracker tracker;
  for (int i = 0; i < 20; ++i) tracker.see({{500, 100}});
  for (int i = 0; i < 10; ++i) tracker.see({});
  EXPECT_TRUE(tracker.opponents().empty());
  // Nobody can say without knowing where the camera looks.
  for (int i = 0; i < 20; ++i) tracker.see({{500, 100}});
  tracker.camera.valid = false;
  for (int i = 0; i < 10; ++i) tracker.see({});
  EXPECT_EQ(tracker.opponents().size(), 1u);
}

TEST(TrackingPlayersLocator, TheDistanceIsLessExactThanTheDirection) {
  Tracker tracker;
  for (int i = 0; i < 4; ++i) tracker.see({{1000, 0}});
  tracker.see({{1150, 150}});
  ASSERT_EQ(tracker.opponents().size(), 1u);
  const Vector2d moved = tracker.opponents()[0].position - Vector2d{1000, 0};
  EXPECT_GT(moved.x(), 10);
  EXPECT_GT(moved.y(), 1.4 * moved.x());
}

TEST(TrackingPlayersLocator, FollowsAPlayerThatWalks) {
  Tracker tracker;
  Vector2d truth{0, -700};
  for (int i = 0; i < 100; ++i) {
    truth.y() += 6;  // 150 mm/s
    tracker.see({truth});
    if (i > 10) {
      ASSERT_EQ(tracker.opponents().size(), 1u);
      EXPECT_LT((tracker.opponents()[0].position - truth).norm(), 150);
    }
  }
}

TEST(TrackingPlayersLocator, PlayersAreOnTheField) {
  Tracker tracker;
  for (int i = 0; i < 5; ++i) tracker.see({{500, 1600}});
  ASSERT_EQ(tracker.opponents().size(), 1u);
  EXPECT_EQ(tracker.opponents()[0].position.y(), tracker.field.ySideline);
}

TEST(TrackingPlayersLocator, WhoIsFarOutsideOfTheFieldIsNoPlayer) {
  Tracker tracker;
  for (int i = 0; i < 10; ++i) tracker.see({{500, 1700}, {-500, -1700}});
  EXPECT_TRUE(tracker.opponents().empty());
}

TEST(TrackingPlayersLocator, WhatIsFarAwayDoesNotCount) {
  Tracker tracker;
  for (int i = 0; i < 5; ++i) tracker.see({{-510 + tracker.locator.parameters.farthest, 0}});
  EXPECT_EQ(tracker.opponents().size(), 1u);
  for (int i = 0; i < 5; ++i) tracker.see({{-490 + tracker.locator.parameters.farthest, 600}});
  EXPECT_EQ(tracker.opponents().size(), 1u);
}

TEST(TrackingPlayersLocator, TeammatesReportWhereTheyAre) {
  Tracker tracker;
  tracker.receive(4, {300, 300});
  for (int i = 0; i < 10; ++i) tracker.see({}, {{400, 350}, {700, -500}});
  ASSERT_EQ(tracker.players.ownTeam.size(), 2u) << "none twice";
  EXPECT_EQ(tracker.players.ownTeam[0].position, Vector2d(300, 300));
  EXPECT_EQ(tracker.players.ownTeam[0].number, 4);
  EXPECT_LT((tracker.players.ownTeam[1].position - Vector2d{700, -500}).norm(), 1e-6);
  EXPECT_EQ(tracker.players.ownTeam[1].number, 0);
}

TEST(TrackingPlayersLocator, KnowsTheOpponentsThatTeammatesSee) {
  Tracker tracker;
  tracker.receiveOpponent(2, {-1000, 800}, 500);
  tracker.update();
  ASSERT_EQ(tracker.opponents().size(), 1u);
  EXPECT_LT((tracker.opponents()[0].position - Vector2d{-1000, 800}).norm(), 1e-9);
  EXPECT_EQ(tracker.opponents()[0].lastSeen, tracker.frame.time - 500);
  EXPECT_TRUE(tracker.players.seenOpponents.empty()) << "what was heard is not passed on";
}

TEST(TrackingPlayersLocator, OneOpponentThatTwoSeeIsOne) {
  Tracker tracker;
  tracker.receiveOpponent(2, {-1000, 800}, 0, 50);
  tracker.receiveOpponent(4, {-800, 800}, 300, 100);
  tracker.locator.parameters.poseNoise = 0;
  tracker.update();
  ASSERT_EQ(tracker.opponents().size(), 1u);
  EXPECT_NEAR(tracker.opponents()[0].position.x(), -960, 1e-6) << "weights are as 4 to 1";
  EXPECT_GT(tracker.opponents()[0].validity, 0.98);
  EXPECT_EQ(tracker.opponents()[0].lastSeen, tracker.frame.time);
  // Two that one robot sees side by side are two.
  tracker.messages = {};
  tracker.receiveOpponent(2, {-1000, 800});
  TeamMessage& message = tracker.messages.byPlayer[1].message;
  message.opponents[1] = message.opponents[0];
  message.opponents[1].position.x() += 250;
  tracker.update();
  EXPECT_EQ(tracker.opponents().size(), 2u);
}

TEST(TrackingPlayersLocator, OldAndDoubtfulReportsAndOnesOwnDoNotCount) {
  Tracker tracker;
  const auto opponents = [&] {
    tracker.update();
    return tracker.opponents().size();
  };
  tracker.receiveOpponent(2, {-1000, 800}, tracker.locator.parameters.memory + 1);
  EXPECT_EQ(opponents(), 0u) << "seen too long ago";
  tracker.receiveOpponent(2, {-1000, 800}, -1);
  EXPECT_EQ(opponents(), 0u) << "not yet seen";
  tracker.receiveOpponent(2, {-1000, 800});
  EXPECT_EQ(opponents(), 1u);
  tracker.messages.byPlayer[1].message.robotPoseValidity = 0.1;
  EXPECT_EQ(opponents(), 0u) << "it does not know where it is";
  EXPECT_TRUE(tracker.players.ownTeam.empty());
  tracker.receiveOpponent(2, {-1000, 800});
  tracker.messages.byPlayer[1].timeReceived = tracker.frame.time - 2500;
  EXPECT_EQ(opponents(), 0u) << "it has been silent";
  tracker.messages = {};
  tracker.receiveOpponent(3, {-1000, 800});
  EXPECT_EQ(opponents(), 0u) << "that is the robot itself";
}

// A radio may bring anything.
TEST(TrackingPlayersLocator, ReportsOfNonsenseDoNotCount) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  Tracker tracker;
  tracker.receiveOpponent(2, {std::nan(""), 0});
  tracker.update();
  EXPECT_TRUE(tracker.opponents().empty());
  tracker.receiveOpponent(2, {0, 0}, 0, infinite);
  tracker.update();
  EXPECT_TRUE(tracker.opponents().empty());
  tracker.receiveOpponent(2, {0, 0});
  SeenOpponent& seen = tracker.messages.byPlayer[1].message.opponents[0];
  seen.lastSeen.ms = std::numeric_limits<std::int64_t>::min();
  tracker.update();
  EXPECT_TRUE(tracker.opponents().empty());
  tracker.receiveOpponent(2, {0, 0});
  tracker.messages.byPlayer[1].message.playerNumber = 1000;
  seen.validity = 1e9;
  tracker.update();
  ASSERT_EQ(tracker.opponents().size(), 1u) << "the sender's place in the list is its number";
  EXPECT_EQ(tracker.opponents()[0].validity, 1);
}

TEST(TrackingPlayersLocator, AllocatesNothing) {
  Tracker tracker;
  const std::vector<Vector2d> places{{500, 300}, {700, -600}};
  for (int i = 0; i < 100; ++i) tracker.see(places, places);
  tracker.receiveOpponent(2, {-1000, 800});
  tracker.update();
  const auto before = allocations();
  for (int i = 0; i < 100; ++i) {
    tracker.percept.time = tracker.frame.time = tracker.frame.time + 40;
    tracker.update();
  }
  EXPECT_EQ(allocations(), before);
}

}  // namespace
}  // namespace gt
