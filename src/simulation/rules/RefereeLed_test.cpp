#include "support/TestReferee.h"

namespace gt {
namespace {

class LedReferee : public UnplayedMatch {
 protected:
  void SetUp() override { start(); }
  /// The game controller says that a half has this state.
  void say(int half, GameState state) {
    message.firstHalf = half == 1;
    message.state = state;
    referee_->follow(message, *world_);
  }
  bool over() const { return referee_->over(world_->time()); }

  GameControllerMessage message;
};

TEST_F(LedReferee, DoesNothingByItself) {
  message.state = GameState::set;
  message.kickOff = TeamColor::blue;
  message.secondsLeft = 100;
  message.teams[TeamColor::blue].score = 2;
  world_->placeRobot(1, {0, 900, 300});
  world_->placeBall(0, {500, 0});
  referee_->follow(message, *world_);
  EXPECT_TRUE(referee_->led());
  EXPECT_EQ(referee_->dataFor(1).state, GameState::set);
  EXPECT_EQ(referee_->dataFor(1).opponentScore, 2);
  EXPECT_EQ(referee_->dataFor(1).kickOff, KickOff::opponent);
  EXPECT_LT(world_->robot(1).pose.translation.x(), 0);
  EXPECT_EQ(world_->ball(0).position, Vector2d(0, 0));
  for (int i = 0; i < 1000; ++i) tick();
  EXPECT_EQ(referee_->state(), GameState::set);  // it does not go on by itself
  message.state = GameState::playing;
  message.teams[TeamColor::red].penalties[2] = Penalty::obstruction;
  referee_->follow(message, *world_);
  EXPECT_EQ(referee_->dataFor(2).state, GameState::penalized);
  for (int i = 0; i < 1000; ++i) tick();
  EXPECT_EQ(referee_->penalty(2), Penalty::obstruction);
  EXPECT_NEAR(static_cast<double>(referee_->timeLeft(world_->time())), 92'000, 10);
  message.teams[TeamColor::red].penalties[2] = Penalty::none;
  referee_->follow(message, *world_);
  EXPECT_EQ(referee_->dataFor(2).state, GameState::playing);
  world_->placeBall(0, {2200, 0});
  tick();
  EXPECT_EQ(referee_->score(TeamColor::red), 0);
}

TEST_F(LedReferee, GoesOnAfterHalfTime) {
  say(1, GameState::playing);
  say(1, GameState::finished);
  EXPECT_EQ(referee_->dataFor(0).state, GameState::finished);
  for (int i = 0; i < 3000; ++i) tick();
  EXPECT_FALSE(over());
  EXPECT_EQ(count(GameEventType::halfTime), 1);
  say(1, GameState::playing);  // the whistle was a mistake
  EXPECT_EQ(referee_->dataFor(0).state, GameState::playing);
  say(1, GameState::finished);
  say(2, GameState::initial);
  EXPECT_EQ(referee_->half(), 2);
  EXPECT_EQ(count(GameEventType::gameOver), 0);
}

TEST_F(LedReferee, IsOverSomeTimeAfterTheSecondHalf) {
  say(2, GameState::playing);
  const auto lastsFor = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(seconds / tickSeconds); ++i) {
      if (over()) return false;
      tick();
    }
    return true;
  };
  say(2, GameState::finished);
  EXPECT_TRUE(lastsFor(9));
  say(2, GameState::playing);  // the whistle was a mistake
  EXPECT_TRUE(lastsFor(12));
  say(2, GameState::finished);
  EXPECT_TRUE(lastsFor(9));
  EXPECT_FALSE(lastsFor(2));
  EXPECT_EQ(count(GameEventType::gameOver), 2);
}

}  // namespace
}  // namespace gt
