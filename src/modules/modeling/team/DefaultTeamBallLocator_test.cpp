#include "modules/modeling/team/DefaultTeamBallLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/TeamScene.h"

namespace gt {
namespace {

struct LatestTeam : TeamScene<DefaultTeamBallLocator> {
  LatestTeam() { robotPose.validity = 0.9; }
  /// The same with a message that came in `ago` ms ago.
  void receive(int n, const Vector2d& where, std::int64_t age, std::int64_t ago, double validity) {
    TeamScene::receive(n, where, age, validity).timeReceived = frame.time - ago;
  }
  void seeBall(std::int64_t ago) {
    ball.position = {300, 0};
    ball.lastSeen = frame.time - ago;
  }
};

TEST(DefaultTeamBallLocator, NobodyKnowsTheBall) {
  LatestTeam team;
  EXPECT_EQ(team.locate().seenBy, 0);
  EXPECT_EQ(team.locate().lastSeen, never());
}

TEST(DefaultTeamBallLocator, OwnBallCountsWhileFresh) {
  LatestTeam team;
  team.receive(1, {-1000, 0}, 0, 0, 1);
  for (const std::int64_t ago : {0, 2500}) {  // Seen, and not perceived for a short time.
    team.seeBall(ago);
    const TeamBallModel ball = team.locate();
    EXPECT_EQ(ball.seenBy, 3);
    EXPECT_LT((ball.position - Vector2d{500, 300}).norm(), 1e-9);
    EXPECT_EQ(ball.lastSeen, team.frame.time - ago);
  }
}

TEST(DefaultTeamBallLocator, ATeamMatesBallCountsWhenTheOwnIsOld) {
  LatestTeam team;
  team.seeBall(8000);
  team.receive(1, {-1000, 0}, 500, 100, 0.9);
  const TeamBallModel ball = team.locate();
  EXPECT_EQ(ball.seenBy, 1);
  EXPECT_EQ(ball.position, (Vector2d{-1000, 0}));
  EXPECT_EQ(ball.lastSeen, team.frame.time - 600);
}

TEST(DefaultTeamBallLocator, AgeAndValidityDecideBetweenTeamMates) {
  LatestTeam team;
  team.receive(1, {1, 0}, 2000, 0, 0.9);
  team.receive(2, {2, 0}, 1000, 0, 0.9);
  EXPECT_EQ(team.locate().seenBy, 2);
  team.receive(2, {2, 0}, 1000, 0, 0.3);  // Does not know where it is.
  EXPECT_EQ(team.locate().seenBy, 1);
}

TEST(DefaultTeamBallLocator, OldBallsAndSilentMatesDoNotCount) {
  LatestTeam team;
  team.receive(1, {1, 0}, 6000, 0, 1);
  team.receive(2, {2, 0}, 0, 3500, 1);
  EXPECT_EQ(team.locate().seenBy, 0);
}

TEST(DefaultTeamBallLocator, OnesOwnMessageIsNotATeamMates) {
  LatestTeam team;
  team.receive(3, {1, 0}, 0, 0, 1);
  EXPECT_EQ(team.locate().seenBy, 0);
}

TEST(DefaultTeamBallLocator, AnOldOwnBallIsBetterThanNone) {
  LatestTeam team;
  team.seeBall(60000);
  EXPECT_EQ(team.locate().seenBy, 3);
}

}  // namespace
}  // namespace gt
