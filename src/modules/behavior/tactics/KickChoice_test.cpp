#include "modules/behavior/tactics/KickChoice.h"

#include <gtest/gtest.h>

#include <optional>
#include <utility>

#include "base/Random.h"
#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {
namespace {

constexpr int ahead = 1, left = 2, behind = 3;

/// A kick that plays a ball from around a place in one direction.
MotionNet::Motion kickOf(const char* name, const Vector2d& place, double direction,
                         double seconds) {
  KickDescription kick;
  kick.motion = name;
  kick.x = place.x();
  kick.y = place.y();
  kick.direction = direction;
  kick.length = 2500;
  kick.seconds = seconds;
  kick.strike = seconds / 2;
  kick.step = 20;
  for (int x = -40; x <= 40; x += 20)
    for (int y = -40; y <= 40; y += 20)
      kick.places.push_back({place.x() + x, place.y() + y, 1, direction, 5, 2500, 200});
  return {name, kick};
}

class KickChoiceTest : public ::testing::Test {
 protected:
  KickChoiceTest() {
    world.motions.motions = {{},
                             kickOf("ahead", {150, 0}, 0, 1.2),
                             kickOf("left", {150, 0}, 60, 1.2),
                             kickOf("behind", {100, 150}, 180, 1.5)};
    world.player.role = PlayerRole::striker1;
    world.self.pose = {0, 1000, 0};
    ball = {1150, 0};
    world.frame.time = {1000};
  }
  const KickChoice& choose() {
    const WorldState state = world.state();
    choice->update(state, world.obstacles, relative(world.self.pose, ball), unseen);
    return *choice;
  }
  /// A strange team: the ball is worth more in its own half.
  void valueTheOwnHalf() {
    world.values.columns = world.values.rows = 2;
    world.values.ours = world.values.theirs = {1, 1, -1, -1};
    world.values.ahead = world.values.behind = std::vector<Vector2d>(4, Vector2d::Zero());
  }
  /// Where a ball that is played as planned crosses the opponent's ground line.
  double crossing() {
    const Vector2d way = direction(choose().plan().direction);
    return ball.y() + way.y() / way.x() * (world.field.xGroundline - ball.x());
  }

