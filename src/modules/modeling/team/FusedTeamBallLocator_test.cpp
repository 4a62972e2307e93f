#include "modules/modeling/team/FusedTeamBallLocator.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/modeling/testing/TeamScene.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

using Team = TeamScene<FusedTeamBallLocator>;

TEST(FusedTeamBallLocator, NobodyKnowsTheBallOrOneRobotAlone) {
  Team team;
  EXPECT_EQ(team.locate().seenBy, 0);
  team.seeBall({900, 200}, 60000);
  EXPECT_EQ(team.locate().seenBy, 3) << "an old one is better than none";
  team.receive(1, {-1000, 0}, 500);
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
    team.receive(1, first);
    const double before = team.locate().standardDeviation;
    team.receive(2, wrong());
    team.receive(4, wrong());
    const TeamBallModel result = team.locate();
    EXPECT_LT(result.standardDeviation, before);
    fused += (result.position - ball).norm();
    alone += (first - ball).norm();
  }
  EXPECT_LT(fused, 0.75 * alone);
}

TEST(FusedTeamBallLocator, OneLostRobotDoesNoHarm) {
  Team team;
  team.receive(1, {-510, 300});
  team.receive(2, {1500, -900});  // Sure, and wrong.
  team.receive(4, {-490, 280});
  EXPECT_LT((team.locate().position - Vector2d{-500, 290}).norm(), 30);
  team.seeBall({-480, 320});
  EXPECT_LT((team.locate().position - Vector2d{-490, 305}).norm(), 40);
}

TEST(FusedTeamBallLocator, TheOwnBallCountsWhileItIsSeen) {
  Team team;
  team.seeBall({700, 300}, 200);
  team.receive(1, {-500, 300});
  team.receive(2, {-500, 300});
  EXPECT_LT((team.locate().position - Vector2d{700, 300}).norm(), 1e-6);
  team.seeBall({700, 300}, 1500);
  EXPECT_LT((team.locate().position - Vector2d{-500, 300}).norm(), 50) << "the team knows better";
}

TEST(FusedTeamBallLocator, NewAndSureBallsCountMore) {
  Team team;
  team.receive(1, {100, 0}, 600);
  team.receive(2, {0, 0}, 0);
  EXPECT_LT(team.locate().position.x(), 40);
  team.receive(2, {0, 0}, 0, 0.2);
  EXPECT_GT(team.locate().position.x(), 50);
}

TEST(FusedTeamBallLocator, MovesABallOnForAsLongAsItsMessageTook) {
  Team team;
  team.receive(1, {0, 0});
  team.messages.byPlayer[0].message.ballSpeed = {500, 0};
  team.messages.byPlayer[0].timeReceived = team.frame.time - 200;
  EXPECT_NEAR(team.locate().position.x(), 500 * 0.2 - 250 * 0.2 * 0.2 / 2, 1e-6);
  team.messages.byPlayer[0].message.ballPosition.x() = std::nan("");
  EXPECT_EQ(team.locate().seenBy, 0) << "a message that is no number";
}

}  // namespace
}  // namespace gt
