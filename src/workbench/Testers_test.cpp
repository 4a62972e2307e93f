#include <QCheckBox>
#include <QDropEvent>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPlainTextEdit>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTreeWidget>
#include <filesystem>

#include "base/File.h"
#include "representations/behavior/BehaviorState.h"
#include "workbench/CustomPlot.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// A robot alone, whose behavior is switched off.
class TesterTest : public WindowTest {
 protected:
  TesterTest() : WindowTest{"scenes/one-robot.scene"} {
    EXPECT_TRUE(execute("sr BehaviorControl disabled"));
  }
  std::string of(const std::string& path) { return value("red3." + path); }
};

TEST_F(TesterTest, MotionsAreSentByTheButton) {
  window->open("motion");
  choose("motion", "motion", "normal");
  EXPECT_TRUE(widget<QSlider>("motion", "x")->isEnabled());
  widget<QSlider>("motion", "x")->setValue(120);
  widget<QSlider>("motion", "r")->setValue(-30);
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_NE(of("MotionRequest.motion"), "walk");
  choose("motion", "tail", "wagHorizontal");
  click("motion", "send");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(of("MotionRequest.walk.translation.x"), "120");
  EXPECT_EQ(of("MotionRequest.tail"), "wagHorizontal");
  widget<QCheckBox>("motion", "follow")->setChecked(true);
  widget<QSlider>("motion", "y")->setValue(50);
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(of("MotionRequest.walk.translation.y"), "50");
  click("motion", "stop");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(of("MotionRequest.type"), "stand");
}

TEST_F(TesterTest, TheHeadIsMoved) {
  window->open("head");
  choose("head", "mode", "lookAtPoint");
  widget<QSpinBox>("head", "pointY")->setValue(300);
  click("head", "send");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(of("HeadControlMode.mode"), "lookAtPoint");
  EXPECT_EQ(of("HeadControlMode.point.y"), "300");
  choose("head", "mode", "none");
  click("head", "send");
  auto* pan = widget<QSlider>("head", "pan");
  EXPECT_TRUE(pan->isVisible());
  pan->setValue(60);
  finish();
  ASSERT_TRUE(execute("run 1s"));
  EXPECT_NEAR(std::stod(value("robots.red3.joints.headPan")), 60, 3);
}

TEST_F(TesterTest, LinesOfMotionsAreExecutedAndRead) {
  window->open("mof");
  click("mof", "takeOver");
  finish();
  ASSERT_TRUE(execute("run 500 ms"));
  auto* lines = widget<QPlainTextEdit>("mof", "lines");
  click("mof", "read");
  EXPECT_TRUE(until([&] { return !lines->toPlainText().isEmpty(); }));
  const QStringList before = lines->toPlainText().split(' ');
  ASSERT_GT(before.size(), 10);
  QStringList turned = before;
  turned[1] = "500";  // the pan of the head, in mrad
  lines->setPlainText(turned.join(' '));
  std::filesystem::remove("out/motions/tried.mof");
  click("mof", "execute");
  finish();
  EXPECT_FALSE(std::filesystem::exists("out/motions/tried.mof")) << "nobody asked for it here";
  EXPECT_EQ(*readFile(folder.path() / "gt2003/tried.mof"), turned.join(' ').toStdString() + "\n");
  ASSERT_TRUE(execute("run 1s"));
  EXPECT_NEAR(std::stod(value("robots.red3.joints.headPan")), 28.6, 3);
  click("mof", "stop");
  finish();
}

TEST_F(TesterTest, SwitchesArePressedAndTheRobotIsThrownOver) {
  window->open("body");
  const auto pressed = [&] {
    EXPECT_TRUE(execute("run 50 ms"));
    return value("robots.red3.switches.back");
  };
  const std::string released = pressed();
  auto* back = widget<QWidget>("body", "back");
  QTest::mousePress(back, Qt::LeftButton);
  finish();
  EXPECT_NE(pressed(), released);
  QTest::mouseRelease(back, Qt::LeftButton);
  finish();
  EXPECT_EQ(pressed(), released);
  widget<QCheckBox>("body", "latch")->setChecked(true);
  click("body", "back");
  finish();
  EXPECT_NE(pressed(), released);
  click("body", "back");
  finish();
  EXPECT_EQ(pressed(), released);
  choose("body", "direction", "right");
  click("body", "throw");
  finish();
  EXPECT_NE(of("posture"), "standing");
  click("body", "stand");
  finish();
  EXPECT_EQ(of("posture"), "standing");
}

