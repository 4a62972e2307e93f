#include "simulation/rules/Referee.h"

#include <gtest/gtest.h>

#include "support/TestReferee.h"

namespace gt {
namespace {

class RefereeMatch : public UnplayedMatch {
 protected:
  void SetUp() override {
    scene_.game.minutes = 1;
    start();
  }
  /// Waits until a state is reached; false if it takes longer than a time.
  bool until(GameState state, double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / tickSeconds); ++i) {
      if (referee_->state() == state) return true;
      tick();
    }
    return referee_->state() == state;
  }
};

TEST_F(RefereeMatch, WhoCheersIsNotYetAtItsPlace) {
  ASSERT_TRUE(until(GameState::ready, 2));
  for (int i = 0; i < 8000 / tickMs; ++i) {
    commands_[2].joints[Joint::legFR1] = i * tickMs / 500 % 2 ? 0.5 : 0;
    tick();
  }
  EXPECT_EQ(referee_->state(), GameState::ready);
  EXPECT_TRUE(until(GameState::set, 3));
}

TEST_F(RefereeMatch, InitialReadySetPlaying) {
  EXPECT_EQ(referee_->dataFor(0).state, GameState::initial);
  ASSERT_TRUE(until(GameState::ready, 2));
  EXPECT_EQ(referee_->dataFor(0).state, GameState::ready);
  EXPECT_EQ(referee_->dataFor(0).kickOff, KickOff::own);
  EXPECT_EQ(referee_->dataFor(4).kickOff, KickOff::opponent);
  const Time ready = world_->time();
  ASSERT_TRUE(until(GameState::set, 21));
  EXPECT_LT(world_->time() - ready, 6000);  // all stand already
  const Time set = world_->time();
  EXPECT_EQ(referee_->dataFor(3).timeOfLastChange, set);
  ASSERT_TRUE(until(GameState::playing, 10));
  EXPECT_NEAR(static_cast<double>(world_->time() - set), 3000, 10);
  EXPECT_EQ(count(GameEventType::kickOff), 1);
  EXPECT_EQ(world_->ball(0).position, Vector2d(0, 0));
}

/// Report J.2.6: in the ready state all penalties are reset.
TEST_F(RefereeMatch, ReadyLiftsAllPenalties) {
  referee_->order(GameState::playing, *world_);
  referee_->penalize(*world_, 1, Penalty::ballHolding);
  referee_->setPenalty(6, Penalty::obstruction, world_->time());
  tick();
  EXPECT_EQ(referee_->dataFor(1).state, GameState::penalized);
  EXPECT_EQ(referee_->dataFor(6).state, GameState::penalized);
  referee_->order(GameState::ready, *world_);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(referee_->dataFor(i).state, GameState::ready) << i;
    EXPECT_EQ(referee_->dataFor(i).penalty, Penalty::none) << i;
  }
  EXPECT_LT(std::abs(world_->robot(1).pose.translation.y()), 1350) << "it is back on the field";
}

TEST_F(RefereeMatch, BadlyPlacedRobotsArePutByHand) {
  ASSERT_TRUE(until(GameState::ready, 2));
  world_->placeRobot(1, {0, 900, 300});     // red in the other half
  world_->placeRobot(7, {pi, 200, 0});      // blue in the circle, though red kicks off
  world_->placeRobot(4, {pi, 1000, -900});  // the blue goalie far out
  world_->placeRobot(2, {0, -1900, 100});   // a red striker in the own penalty area
  ASSERT_TRUE(until(GameState::set, 21));
  EXPECT_EQ(count(GameEventType::placedRobot), 4);
  EXPECT_LT(world_->robot(1).pose.translation.x(), -100);
  EXPECT_GT(world_->robot(7).pose.translation.norm(), 290);
  EXPECT_GT(world_->robot(7).pose.translation.x(), 100);
  EXPECT_GT(world_->robot(4).pose.translation.x(), 1600);
  EXPECT_GT(world_->robot(2).pose.translation.x(), -1600);
  EXPECT_EQ(world_->robot(3).pose.translation, Vector2d(-300, -300));  // well placed: untouched
  tick();
  for (std::size_t a = 0; a < 8; ++a)
    for (std::size_t b = a + 1; b < 8; ++b)
      EXPECT_GT((world_->robot(a).pose.translation - world_->robot(b).pose.translation).norm(),
                150);
}

