#include "modules/behavior/control/SymbolSources.h"

#include <gtest/gtest.h>

#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {
namespace {

class SymbolSources : public ::testing::Test {
 protected:
  SymbolSources() {
    const KickDescription kick{.motion = "someKick",
                               .x = 150,
                               .y = 20,
                               .direction = 80,
                               .step = 60,
                               .places = {{150, 20, 1, 80, 30, 700, 100}}};
    world.motions.motions = {{}, {"stand", {}}, {"someKick", kick}};
    world.frame.time = world.ball.lastSeen = {1000};
  }
  const SoccerInputs& inputs() {
    state.emplace(world.state());
    tactics.update(*state);
    return inputs_;
  }

  ImaginedWorld world;
  std::optional<WorldState> state;
  Tactics::Parameters parameters;
  Tactics tactics{parameters};
  SoccerInputs inputs_{tactics};
};

TEST_F(SymbolSources, TellTheSpecialActionByItsIndex) {
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{0});
  world.motion.executed.type = MotionType::specialAction;
  world.motion.executed.specialAction = "someKick";
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{2});
  world.motion.executed.specialAction = "stand";
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{1});
  world.motion.executed.specialAction = "moonwalk";
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{0});
  world.motion.executed.type = MotionType::walk;
  EXPECT_EQ(inputs().motionSpecialAction(), SpecialAction{0});
}

TEST_F(SymbolSources, TellWhereAKickPlaysTheBall) {
  constexpr SpecialAction someKick{2};
  EXPECT_EQ(inputs().kickX(someKick), 150);
  EXPECT_EQ(inputs().kickY(someKick), 20);
  world.ball.position = {115, 20};
  EXPECT_FALSE(inputs().kickReaches(someKick, 30, 0));
  EXPECT_TRUE(inputs().kickReaches(someKick, 30, 6));
  EXPECT_FALSE(inputs().kickReaches(someKick, 29, 6)) << "it goes farther astray";
  EXPECT_FALSE(inputs().kickReaches(SpecialAction{1}, 180, 1000)) << "is no kick";
}

TEST_F(SymbolSources, TellWhichKickIsPlanned) {
  KickDescription& kick = world.motions.motions[2].kick;
  kick.direction = 0;
  kick.length = 3000;
  kick.places = {{150, 20, 1, 0, 5, 3000, 100}};
  world.ball.position = {1000, 0};
  EXPECT_EQ(inputs().kickPlanned(), SpecialAction{2});
  EXPECT_NEAR(inputs().kickFacing(), 0, 10);
  EXPECT_EQ(inputs().kickNow(), SpecialAction{0});
}

TEST_F(SymbolSources, GiveAnglesInDegreesFromWhereTheRobotLooks) {
  world.self.pose = {pi / 2, 0, 0};
  world.ball.position = {0, -500};  // at (500, 0) on the field, on the way to the goal
  EXPECT_NEAR(inputs().ballSeenAngle(), -90, 1e-9);
  EXPECT_NEAR(inputs().ballKnownX(), 500, 1e-9);
  EXPECT_NEAR(inputs().ballAngleAround(0), 0, 1e-9);
  EXPECT_NEAR(inputs().ballAngleAround(-90), 90, 1e-9);
}

TEST_F(SymbolSources, SetEachLedTheTailAndTheSound) {
  SoccerOutputs outputs;
  using Set = void (SoccerOutputs::*)(LedMode);
  const std::pair<Led, Set> all[] = {{Led::lowerLeft, &SoccerOutputs::setLedLowerLeft},
                                     {Led::middleLeft, &SoccerOutputs::setLedMiddleLeft},
                                     {Led::upperLeft, &SoccerOutputs::setLedUpperLeft},
                                     {Led::lowerRight, &SoccerOutputs::setLedLowerRight},
                                     {Led::middleRight, &SoccerOutputs::setLedMiddleRight},
                                     {Led::upperRight, &SoccerOutputs::setLedUpperRight},
                                     {Led::top, &SoccerOutputs::setLedTop},
                                     {Led::tailBlue, &SoccerOutputs::setLedTailBlue},
                                     {Led::tailRed, &SoccerOutputs::setLedTailRed}};
  ASSERT_EQ(std::size(all), enumCount<Led>);
  for (const auto& [led, set] : all) {
    outputs = {};
    (outputs.*set)(LedMode::fastBlink);
    for (std::size_t i = 0; i < enumCount<Led>; ++i)
      EXPECT_EQ(outputs.leds.modes.values[i] == LedMode::fastBlink, static_cast<Led>(i) == led);
  }
  outputs.setTail(TailRequest::wagVertical);
  EXPECT_EQ(outputs.tail, TailRequest::wagVertical);
  outputs.setSound(Sound::bing);
  EXPECT_EQ(outputs.sound.sound, Sound::bing);
}

}  // namespace
}  // namespace gt