TEST_F(WindowTest, ABehaviorIsRequested) {
  window->open("behaviorTester");
  window->bringToFront("xabsl");
  choose("behaviorTester", "element", "go_to_point");
  auto* x = widget<QComboBox>("behaviorTester", "x");
  x->setEditText("-1500");
  const auto state = [](Console& console) {
    const auto* known = (*console.firstRobot())->observed().newest<BehaviorState>();
    return known && !known->activations.empty() ? known->activations.front().name : std::string{};
  };
  ASSERT_TRUE(execute("run 500 ms"));
  EXPECT_NE(on(state), "go_to_point");
  click("behaviorTester", "send");
  finish();
  ASSERT_TRUE(execute("run 500 ms"));
  EXPECT_EQ(on(state), "go_to_point");
  // The motion that results is shown: to a point so far away the robot walks.
  EXPECT_TRUE(until([&] {
    return widget<QLabel>("behaviorTester", "motion")
        ->text()
        .startsWith(QString::fromStdString("Motion: " + value("MotionRequest.type")));
  }));
  choose("behaviorTester", "element", "unchanged");
  click("behaviorTester", "send");
  finish();
  ASSERT_TRUE(execute("run 500 ms"));
  EXPECT_NE(on(state), "go_to_point");
  click("behaviorTester", "reload");
  EXPECT_TRUE(until([&] { return printed("> xlb"); }));
  finish();
  EXPECT_TRUE(widget<QLabel>("behaviorTester", "error")->text().isEmpty());
}

TEST_F(TesterTest, ValuesAreShownAndChangedInPlace) {
  window->bringToFront("values");
  auto* tree = widget<QTreeWidget>("values", "tree");
  const auto find = [&](const QString& text, int depth) -> QTreeWidgetItem* {
    for (QTreeWidgetItem* item : tree->findItems(text, Qt::MatchExactly | Qt::MatchRecursive, 0)) {
      int up = 0;
      for (const QTreeWidgetItem* parent = item; parent->parent(); parent = parent->parent()) ++up;
      if (up == depth) return item;
    }
    return nullptr;
  };
  EXPECT_TRUE(until([&] { return find("WalkingEngine.InvKin", 1) != nullptr; }));
  find("WalkingEngine.InvKin", 1)->setExpanded(true);
  EXPECT_TRUE(until([&] { return find("gameSpeed", 2) != nullptr; }));
  find("gameSpeed", 2)->setText(1, "0.7");  // as the editor does at its end
  finish();
  EXPECT_EQ(of("WalkingEngine.InvKin.gameSpeed"), "0.7");
  find("RobotPose", 1)->setExpanded(true);
  EXPECT_TRUE(until([&] { return find("pose", 2) != nullptr; }));
  ASSERT_TRUE(execute("run 1s"));
  EXPECT_TRUE(
      until([&] { return find("pose", 2)->text(1).toStdString() == of("RobotPose.pose"); }));
  // A part of the scene.
  find("balls", 1)->setExpanded(true);
  EXPECT_TRUE(until([&] { return find("balls", 1)->childCount() > 0; }));
  // Dropped on a plot, a value is plotted.
  window->bringToFront("plot");
  QMimeData dragged;
  dragged.setText("RobotPose.pose.translation.x");
  QDragEnterEvent enter{{20, 20}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier};
  QApplication::sendEvent(window->dialog("plot"), &enter);
  QDropEvent drop{{20, 20}, Qt::CopyAction, &dragged, Qt::LeftButton, Qt::NoModifier};
  QApplication::sendEvent(window->dialog("plot"), &drop);
  EXPECT_TRUE(
      until([&] { return window->dialog("plot")->settings()["values"].toArray().size() == 1; }));
}