TEST_F(RefereeMatch, TheKickerStandsClearOfTheBallThatIsPutForTheKickOff) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic}) {
    scene_ = matchScene();
    scene_.fidelity = fidelity;
    scene_.robots.erase(scene_.robots.begin() + 4, scene_.robots.end());
    scene_.robots.erase(scene_.robots.begin(), scene_.robots.begin() + 3);
    start();
    commands_ = {{firmStand(), {}}};
    ASSERT_TRUE(until(GameState::ready, 2));
    for (int i = 0; i < 100; ++i) tick();
    world_->placeBall(0, {-1000, 500});
    world_->placeRobot(0, {0, -80, -60});  // a foreleg stands where the ball is put
    ASSERT_TRUE(until(GameState::set, 21));
    EXPECT_EQ(count(GameEventType::placedRobot), 1);
    EXPECT_EQ(world_->ball(0).position, Vector2d(0, 0));
    for (int i = 0; i < 10; ++i) {
      tick();
      EXPECT_LT(world_->ball(0).position.norm(), 1);
      EXPECT_LT(world_->ball(0).speed.norm(), 20);
    }
  }
}

TEST_F(RefereeMatch, ABallIsDroppedBesideWhoeverStandsWhereItBelongs) {
  for (const Fidelity fidelity : {Fidelity::kinematic, Fidelity::dynamic})
    for (const double x : {-80., 0., 90.}) {
      scene_ = duelScene({0.3, -800, 0}, {500, 500});
      scene_.fidelity = fidelity;
      start();
      commands_ = {{firmStand(), {}}};
      for (int i = 0; i < 100; ++i) world_->step(commands_);
      referee_->order(GameState::playing, *world_);
      world_->placeRobot(0, {0.3, x, -50});
      world_->placeBall(0, {300, 1500});
      tick();
      ASSERT_EQ(count(GameEventType::ballOut), 1);
      EXPECT_LT(world_->ball(0).position.norm(), 250) << x;
      tick();
      EXPECT_LT(world_->ball(0).speed.norm(), 20) << x;
      EXPECT_EQ(world_->ball(0).lastToucher, -1) << x;
    }
}

TEST_F(RefereeMatch, GoalsCountForWhoScoresAndTheOtherTeamKicksOff) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeRobot(4, {pi, 1500, 900});  // the blue goalie is away
  tick();
  world_->placeBall(0, {2050, 0}, {600, 0});
  ASSERT_TRUE(until(GameState::ready, 1));
  EXPECT_EQ(referee_->score(TeamColor::red), 1);
  EXPECT_EQ(referee_->score(TeamColor::blue), 0);
  EXPECT_EQ(referee_->dataFor(0).ownScore, 1);
  EXPECT_EQ(referee_->dataFor(5).opponentScore, 1);
  EXPECT_EQ(referee_->dataFor(5).kickOff, KickOff::own);
  const GameEvent& goal = referee_->events().back();
  EXPECT_EQ(goal.type, GameEventType::goal);
  EXPECT_EQ(goal.team, TeamColor::red);
  EXPECT_EQ(goal.number, 0);
  EXPECT_GT(goal.ballPosition.x(), 2143);
}

TEST_F(RefereeMatch, ABallOnTheLineIsNoGoal) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeRobot(4, {pi, 1500, 900});
  world_->placeBall(0, {2140, 0});
  for (int i = 0; i < 100; ++i) tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 0);
  world_->placeBall(0, {2146, 0});
  tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 1);
}

