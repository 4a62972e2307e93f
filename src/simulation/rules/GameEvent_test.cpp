#include "simulation/rules/GameEvent.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(GameEvent, IsDescribedInOneLine) {
  GameEvent event;
  event.type = GameEventType::goal;
  event.team = TeamColor::red;
  event.number = 3;
  event.scoreRed = 2;
  EXPECT_EQ(describe(event), "Goal for red by player 3: 2:0");
  event.number = 0;
  EXPECT_EQ(describe(event), "Goal for red: 2:0") << "nobody touched the ball";
  event.number = 3;
  event.ownGoal = true;
  EXPECT_EQ(describe(event), "Goal for red, an own goal by blue 3: 2:0");
  event.type = GameEventType::penalty;
  event.penalty = Penalty::keeperCharge;
  EXPECT_EQ(describe(event), "The referee takes red 3 off the field: keeper charge");
  for (std::size_t i = 0; i < enumCount<GameEventType>; ++i) {
    event.type = static_cast<GameEventType>(i);
    EXPECT_FALSE(describe(event).empty()) << enumNames<GameEventType>[i];
  }
}

TEST(GameEvent, ClocksShowMinutesAndSeconds) {
  EXPECT_EQ(clockText(Time{0}), "0:00");
  EXPECT_EQ(clockText(Time{125'999}), "2:05");
  EXPECT_EQ(clockText(Time{600'000}), "10:00");
}

}  // namespace
}  // namespace gt
