#include "match/BallLedger.h"

#include "match/TestPlay.h"

namespace gt {
namespace {

class BallLedgerTest : public ::testing::Test, protected TestPlay {
 protected:
  BallUse use() const { return BallLedger::useOf(moment); }
  std::optional<double> figure(const std::string& name) const {
    PlayFigures figures;
    ledger.report(figures);
    return figureOf(figures.take(), name);
  }

  BallLedger ledger{FieldDimensions{}};
};

TEST_F(BallLedgerTest, KnowsWhatTheBallsTimeIsSpentOn) {
  EXPECT_EQ(use(), BallUse::linedUp);
  moment.robots[0].ballUnseen = 2000;
  EXPECT_EQ(use(), BallUse::searched);
  moment.robots[0].kicks = true;
  EXPECT_EQ(use(), BallUse::kicked);
  moment.robots[0].kicks = false;
  moment.ball.speed = {200, 0};
  EXPECT_EQ(use(), BallUse::pushed);
  moment.robots[0].position = {0, 0};
  EXPECT_EQ(use(), BallUse::rolls);
  moment.ball.speed = {0, 0};
  EXPECT_EQ(use(), BallUse::left);
  moment.robots[0].speed = {100, 60};
  EXPECT_EQ(use(), BallUse::comes);
  moment.robots[0].plays = false;
  EXPECT_EQ(use(), BallUse::left) << "who is penalized does not come";
  moment.robots[0].speed = {0, 0};
  moment.robots[0].plays = true;
  moment.robots[0].position = {850, 0};
  moment.robots[1].position = {1200, 0};
  EXPECT_EQ(use(), BallUse::duel);
  moment.robots[1].role = DynamicRole::goalie;
  EXPECT_EQ(use(), BallUse::linedUp) << "the goalie sees it";
  moment.robots[0].position = {0, 0};
  EXPECT_EQ(use(), BallUse::goalie);
}

TEST_F(BallLedgerTest, TheSharesOfItsUsesAreAHundredPercent) {
  see(ledger);
  moment.ball.speed = {500, 0};
  see(ledger);
  see(ledger);
  moment.robots[0].position = {0, 0};
  see(ledger);
  EXPECT_EQ(figure("ball.linedUp"), 25);
  EXPECT_EQ(figure("ball.pushed"), 50);
  EXPECT_EQ(figure("ball.rolls"), 25);
  double sum = 0;
  for (std::size_t i = 0; i < enumCount<BallUse>; ++i)
    sum += *figure("ball." + std::string{enumName(static_cast<BallUse>(i))});
  EXPECT_DOUBLE_EQ(sum, 100);
}

TEST_F(BallLedgerTest, KnowsWhoHasTheBallAndWhereItIs) {
  see(ledger);
  EXPECT_FALSE(figure("red.possession")) << "nobody has touched it yet";
  EXPECT_EQ(figure("red.territory"), 100);
  EXPECT_EQ(figure("blue.territory"), 0);
  EXPECT_EQ(figure("ball.border"), 0);
  EXPECT_EQ(figure("ball.idle"), 0);
  touch(1);
  moment.ball.position = {-1000, 1200};
  see(ledger);
  EXPECT_EQ(figure("red.possession"), 0);
  EXPECT_EQ(figure("blue.possession"), 100);
  EXPECT_EQ(figure("blue.territory"), 50);
  EXPECT_EQ(figure("ball.border"), 50);
  EXPECT_EQ(figure("ball.idle"), 50);
}

}  // namespace
}  // namespace gt