TEST_F(RefereeMatch, OwnGoalsAreTold) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeRobot(0, {-pi, -1700, 0});  // the red goalie walks to its own goal
  world_->placeBall(0, {-1900, 0});
  commands_[0] = standingCommand({0, 2.5, 0});
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    commands_[0].joints[legJoint(leg, 2)] = fromDegrees(50);  // low, so that the chest pushes
  ASSERT_TRUE(until(GameState::ready, 5));
  const GameEvent& goal = referee_->events().back();
  EXPECT_EQ(goal.team, TeamColor::blue);
  EXPECT_TRUE(goal.ownGoal);
  EXPECT_EQ(goal.number, 1);
  EXPECT_EQ(goal.scoreBlue, 1);
}

TEST_F(RefereeMatch, ADeflectedShotIsNoOwnGoal) {
  ASSERT_TRUE(until(GameState::playing, 30));
  const std::size_t shooter = 4;  // the blue goalie pushes the ball at the red goal
  world_->placeRobot(0, {0, 0, 1000});
  world_->placeRobot(shooter, {-pi, -1650, 0});
  world_->placeBall(0, {-1850, 0});
  commands_[shooter] = standingCommand({0, 2.5, 0});
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    commands_[shooter].joints[legJoint(leg, 2)] = fromDegrees(50);
  for (int i = 0; i < 500 && world_->ball(0).position.x() > -2050; ++i) tick();
  ASSERT_EQ(world_->ball(0).lastToucher, 4);
  // The red goalie comes from the side until it has touched the ball, too.
  for (double y = 150; y > 60 && world_->ball(0).lastToucher != 0; y -= 2) {
    world_->placeRobot(0, {0, world_->ball(0).position + Vector2d{0, y}});
    tick();
  }
  ASSERT_EQ(world_->ball(0).lastToucher, 0);
  world_->placeRobot(0, {0, 0, 1000});
  world_->placeBall(0, {-2140, 0}, {-200, 0}, false);
  ASSERT_TRUE(until(GameState::ready, 2));
  const GameEvent& goal = referee_->events().back();
  EXPECT_FALSE(goal.ownGoal);
  EXPECT_EQ(goal.team, TeamColor::blue);
  EXPECT_EQ(goal.number, 1);
}

TEST_F(RefereeMatch, HalvesAndEnd) {
  ASSERT_TRUE(until(GameState::playing, 30));
  EXPECT_EQ(referee_->half(), 1);
  const Time first = world_->time();
  ASSERT_TRUE(until(GameState::initial, 31));
  EXPECT_NEAR(static_cast<double>(world_->time() - first), 30'000, 10);
  EXPECT_EQ(count(GameEventType::halfTime), 1);
  ASSERT_TRUE(until(GameState::playing, 30));
  EXPECT_EQ(referee_->half(), 2);
  EXPECT_EQ(referee_->events().back().team, TeamColor::blue);
  ASSERT_TRUE(until(GameState::finished, 31));
  EXPECT_TRUE(referee_->over(world_->time()));
  GameParameters leaving = referee_->parameters();
  leaving.leaveTime = 2;
  referee_->change(leaving);
  EXPECT_FALSE(referee_->over(world_->time()));
  EXPECT_TRUE(referee_->over(world_->time() + 2000));
  EXPECT_EQ(referee_->events().back().type, GameEventType::gameOver);
  EXPECT_EQ(referee_->dataFor(6).state, GameState::finished);
  const std::size_t events = referee_->events().size();
  for (int i = 0; i < 100; ++i) tick();
  EXPECT_EQ(referee_->events().size(), events);
}

TEST_F(RefereeMatch, AStuckBallIsPutElsewhere) {
  ASSERT_TRUE(until(GameState::playing, 30));
  world_->placeBall(0, {1900, -1000});
  for (int i = 0; i < 2400; ++i) tick();
  EXPECT_EQ(count(GameEventType::stuckBall), 0);
  for (int i = 0; i < 200; ++i) tick();
  EXPECT_EQ(count(GameEventType::stuckBall), 1);
  EXPECT_EQ(world_->ball(0).position, Vector2d(1050, -675));
}

TEST_F(RefereeMatch, PenaltiesReachTheirRobotOnly) {
  ASSERT_TRUE(until(GameState::playing, 30));
  referee_->setPenalty(2, Penalty::obstruction, world_->time());
  EXPECT_EQ(referee_->dataFor(2).state, GameState::penalized);
  EXPECT_EQ(referee_->dataFor(2).penalty, Penalty::obstruction);
  EXPECT_EQ(referee_->dataFor(3).state, GameState::playing);
  referee_->setPenalty(2, Penalty::none, world_->time());
  EXPECT_EQ(referee_->dataFor(2).state, GameState::playing);
}

TEST_F(RefereeMatch, WithoutARefereeAllPlay) {
  scene_.game.referee = false;
  start();
  tick();
  EXPECT_EQ(referee_->dataFor(0).state, GameState::playing);
  world_->placeBall(0, {2300, 0});
  tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 0);
}

