#include "modules/behavior/tactics/ButtonControl.h"

#include <gtest/gtest.h>

#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {
namespace {

class ButtonControlTest : public ::testing::Test {
 protected:
  GameState cycle() {
    control.update(world.state());
    return control.state();
  }
  /// Presses the back switch and releases it; returns the state before the release.
  GameState press(int ms) {
    for (int pressed = 0; pressed <= ms; pressed += 40) {
      world.body.pressedFor[Switch::back] = pressed;
      cycle();
    }
    const GameState held = control.state();
    world.body.pressedFor[Switch::back] = 0;
    cycle();
    return held;
  }

  ButtonControl::Parameters parameters;
  ButtonControl control{parameters};
  ImaginedWorld world;
};

TEST_F(ButtonControlTest, TheBackSwitchBeginsWhatIsNext) {
  EXPECT_EQ(cycle(), GameState::initial);
  EXPECT_EQ(press(400), GameState::initial) << "only when it is released";
  EXPECT_EQ(control.state(), GameState::ready);
  press(120);
  EXPECT_EQ(control.state(), GameState::playing);
  press(120);
  EXPECT_EQ(control.state(), GameState::playing);
}

TEST_F(ButtonControlTest, ALongPressStopsTheGame) {
  press(120);
  press(120);
  EXPECT_EQ(press(1000), GameState::playing);
  EXPECT_EQ(press(1040), GameState::ready);
  EXPECT_EQ(control.state(), GameState::ready) << "the release starts nothing";
  press(120);
  EXPECT_EQ(control.state(), GameState::playing);
}

TEST_F(ButtonControlTest, TheTailSaysInReadyWhoKicksOff) {
  world.body.tailPan = fromDegrees(20);
  cycle();
  EXPECT_FALSE(control.ownKickOff()) << "not yet";
  world.body.tailPan = 0;
  press(120);
  EXPECT_FALSE(control.ownKickOff());
  world.body.tailPan = fromDegrees(20);
  cycle();
  world.body.tailPan = 0;
  cycle();
  EXPECT_TRUE(control.ownKickOff());
  world.body.tailPan = fromDegrees(-20);
  cycle();
  EXPECT_FALSE(control.ownKickOff());
}

TEST_F(ButtonControlTest, AGameManagerLeadsFromItsFirstWordOn) {
  press(120);
  press(120);
  EXPECT_EQ(control.state(), GameState::playing);
  world.game.state = GameState::set;
  world.game.kickOff = KickOff::own;
  EXPECT_EQ(cycle(), GameState::set);
  EXPECT_TRUE(control.ownKickOff());
  press(120);
  EXPECT_EQ(control.state(), GameState::set);
  world.game.state = GameState::initial;  // half time
  EXPECT_EQ(cycle(), GameState::initial);
  press(120);
  EXPECT_EQ(control.state(), GameState::initial);
}

}  // namespace
}  // namespace gt
