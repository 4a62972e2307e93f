#include "modules/modeling/players/GO2003PlayersLocator.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

struct Watcher {
  Watcher() {
    player = {TeamColor::red, PlayerRole::striker1};
    robotPose = {{0, -500, 0}, 1};
  }
  /// An image with players at these places on the field.
  void see(const std::vector<Vector2d>& red, const std::vector<Vector2d>& blue) {
    percept.time = frame.time = frame.time + 40;
    for (auto& team : percept.players) team.clear();
    for (const Vector2d& p : red)
      percept.players[TeamColor::red].push_back(relative(robotPose.pose, p));
    for (const Vector2d& p : blue)
      percept.players[TeamColor::blue].push_back(relative(robotPose.pose, p));
    update();
  }
  void receive(int number, const Vector2d& where, std::int64_t ago = 0, double validity = 0.9) {
    auto& received = messages.byPlayer[static_cast<std::size_t>(number - 1)];
    received.timeReceived = frame.time - ago;
    received.message.playerNumber = number;
    received.message.robotPose = {0, where};
    received.message.robotPoseValidity = validity;
  }
  void update() {
    locator.update(percept, robotPose, messages, field, player, frame, players, debug);
  }

  GO2003PlayersLocator locator;
  PlayersPercept percept;
  RobotPose robotPose;
  TeamMessages messages;
  FieldDimensions field;
  Player player;
  FrameInfo frame;
  PlayersCollection players;
  Debug debug{1024};
};

TEST(GO2003PlayersLocator, PlayersAreWhereManyPerceptsAre) {
  Watcher watcher;
  watcher.players.seenOpponents.resize(1);  // of the solution before
  Random random{7};
  const Vector2d first{500, 300}, second{700, -600};
  for (int i = 0; i < 30; ++i) {
    const Vector2d noise{60 * random.gaussian(), 60 * random.gaussian()};
    watcher.see({}, i % 3 == 0 ? std::vector<Vector2d>{first + noise, second - noise}
                               : std::vector<Vector2d>{first + noise});
  }
  ASSERT_EQ(watcher.players.opponents.size(), 2u);
  EXPECT_TRUE(watcher.players.ownTeam.empty());
  EXPECT_TRUE(watcher.players.seenOpponents.empty());
  EXPECT_LT((watcher.players.opponents[0].position - first).norm(), 60) << "the most distinct";
  EXPECT_LT((watcher.players.opponents[1].position - second).norm(), 80);
  EXPECT_GT(watcher.players.opponents[0].validity, watcher.players.opponents[1].validity);
  EXPECT_EQ(watcher.players.opponents[0].lastSeen, watcher.frame.time);
}

TEST(GO2003PlayersLocator, OnePerceptIsNoPlayer) {
  Watcher watcher;
  watcher.see({}, {{500, 300}});
  EXPECT_TRUE(watcher.players.opponents.empty());
  watcher.see({}, {{510, 310}});
  EXPECT_EQ(watcher.players.opponents.size(), 1u);
}

TEST(GO2003PlayersLocator, PerceptsAreKeptForTwoSeconds) {
  Watcher watcher;
  for (int i = 0; i < 20; ++i) watcher.see({}, {{500, 300}});
  for (int i = 0; i < 10; ++i) watcher.see({}, {});
  EXPECT_EQ(watcher.players.opponents.size(), 1u);
  for (int i = 0; i < 41; ++i) watcher.see({}, {});
  EXPECT_TRUE(watcher.players.opponents.empty());
}

// Report 3.7.1: along the line from the robot to the percept.
TEST(GO2003PlayersLocator, PerceptsOutsideOfTheFieldMoveToItsBorder) {
  Watcher watcher;
  for (int i = 0; i < 5; ++i) watcher.see({}, {{500, 1600}});
  ASSERT_EQ(watcher.players.opponents.size(), 1u);
  const Vector2d p = watcher.players.opponents[0].position;
  EXPECT_NEAR(p.y(), 1350, 1e-6);
  EXPECT_NEAR(p.x(), -500 + 1000 * 1350 / 1600., 1e-6);
  // From outside of the field as well, however wrong the pose.
  watcher.robotPose.pose = {0, -5000, 3000};
  watcher.see({}, {{-2300, 1500}});
  for (const LocatedPlayer& player : watcher.players.opponents) {
    EXPECT_LE(std::abs(player.position.x()), 2100 + 1e-9);
    EXPECT_LE(std::abs(player.position.y()), 1350 + 1e-9);
  }
}

TEST(GO2003PlayersLocator, WhoIsFarOutsideOfTheFieldIsNoPlayer) {
  Watcher watcher;
  for (int i = 0; i < 5; ++i) watcher.see({}, {{500, 1700}, {2450, 0}});
  EXPECT_TRUE(watcher.players.opponents.empty());
}

TEST(GO2003PlayersLocator, TeamMatesTellWhereTheyAre) {
  Watcher watcher;
  watcher.receive(4, {300, 300});
  for (int i = 0; i < 10; ++i) watcher.see({{400, 350}, {-1500, 800}}, {});
  ASSERT_EQ(watcher.players.ownTeam.size(), 2u) << "none twice";
  EXPECT_EQ(watcher.players.ownTeam[0].position, Vector2d(300, 300));
  EXPECT_EQ(watcher.players.ownTeam[0].number, 4);
  EXPECT_LT((watcher.players.ownTeam[1].position - Vector2d{-1500, 800}).norm(), 1e-6);
  EXPECT_EQ(watcher.players.ownTeam[1].number, 0);
}

TEST(GO2003PlayersLocator, OldAndDoubtfulTellingsAndOnesOwnDoNotCount) {
  Watcher watcher;
  watcher.receive(1, {-2000, 0}, 2500);
  watcher.receive(2, {-1000, 500}, 0, 0.1);
  watcher.receive(3, {-500, 0});
  watcher.update();
  EXPECT_TRUE(watcher.players.ownTeam.empty());
}

TEST(GO2003PlayersLocator, FollowsAPlayerThatWalks) {
  Watcher watcher;
  Vector2d truth{0, -700};
  for (int i = 0; i < 100; ++i) {
    truth.y() += 6;  // 150 mm/s
    watcher.see({}, {truth});
    if (i > 10) {
      ASSERT_GE(watcher.players.opponents.size(), 1u);
      EXPECT_LT((watcher.players.opponents[0].position - truth).norm(), 150);
    }
  }
}

TEST(GO2003PlayersLocator, AllocatesNothing) {
  Watcher watcher;
  const std::vector<Vector2d> places{{500, 300}, {700, -600}};
  for (int i = 0; i < 100; ++i) watcher.see(places, places);
  const auto before = allocations();
  for (int i = 0; i < 100; ++i) {
    watcher.percept.time = watcher.frame.time = watcher.frame.time + 40;
    watcher.update();
  }
  EXPECT_EQ(allocations(), before);
}

TEST(GO2003PlayersLocator, NewPerceptsCountMoreThanOldOnes) {
  Watcher watcher;
  const Vector2d before{500, 300}, now{600, 300};
  for (int i = 0; i < 5; ++i) watcher.see({}, {before});
  for (int i = 0; i < 30; ++i) watcher.see({}, {});
  for (int i = 0; i < 5; ++i) watcher.see({}, {now});
  ASSERT_EQ(watcher.players.opponents.size(), 1u);
  // On average 1480 ms old, and 80 ms.
  EXPECT_NEAR(watcher.players.opponents[0].position.x(), 500 + 100 * 0.96 / (0.26 + 0.96), 1);
}

}  // namespace
}  // namespace gt