/// A match in play with nobody on the field but those that a test places.
class PenaltyMatch : public RefereeMatch {
 protected:
  void SetUp() override {
    RefereeMatch::SetUp();
    scene_.game.minutes = 4;
    scene_.game.penalties = true;
    scene_.game.stuckTime = 600;
    start();
    ASSERT_TRUE(until(GameState::playing, 30));
    for (std::size_t i = 0; i < 8; ++i)
      world_->placeRobot(i, {0, i < 4 ? -1000. : 1000., 600 - 400. * static_cast<double>(i % 4)});
    world_->placeBall(0, {0, -1200});
    tick();
  }
  /// Plays on, with the step of one robot; the seconds until a robot is penalized, 99 if never.
  double secondsUntil(std::size_t robot, Penalty penalty, double most = 20) {
    const Time begin = world_->time();
    while (world_->time() - begin < 1000 * most) {
      tick();
      if (referee_->penalty(robot) == penalty)
        return static_cast<double>(world_->time() - begin) / 1000;
    }
    return 99;
  }
  void walk(std::size_t robot, double speed) {
    commands_[robot] = standingCommand({0, speed * tickSeconds, 0});
  }
};

TEST_F(PenaltyMatch, FieldPlayersMustNotPush) {
  world_->placeRobot(3, {0, -300, 300});
  world_->placeRobot(7, {0, 0, 300});
  world_->placeBall(0, {400, 300});  // blue plays it
  walk(3, 150);
  EXPECT_NEAR(secondsUntil(3, Penalty::fieldPlayerCharge), 3.5, 1);
  EXPECT_EQ(referee_->dataFor(3).state, GameState::penalized);
  EXPECT_EQ(referee_->dataFor(3).penalty, Penalty::fieldPlayerCharge);
  EXPECT_EQ(referee_->penalty(7), Penalty::none);
  const GameEvent& event = referee_->events().back();
  EXPECT_EQ(event.type, GameEventType::penalty);
  EXPECT_EQ(event.penalty, Penalty::fieldPlayerCharge);
  EXPECT_EQ(event.number, 4);
  // Beside the field, for half a minute; then at the halfway line, on the side away from the ball.
  EXPECT_LT(world_->robot(3).pose.translation.y(), -1450);
  const Time begin = world_->time();
  walk(3, 0);
  EXPECT_NEAR(secondsUntil(3, Penalty::none, 40), 30, 0.1);
  EXPECT_GT(world_->time(), begin);
  EXPECT_NEAR(world_->robot(3).pose.translation.x(), -100, 5);
  EXPECT_NEAR(world_->robot(3).pose.translation.y(), -1150, 5);
  EXPECT_EQ(referee_->dataFor(3).state, GameState::playing);
  EXPECT_EQ(referee_->events().back().type, GameEventType::returnedRobot);
}