TEST_F(TesterTest, NumbersAreSentToAModule) {
  window->open("testData");
  auto* id = widget<QComboBox>("testData", "id");
  auto* values = widget<QTableWidget>("testData", "values");
  EXPECT_TRUE(until([&] { return id->findText("BallLocator.PIDSmoothed *") >= 0; }));
  choose("testData", "id", "BallLocator.PIDSmoothed *");
  ASSERT_GT(values->rowCount(), 2);
  ASSERT_LE(values->rowCount(), 10);
  const std::string name = values->item(0, 0)->text().toStdString();
  const std::string second = values->item(1, 0)->text().toStdString();
  const std::string before = of("BallLocator.PIDSmoothed." + second);
  EXPECT_EQ(values->item(1, 1)->text().toStdString(), before);
  values->item(0, 1)->setText("0.25");  // as the editor does at its end
  finish();
  EXPECT_NE(of("BallLocator.PIDSmoothed." + name), "0.25");
  click("testData", "send");
  finish();
  EXPECT_EQ(of("BallLocator.PIDSmoothed." + name), "0.25");
  EXPECT_EQ(of("BallLocator.PIDSmoothed." + second), before);
  // What is no number is refused, here or by the robot.
  values->item(0, 1)->setText("much");
  click("testData", "send");
  EXPECT_TRUE(widget<QLabel>("testData", "fault")->text().contains("much"));
  // What was typed is kept for each id, and in layouts.
  values->item(0, 1)->setText("0.5");
  const QJsonObject settings = window->dialog("testData")->settings();
  id->setCurrentIndex(id->findText("BallLocator.PIDSmoothed *") == 0 ? 1 : 0);
  window->dialog("testData")->restore(settings);
  EXPECT_EQ(id->currentText(), "BallLocator.PIDSmoothed *");
  EXPECT_EQ(values->item(0, 1)->text(), "0.5");
  click("testData", "fromRobot");
  EXPECT_TRUE(until([&] { return values->item(0, 1)->text() == "0.25"; }));
}

TEST_F(TesterTest, TheRobotIsMovedByTheJoystickTester) {
  window->open("joystick");
  choose("joystick", "scheme", "stickSpeed");
  auto* scheme = widget<QComboBox>("joystick", "scheme");
  Q_EMIT scheme->activated(scheme->currentIndex());
  finish();
  auto* stick = widget<QWidget>("joystick", "stick");
  QTest::mousePress(stick, Qt::LeftButton, {}, {stick->width() / 2, 4});
  finish();
  ASSERT_TRUE(execute("run 300 ms"));
  EXPECT_EQ(of("MotionRequest.type"), "walk");
  EXPECT_GT(std::stod(of("MotionRequest.walk.translation.x")), 50);
  auto* motion = widget<QLabel>("joystick", "motion");
  EXPECT_TRUE(until([&] { return motion->text().startsWith("walk"); }));
  QTest::mouseRelease(stick, Qt::LeftButton);
  QTest::mousePress(widget<QWidget>("joystick", "button7"), Qt::LeftButton);
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(of("MotionRequest.type"), "getup");
  QTest::mouseRelease(widget<QWidget>("joystick", "button7"), Qt::LeftButton);
  // There is no joystick here.
  click("joystick", "use");
  finish();
  EXPECT_TRUE(until([&] { return !widget<QCheckBox>("joystick", "use")->isChecked(); }));
}

TEST_F(TesterTest, JointsAreShownOverTime) {
  Dialog* dialog = window->open("joints");
  auto* plot = dialog->findChild<QCustomPlot*>();
  ASSERT_TRUE(plot);
  finish();
  ASSERT_TRUE(execute("run 2s"));
  // Each frame of 8 ms, and the newest value is that of the robot. The viewer takes what comes
  // while time passes, the last frames only after the command has ended.
  EXPECT_TRUE(until([&] { return plot->graph(0)->dataCount() >= 248; }));
  EXPECT_LE(plot->graph(0)->dataCount(), 252);
  for (int i = 0; i < plot->graphCount(); ++i) {
    if (plot->graph(i)->name() != "actorics legFR1") continue;
    const double shown = plot->graph(i)->data()->at(plot->graph(i)->dataCount() - 1)->value;
    const double angle = on([](Console& console) {
      return (**(*console.firstRobot())->observed().value<JointData>()).angles[Joint::legFR1];
    });
    EXPECT_NEAR(shown, toDegrees(angle), 1e-9);
    EXPECT_TRUE(plot->graph(i)->visible());
  }
  // Groups are switched on and off, and kept.
  QJsonObject settings = dialog->settings();
  EXPECT_TRUE(settings["sensors legFR"].toBool());
  EXPECT_FALSE(settings["sensors head"].toBool());
  settings["sensors head"] = true;
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings(), settings);
  EXPECT_TRUE(plot->graph(0)->visible());
}

}  // namespace
}  // namespace gt
