#include "match/PlayWatch.h"

#include "match/TestPlay.h"

namespace gt {
namespace {

class PlayWatchTest : public ::testing::Test, protected TestPlay {
 protected:
  void see(int ms = 8) { TestPlay::see(watch, ms); }
  void kick(const Vector2d& speed) { TestPlay::kick(watch, speed); }
  void note(GameEventType type, TeamColor team, Penalty penalty = Penalty::none) {
    GameEvent event;
    event.type = type;
    event.team = team;
    event.penalty = penalty;
    watch.note(event);
  }
  /// Of a match of five minutes.
  std::optional<double> figure(const std::string& name) const {
    return figureOf(watch.figures(5), name);
  }

  PlayWatch watch{FieldDimensions{}, testDeceleration};
};

TEST_F(PlayWatchTest, NoticesARoleThatFlickers) {
  moment.robots[0].role = DynamicRole::striker;
  moment.time = moment.time + 5000;
  see(1500);
  moment.robots[0].role = DynamicRole::defensiveSupporter;
  see(500);
  EXPECT_EQ(figure("red.roles.kept"), 100);
  moment.robots[0].role = DynamicRole::striker;
  see();
  EXPECT_NEAR(*figure("red.roles.kept"), 200 / 3., 1e-9);
}

TEST_F(PlayWatchTest, KnowsWhoDoesNotSeeTheBallAndHowManyStrikersThereAre) {
  moment.robots[0].role = DynamicRole::striker;
  see();
  moment.robots[0].ballUnseen = 2000;
  see();
  EXPECT_EQ(figure("red.striker.unseen"), 50);
  moment.robots[1].role = DynamicRole::striker;
  see();
  EXPECT_EQ(figure("red.strikers.two"), 0);
  moment.robots[1].team = TeamColor::red;
  see();
  EXPECT_EQ(figure("red.strikers.two"), 25);
}

TEST_F(PlayWatchTest, NoticesWhenNobodyIsStriker) {
  see();
  EXPECT_EQ(figure("red.strikers.none"), 100);
  moment.robots[0].role = DynamicRole::striker;
  see();
  EXPECT_EQ(figure("red.strikers.none"), 50);
  moment.robots[0].plays = false;
  see();
  EXPECT_EQ(figure("red.strikers.none"), 50) << "all are penalized";
  moment.robots[1].team = TeamColor::red;
  see();
  EXPECT_NEAR(*figure("red.strikers.none"), 200 / 3., 1e-9) << "who is penalized plays no role";
  moment.robots[1].role = DynamicRole::goalie;
  see();
  EXPECT_NEAR(*figure("red.strikers.none"), 200 / 3., 1e-9) << "only the goalie is left";
}

TEST_F(PlayWatchTest, KnowsNothingOfRolesThatNobodyReports) {
  for (PlayMoment::Robot& robot : moment.robots) robot.hasRole = false;
  see();
  EXPECT_FALSE(figure("red.strikers.none"));
}

TEST_F(PlayWatchTest, MeasuresHowFastAStrikerWalksFarFromTheBall) {
  moment.robots[0].role = DynamicRole::striker;
  moment.robots[0].position = {-2000, 0};
  for (int i = 0; i < 400; ++i) {
    see();
    moment.robots[0].position.x() += 200 * tickSeconds;
  }
  EXPECT_NEAR(*figure("red.striker.speed"), 200, 30) << "it began at rest";
  moment.robots[0].position = {900, 0};
  const double before = *figure("red.striker.speed");
  for (int i = 0; i < 100; ++i) see();
  EXPECT_EQ(figure("red.striker.speed"), before) << "it is at the ball";
}

TEST_F(PlayWatchTest, CountsTheTimeOfFieldPlayersInTheirOwnPenaltyArea) {
  moment.robots[1].position = {1500, 0};
  const auto inside = [&](const Vector2d& position) {
    const double before = *figure("red.ownArea");
    moment.robots[0].position = position;
    see();
    return *figure("red.ownArea") > before;
  };
  EXPECT_TRUE(inside({-1700, 450}));
  EXPECT_FALSE(inside({-1700, 550}));
  EXPECT_FALSE(inside({-1550, 0}));
  EXPECT_FALSE(inside({1700, 0})) << "the opponents' one";
  moment.robots[0].role = DynamicRole::goalie;
  EXPECT_FALSE(inside({-1700, 0}));
  EXPECT_EQ(figure("blue.ownArea"), 0);
  moment.robots[1].position = {1700, 0};
  see();
  EXPECT_GT(figure("blue.ownArea"), 0);
}

TEST_F(PlayWatchTest, KnowsHowGoalsComeAbout) {
  const auto letIn = [&](const char* cause) { return *figure(std::string{"blue.letIn."} + cause); };
  const auto score = [&] { note(GameEventType::goal, TeamColor::red); };
  const auto interrupt = [&] { note(GameEventType::kickOff, TeamColor::blue); };
  moment.robots[1].role = DynamicRole::goalie;
  kick({1500, 0});
  score();
  EXPECT_EQ(letIn("shot"), 1);
  interrupt();
  kick({1500, 0});
  touch(1);
  see();
  score();
  EXPECT_EQ(letIn("shot"), 2) << "the goalie only touched it";
  interrupt();
  touch(1);
  moment.ball.position = {1950, 100};
  moment.ball.speed = {600, 0};
  see();
  score();
  EXPECT_EQ(letIn("touched"), 1);
  interrupt();
  moment.ball = {.position = {1950, 250}};
  for (int i = 0; i < 150; ++i) see();
  kick({500, 0});
  score();
  EXPECT_EQ(letIn("beside"), 1);
  interrupt();
  moment.ball = {.position = {1950, 250}};
  moment.robots[1].ballUnseen = 1500;
  for (int i = 0; i < 150; ++i) see();
  kick({500, 0});
  score();
  EXPECT_EQ(letIn("unseen"), 1);
  EXPECT_EQ(figure("red.letIn.shot"), 0);
  EXPECT_EQ(figure("red.goals"), 5);
}

TEST_F(PlayWatchTest, CountsPenaltiesByTheirCause) {
  note(GameEventType::penalty, TeamColor::red, Penalty::illegalDefender);
  note(GameEventType::penalty, TeamColor::red, Penalty::illegalDefender);
  note(GameEventType::penalty, TeamColor::red, Penalty::fieldPlayerCharge);
  EXPECT_EQ(figure("red.penalties"), 3);
  EXPECT_EQ(figure("red.penalties.illegalDefender"), 2);
  EXPECT_EQ(figure("red.penalties.fieldPlayerCharge"), 1);
  EXPECT_EQ(figure("blue.penalties"), 0);
  EXPECT_EQ(figureOf(watch.figures(10), "red.penalties"), 1.5) << "in five minutes";
}

TEST_F(PlayWatchTest, HasTheFiguresOfTheBallKicksAndShots) {
  kick({1500, 0});
  note(GameEventType::goal, TeamColor::red);
  for (const char* name : {"ball.kicked", "red.kicks", "red.shots", "blue.goalie.moved.mean"})
    EXPECT_TRUE(figure(name)) << name;
  EXPECT_EQ(watch.shots().size(), 1u);
}

}  // namespace
}  // namespace gt