TEST_F(PenaltyMatch, KeepersAreSafeInTheirArea) {
  world_->placeRobot(4, {pi, 1900, 0});
  world_->placeRobot(2, {0, 1650, 0});
  walk(2, 150);
  EXPECT_NEAR(secondsUntil(2, Penalty::keeperCharge), 3.5, 1);
}

TEST_F(PenaltyMatch, StandingInTheWayFarFromTheBallIsObstruction) {
  world_->placeRobot(3, {0, -1500, 0});
  world_->placeRobot(7, {0, -1200, 0});
  world_->placeBall(0, {0, 0});
  walk(3, 150);
  EXPECT_LT(secondsUntil(7, Penalty::obstruction), 5);
  EXPECT_EQ(referee_->penalty(3), Penalty::none);
  tick();
  EXPECT_EQ(referee_->penalty(7), Penalty::none);  // since 2003 back at once
  EXPECT_GT(std::abs(world_->robot(7).pose.translation.y()), 1000);
}

TEST_F(PenaltyMatch, OnlyTheKeeperDefendsInItsArea) {
  world_->placeRobot(0, {0, -2000, 0});
  world_->placeRobot(1, {0, -1800, 300});
  EXPECT_NEAR(secondsUntil(1, Penalty::illegalDefender), 3, 0.1);
  EXPECT_EQ(referee_->penalty(0), Penalty::none);
}

TEST_F(PenaltyMatch, TheOtherTeamsKickOffNeedsAnEmptyCircle) {
  world_->placeBall(0, {0, 0});
  referee_->order(GameState::set, *world_);
  ASSERT_TRUE(until(GameState::playing, 10));
  world_->placeRobot(6, {pi, 100, 0});
  EXPECT_NEAR(secondsUntil(6, Penalty::illegalDefense), 3, 0.1);
}

TEST_F(PenaltyMatch, AHeldBallIsLetGo) {
  world_->placeRobot(2, {0, -500, 0});
  tick();
  // The ball goes wherever the robot goes, and rolls against its foreleg again and again.
  const auto carry = [&](double seconds) {
    for (int i = 0; i < seconds / tickSeconds; ++i) {
      const RobotBody& robot = world_->robot(2);
      world_->placeBall(0, robot.pose * Vector2d{100, -55}, -2000 * direction(robot.pose.rotation),
                        false);
      tick();
      if (referee_->penalty(2) != Penalty::none) return true;
    }
    return false;
  };
  walk(2, 60);
  EXPECT_FALSE(carry(2.5));
  EXPECT_TRUE(carry(1.5));
  EXPECT_EQ(referee_->penalty(2), Penalty::ballHolding);
}

TEST_F(PenaltyMatch, WhoLiesIsPickedUp) {
  world_->throwOver(5, Posture::onLeftSide);
  EXPECT_NEAR(secondsUntil(5, Penalty::requestForPickup), 15, 0.1);
  EXPECT_EQ(world_->robot(5).posture, Posture::standing);
}

TEST_F(PenaltyMatch, EveryRuleCanBeSwitchedOff) {
  RuleParameters rules;
  rules.illegalDefender = 0;
  referee_->change(rules);
  world_->placeRobot(1, {0, -1800, 300});
  EXPECT_EQ(secondsUntil(1, Penalty::illegalDefender, 6), 99);
  rules.illegalDefender = 1;
  referee_->change(rules);
  EXPECT_LT(secondsUntil(1, Penalty::illegalDefender, 6), 1.1);
  GameParameters game = referee_->parameters();
  game.penalties = false;
  referee_->change(game);
  world_->placeRobot(2, {0, -1800, -300});
  EXPECT_EQ(secondsUntil(2, Penalty::illegalDefender, 6), 99);
}

TEST_F(PenaltyMatch, AllComeBackForAKickOff) {
  referee_->penalize(*world_, 2, Penalty::ballHolding);
  referee_->penalize(*world_, 6, Penalty::requestForPickup);
  tick();
  EXPECT_LT(world_->robot(2).pose.translation.y(), -1450);
  EXPECT_GT(world_->robot(6).pose.translation.y(), 1450);
  world_->placeBall(0, {2200, 0});
  ASSERT_TRUE(until(GameState::ready, 1));
  for (const std::size_t i : {2, 6}) {
    EXPECT_EQ(referee_->penalty(i), Penalty::none);
    EXPECT_LT(std::abs(world_->robot(i).pose.translation.y()), 1300);
  }
}

