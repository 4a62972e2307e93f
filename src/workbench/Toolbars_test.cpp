#include <QAbstractButton>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>
#include <cmath>

#include "workbench/TestWindow.h"

namespace gt {
namespace {

TEST_F(WindowTest, TheGameIsControlledByTheToolbar) {
  click("game", "ready");
  finish();
  EXPECT_EQ(value("state"), "ready");
  choose("game", "kickOff", "blue");
  widget<QSpinBox>("game", "red")->setFocus();
  widget<QSpinBox>("game", "red")->setValue(3);
  widget<QSpinBox>("game", "blue")->setFocus();
  widget<QSpinBox>("game", "blue")->setValue(1);
  click("game", "set");
  finish();
  EXPECT_EQ(value("state"), "set");
  EXPECT_EQ(value("kickOff"), "blue");
  EXPECT_EQ(value("score.red") + ":" + value("score.blue"), "3:1");
  click("game", "playing");
  choose("game", "player", "red2");
  choose("game", "penalty", "ballHolding");
  click("game", "penalize");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(value("red2.GameControlData.state"), "penalized");
  click("game", "continue");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(value("red2.GameControlData.state"), "playing");
  // The connected robot is the one that it was.
  EXPECT_EQ(on([](Console& console) { return console.selection(); }),
            std::vector<std::string>{"red1"});
  widget<QSlider>("game", "gameSpeed")->setValue(4);
  finish();
  EXPECT_EQ(value("blue2.WalkingEngine.InvKin.gameSpeed"), "0.4");
  click("game", "initial");
  finish();
  EXPECT_EQ(value("state") + value("score.red"), "initial0");
}

TEST_F(WindowTest, TheToolbarOfViewsOpensDialogs) {
  window->open("views");
  EXPECT_FALSE(window->dialog("behaviorGraph"));
  click("views", "open.behaviorGraph");
  EXPECT_TRUE(window->dialog("behaviorGraph"));
}

TEST_F(DialogTest, ALogIsPlayedByTheToolbar) {
  ASSERT_TRUE(execute("log start"));
  ASSERT_TRUE(execute("run 3s"));
  const std::string file = (folder.path() / "test.mcap").string();
  ASSERT_TRUE(execute("log save " + file));
  ASSERT_TRUE(execute("sl recorded " + file));
  ASSERT_TRUE(execute("robot recorded"));
  ASSERT_TRUE(execute("st on 1"));
  const auto position = [](Console& console) {
    return console.session().find("recorded")->onLog()->player().position();
  };
  window->open("logPlayer");
  EXPECT_TRUE(until([&] { return widget<QAbstractButton>("logPlayer", "forward")->isEnabled(); }));
  click("logPlayer", "play");
  finish();
  EXPECT_TRUE(until([&] { return on(position) > 20; }));
  EXPECT_TRUE(
      until([&] { return widget<QLabel>("logPlayer", "place")->text() != "0.00 of 0.00 s"; }));
  click("logPlayer", "play");
  finish();
  const auto before = on(position);
  click("logPlayer", "forward");
  finish();
  EXPECT_EQ(on(position), before + 1);
  click("logPlayer", "back");
  finish();
  EXPECT_EQ(on(position), before);
  auto* slider = widget<QSlider>("logPlayer", "position");
  slider->setSliderPosition(500);
  Q_EMIT slider->sliderMoved(500);
  EXPECT_TRUE(until([&] {
    const auto log = session->status().log;
    return log && std::abs((log->now - log->begin) / (log->end - log->begin) - 0.5) < 0.05;
  }));
  choose("logPlayer", "speed", "2×");
  Q_EMIT widget<QComboBox>("logPlayer", "speed")->activated(4);
  click("logPlayer", "loop");
  finish();
  EXPECT_TRUE(session->status().log->loop);
  EXPECT_EQ(session->status().log->speed, 2);
}

}  // namespace
}  // namespace gt