  ImaginedWorld world;
  Vector2d ball;  ///< on the field
  std::int64_t unseen = 0;
  KickChoice::Parameters parameters;
  std::optional<KickChoice> choice{parameters};
};

TEST_F(KickChoiceTest, ShootsAtTheGoalAtOnce) {
  EXPECT_EQ(choose().plan().motion, ahead);
  EXPECT_LT(std::abs(crossing()), 240);
  EXPECT_EQ(choose().now(), ahead);
  EXPECT_NEAR((choice->aim() - ball).norm(), 2500, 1) << "as far as the kick gets";
  EXPECT_GT(choice->aim().x(), world.field.xGroundline);
}

TEST_F(KickChoiceTest, PlaysTheBallToWhereItsTeamHasLearnedThatItIsWorthMore) {
  ball = {-150, 0};
  world.self.pose = {0, -300, 0};
  EXPECT_LT(std::abs(choose().plan().direction), pi / 2);
  choice.emplace(parameters);
  valueTheOwnHalf();
  EXPECT_GT(std::abs(choose().plan().direction), pi / 2) << "back, says this strange team";
}

TEST_F(KickChoiceTest, KicksOnlyABallThatItSeesWhereAKickReachesIt) {
  unseen = 500;
  EXPECT_EQ(choose().now(), 0);
  unseen = 0;
  ball = {1230, 0};
  EXPECT_EQ(choose().plan().motion, ahead);
  EXPECT_EQ(choose().now(), 0);
}

TEST_F(KickChoiceTest, TakesTheKickThatNeedsTheLeastTurning) {
  ball = {1000, 0};
  world.self.pose = {fromDegrees(-60), ball - rotated({150, 0}, fromDegrees(-60))};
  EXPECT_EQ(choose().plan().motion, left);
  EXPECT_EQ(choose().now(), left);
  choice.emplace(parameters);
  world.self.pose = {pi, 1100, 150};
  EXPECT_EQ(choose().plan().motion, behind);
  EXPECT_EQ(choose().now(), behind);
}

// At a ball beside its post: the kick ahead would roll in if it went only a little astray.
TEST_F(KickChoiceTest, AGoalieTakesNoKickThatMayEndInItsOwnGoal) {
  world.player.role = PlayerRole::goalie;
  world.motions.motions = {{}, kickOf("ahead", {150, 0}, 0, 1.2)};
  ball = {-1950, 330};
  const double past = fromDegrees(-100), away = fromDegrees(60);
  const auto kicksFacing = [&](double facing) {
    choice.emplace(parameters);
    world.self.pose = {facing, ball - rotated({150, 0}, facing)};
    return choose().now() != 0;
  };
  parameters.fieldPlayer.enough = 1;  // any kick will do
  EXPECT_FALSE(kicksFacing(past));
  EXPECT_TRUE(kicksFacing(away));
  world.player.role = PlayerRole::striker1;
  EXPECT_TRUE(kicksFacing(past));
}

TEST_F(KickChoiceTest, AGoalieStandsInItsGoalToClearABallBesideIt) {
  world.player.role = PlayerRole::goalie;
  ball = {-2050, 160};
  world.self.pose = {0, -2140, 0};
  EXPECT_LT(std::abs(choose().plan().facing), fromDegrees(90));
}

TEST_F(KickChoiceTest, AFieldPlayerDoesNotPlanToStandInItsOwnPenaltyArea) {
  ball = {-1500, 0};
  world.self.pose = {0, -1300, 300};
  const auto standsInArea = [&] {
    choice.emplace(parameters);
    const Vector2d body = ball - direction(choose().plan().facing) * parameters.bodyLength;
    return body.x() < -world.field.xPenaltyArea && std::abs(body.y()) < world.field.yPenaltyArea;
  };
  EXPECT_FALSE(standsInArea());
  world.self.pose = {0, -1650, 0};
  EXPECT_FALSE(standsInArea());
  world.player.role = PlayerRole::goalie;
  EXPECT_TRUE(standsInArea());
}

// It remembers what a kick does from its best place.
TEST_F(KickChoiceTest, NoticesThatKicksHaveChanged) {
  EXPECT_EQ(choose().plan().motion, ahead);
  auto& motions = world.motions.motions;
  std::swap(motions[ahead].kick, motions[left].kick);
  EXPECT_EQ(choose().plan().motion, left);
}

// Report 3.8.2: the kick depends on the obstacle model and on the free part of the goal.
TEST_F(KickChoiceTest, ShootsAtTheFreePartOfTheGoal) {
  for (const double y : {0., 60., 120., 180.})
    world.obstacles.enter(relative(world.self.pose, {1900, y}), true, world.frame.time);
  EXPECT_LT(crossing(), -70);
  EXPECT_GT(crossing(), -300);
}

TEST_F(KickChoiceTest, PlaysTheBallPastAnOpponent) {
  world.self.pose = {0, -1000, 0};
  ball = {-850, 0};
  const double free = std::abs(choose().plan().direction);
  for (const double y : {-80., -40., 0., 40., 80.})
    world.obstacles.enter({550, y}, true, world.frame.time);
  world.players.opponents = {{{-450, 0}, world.frame.time, 1, 0}};
  choice.emplace(parameters);
  EXPECT_GT(std::abs(choose().plan().direction), free + fromDegrees(5));
  EXPECT_LT(std::abs(choose().plan().direction), fromDegrees(100));
}

TEST_F(KickChoiceTest, PlaysToWhereATeammateIsNearer) {
  world.self.pose = {0, -1000, 0};
  ball = {-850, 0};
  const double side = 900;
  for (const double sign : {1., -1.}) {
    choice.emplace(parameters);
    world.players.ownTeam = {{{1000, sign * side}, world.frame.time, 1, 3}};
    world.players.opponents = {{{1000, -sign * side}, world.frame.time, 1, 0}};
    EXPECT_GT(sign * choose().plan().direction, 0);
  }
}

TEST_F(KickChoiceTest, NeverPlaysTheBallAtTheOwnGoal) {
  for (double y = -1250; y <= 1250; y += 125)
    for (double x = -2000; x < 2000; x += 125) {
      ball = {x, y};
      world.self.pose = {pi, x + 150, y};  // it faces the own goal
      choice.emplace(parameters);
      choose();
      if (x < -500 && std::abs(y) < 200) {
        EXPECT_NE(choice->now(), ahead) << x << ' ' << y;
      }
      const Vector2d along = direction(choice->plan().direction);
      if (along.x() >= 0) continue;
      const double crosses = y + along.y() / along.x() * (-2100 - x);
      EXPECT_GT(std::abs(crosses), 300) << x << ' ' << y;
    }
}

TEST_F(KickChoiceTest, FindsRoomBehindABallAtTheWall) {
  for (const Vector2d& place :
       {Vector2d{494, 1269}, Vector2d{-1723, -1200}, Vector2d{1584, -1109}}) {
    ball = place;
    world.self.pose = {0, place.x() / 2, place.y() / 2};
    const Vector2d back = ball - direction(choose().plan().facing) * 205;
    EXPECT_LT(std::abs(back.y()), 1350 - parameters.wallClearance) << place.transpose();
    EXPECT_LT(std::abs(back.x()), 2100 - parameters.wallClearance) << place.transpose();
  }
}

TEST_F(KickChoiceTest, IsInAHurryWhereAnOpponentIsNear) {
  // It faces far past the goal.
  world.self.pose = {fromDegrees(75), ball - rotated({150, 0}, fromDegrees(75))};
  world.motions.motions.resize(2);
  EXPECT_EQ(choose().now(), 0);
  world.players.opponents = {{ball + Vector2d{-250, -200}, world.frame.time, 1, 0}};
  world.motions.motions[1].kick.strike = 0.2;
  parameters.disturbed = 1;
  EXPECT_EQ(choose().now(), ahead);
}

TEST_F(KickChoiceTest, TakesAnObstacleAtTheBallForAnOpponent) {
  world.self.pose = {fromDegrees(75), ball - rotated({150, 0}, fromDegrees(75))};
  world.motions.motions.resize(2);
  world.motions.motions[1].kick.strike = 0.2;
  parameters.disturbed = 1;
  parameters.blocked = 1;
  EXPECT_EQ(choose().now(), 0);
  const Vector2d place = ball + Vector2d{-250, -200};
  world.obstacles.enter(relative(world.self.pose, place), true, world.frame.time);
  world.players.ownTeam = {{place, world.frame.time, 1, 0}};
  EXPECT_EQ(choose().now(), 0) << "it is a teammate";
  world.players.ownTeam.clear();
  EXPECT_EQ(choose().now(), ahead);
}

TEST_F(KickChoiceTest, DoesNotKickABallThatLiesBesideItsGoodPlaces) {
  world.motions.motions.resize(2);
  KickDescription& kick = world.motions.motions[1].kick;
  const KickDescription good = kick;
  const auto kicks = [&] { return choice.emplace(parameters), choose().now() == ahead; };
  EXPECT_TRUE(kicks());
  for (auto& place : kick.places) place[5] = 0.3 * kick.length;
  EXPECT_FALSE(kicks()) << "it hardly moves";
  kick = good;
  for (auto& place : kick.places) place[4] = 40;
  EXPECT_FALSE(kicks()) << "it goes anywhere";
  kick = good;
  kick.seconds = 5;
  EXPECT_FALSE(kicks()) << "it takes too long";
}

TEST_F(KickChoiceTest, GivesAKickUpWhenTheBallIsTakenAway) {
  EXPECT_EQ(choose().now(), ahead);
  ball += Vector2d{25, 0};
  EXPECT_EQ(choose().now(), ahead) << "it is still within reach";
  ball += Vector2d{150, 0};
  unseen = 500;
  EXPECT_EQ(choose().now(), ahead) << "it is not seen";
  unseen = 0;
  EXPECT_EQ(choose().now(), 0);
}

TEST_F(KickChoiceTest, DoesNotGiveAKickUpForNoise) {
  world.motions.motions.resize(2);
  EXPECT_EQ(choose().now(), ahead);
  for (auto& place : world.motions.motions[1].kick.places)
    place[5] = 0.8 * parameters.fieldPlayer.strong * world.motions.motions[1].kick.length;
  EXPECT_EQ(choose().now(), ahead) << "it is about to begin";
  choice.emplace(parameters);
  EXPECT_EQ(choose().now(), 0) << "it would not be begun now";
}

TEST_F(KickChoiceTest, ChoosesAnewUntilTheKickBegins) {
  ball = {1000, 0};
  world.self.pose = {fromDegrees(-60), ball - rotated({150, 0}, fromDegrees(-60))};
  EXPECT_EQ(choose().now(), left);
  world.self.pose = {0, ball - Vector2d{150, 0}};
  EXPECT_EQ(choose().now(), ahead) << "the robot stopped elsewhere";
  world.self.pose = {fromDegrees(60), ball - rotated({150, 0}, fromDegrees(60))};
  world.motions.motions.resize(2);
  EXPECT_EQ(choose().now(), 0) << "from there no kick is good";
}

TEST_F(KickChoiceTest, LosesItsPatienceAGoalieSooner) {
  parameters.fieldPlayer.impatience = 0.03;
  world.motions.motions.resize(2);
  const auto cyclesAs = [this](PlayerRole role) {
    world.player.role = role;
    choice.emplace(parameters);
    world.self.pose = {fromDegrees(25), ball - rotated({150, 0}, fromDegrees(25))};
    int cycles = 0;
    for (; cycles < 2000 && choose().now() == 0; ++cycles) world.frame.time = world.frame.time + 40;
    return cycles;
  };
  const int patient = cyclesAs(PlayerRole::striker1);
  EXPECT_GT(patient, 20);
  EXPECT_LT(patient, 2000);
  EXPECT_LT(cyclesAs(PlayerRole::goalie), patient / 2);
}

TEST_F(KickChoiceTest, DoesNotChangeItsMindForNoise) {
  ball = {0, 0};
  Random random{3};
  int changes = 0, last = 0;
  double direction = 0;
  for (int i = 0; i < 100; ++i) {
    world.self.pose = {0.03 * random.gaussian(), -600 + 15 * random.gaussian(),
                       15 * random.gaussian()};
    const KickChoice::Plan& plan = choose().plan();
    changes += i > 0 && (plan.motion != last ||
                         std::abs(normalize(plan.direction - direction)) > fromDegrees(20));
    last = plan.motion;
    direction = plan.direction;
  }
  EXPECT_LT(changes, 3);
}

// A goal that looks wider than 1 rad counts like one of 1 rad, wherever that is set.
TEST_F(KickChoiceTest, CountsAWideGoalAsOneOfTheWidth) {
  for (const double widest : {0.3, 1., 2., 3.2}) {
    parameters.widestGoal = widest;
    parameters.ahead = parameters.possession = parameters.fieldPlayer.second = 0;
    parameters.shot = 0.1;
    for (const double x : {500., 1500., 1900.})
      for (const double y : {0., 400., 900.}) {
        ball = {x, y};
        // A kick that never hits leaves the ball where it is.
        world.motions.motions.resize(2);
        for (auto& place : world.motions.motions[ahead].kick.places) place[2] = 0;
        choice.emplace(parameters);
        const auto seen = [&](double line) {
          const Vector2d left = Vector2d{line, 300} - ball, right = Vector2d{line, -300} - ball;
          return std::min(widest, std::acos(left.normalized().dot(right.normalized())));
        };
        EXPECT_NEAR(choose().plan().worth, 0.1 * (seen(2100) - seen(-2100)) - parameters.blocked,
                    2e-6)
            << widest << ' ' << x << ' ' << y;
      }
  }
}

TEST_F(KickChoiceTest, KeepsAPlanTheLongerTheFartherTheBallIs) {
  parameters.lasts = 0.1;
  const auto lasts = [this](double distance) {
    choice.emplace(parameters);
    world.values = {};
    world.self.pose = {0, -2000, 0};
    ball = {-2000 + distance, 0};
    const double before = choose().plan().worth;
    valueTheOwnHalf();
    const Time start = world.frame.time;
    while (choose().plan().worth == before && world.frame.time - start < 5000)
      world.frame.time = world.frame.time + 40;
    return world.frame.time - start;
  };
  EXPECT_EQ(lasts(340), 0);
  const double perMs = parameters.walkSpeed / 1000;
  for (const double distance : {800., 1600., 3200.})
    EXPECT_NEAR(static_cast<double>(lasts(distance)), 0.1 * (distance - 350) / perMs, 40)
        << distance;
}

TEST_F(KickChoiceTest, PlansAnewWhenTheBallHasMovedFar) {
  parameters.lasts = 0.1;
  choice.emplace(parameters);
  world.self.pose = {0, -2000, 0};
  ball = {0, 0};
  const double before = choose().plan().worth;
  valueTheOwnHalf();
  ball = {150, 0};
  EXPECT_EQ(choose().plan().worth, before) << "a tenth of its distance is not far";
  ball = {250, 0};
  EXPECT_NE(choose().plan().worth, before);
}

TEST_F(KickChoiceTest, PlansAnewWhenItBeginsToPlayAgain) {
  const auto plans = [this](bool plays) {
    const WorldState state = world.state();
    choice->update(state, world.obstacles, relative(world.self.pose, ball), unseen, plays);
    return std::abs(choice->plan().direction) < pi / 2 ? "ahead" : "back";
  };
  parameters.lasts = 0.1;
  choice.emplace(parameters);
  world.self.pose = {0, -2000, 0};
  ball = {0, 0};
  EXPECT_STREQ(plans(true), "ahead");
  valueTheOwnHalf();
  EXPECT_GT((choice->aim() - ball).norm(), 2000);
  EXPECT_STREQ(plans(false), "ahead");
  EXPECT_EQ(choice->aim(), ball) << "teammates are told of no plan that it does not follow";
  EXPECT_STREQ(plans(true), "back");
}

TEST_F(KickChoiceTest, AKickThatHasBegunGoesOn) {
  ASSERT_EQ(choose().now(), ahead);
  world.motion.executed.type = MotionType::specialAction;
  world.motion.executed.specialAction = "ahead";
  ball = {2000, 0};
  EXPECT_EQ(choose().now(), ahead);
  world.motion.executed = {};
  EXPECT_EQ(choose().now(), 0);
}

}  // namespace
}  // namespace gt