TEST_F(RefereeMatch, ADrawIsDecidedByPenaltyShots) {
  scene_.game.minutes = 0.2;
  scene_.game.shootOut = ShootOutMode::afterDraw;
  scene_.rules.shots = 2;
  scene_.rules.shotTime = 2;
  start();
  const auto shoots = [&] {
    return referee_->shootOut() && referee_->state() == GameState::playing;
  };
  for (int i = 0; i < 10'000 && !shoots(); ++i) tick();
  ASSERT_TRUE(shoots());
  // Red 4 against blue 1; the others watch from beside the field.
  EXPECT_EQ(referee_->dataFor(3).state, GameState::playing);
  EXPECT_EQ(referee_->dataFor(3).kickOff, KickOff::own);
  EXPECT_EQ(referee_->dataFor(4).state, GameState::playing);
  EXPECT_EQ(referee_->dataFor(0).state, GameState::finished);
  EXPECT_GT(std::abs(world_->robot(0).pose.translation.y()), 1450);
  EXPECT_NEAR(world_->robot(3).pose.translation.x(), -230, 5);
  EXPECT_NEAR(world_->robot(4).pose.translation.x(), 2000, 5);
  world_->placeBall(0, {2160, 0});  // 1:0
  tick();
  EXPECT_EQ(referee_->shootOut()->goals(TeamColor::red), 1);
  EXPECT_EQ(referee_->shootOut()->team(), TeamColor::blue);
  for (int i = 0; i < 1000 && !shoots(); ++i) tick();
  EXPECT_NEAR(world_->robot(7).pose.translation.x(), 230, 5);
  EXPECT_NEAR(static_cast<double>(referee_->timeLeft(world_->time())), 2000, 10);
  for (int i = 0; i < 260; ++i) tick();  // its time is over: still 1:0
  EXPECT_EQ(count(GameEventType::shotMissed), 1);
  for (int i = 0; i < 1000 && !shoots(); ++i) tick();
  world_->placeBall(0, {2160, 0});  // 2:0, which one shot cannot catch up with
  tick();
  EXPECT_EQ(referee_->state(), GameState::finished);
  EXPECT_EQ(count(GameEventType::shotGoal), 2);
  EXPECT_EQ(referee_->events()[referee_->events().size() - 2].scoreRed, 2);
  EXPECT_EQ(describe(referee_->events().back()), "The game is over, 2:0");
  EXPECT_EQ(referee_->score(TeamColor::red), 0);
}

TEST(ShootOut, GoesOnPairByPairUntilItIsDecided) {
  ShootOut even{3, TeamColor::blue};
  for (int i = 0; i < 6; ++i) {
    EXPECT_FALSE(even.over()) << i;
    EXPECT_EQ(even.team(), i % 2 == 0 ? TeamColor::blue : TeamColor::red);
    even.count(true);
  }
  EXPECT_FALSE(even.over());
  even.count(true);
  EXPECT_FALSE(even.over());  // red may still catch up
  even.count(false);
  EXPECT_TRUE(even.over());
  EXPECT_EQ(even.goals(TeamColor::blue), 4);
  ShootOut nobodyScores{3, TeamColor::red};
  int shots = 0;
  for (; !nobodyScores.over(); ++shots) nobodyScores.count(false);
  EXPECT_EQ(shots, 24);
  ShootOut early{5, TeamColor::red};
  for (const bool goal : {true, false, true, false, true}) early.count(goal);
  EXPECT_FALSE(early.over());  // 3:0, blue has three shots left
  early.count(false);
  EXPECT_TRUE(early.over());  // it misses one
}

}  // namespace
}  // namespace gt
