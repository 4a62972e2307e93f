#include <QAbstractButton>
#include <QCheckBox>
#include <QInputDialog>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPlainTextEdit>
#include <QSlider>
#include <QSpinBox>
#include <QTableWidget>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "representations/perception/ColorTable64.h"
#include "streams/File.h"
#include "workbench/CustomPlot.h"
#include "workbench/SheetWidget.h"
#include "workbench/TestWindow.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

class DialogTest : public WindowTest {
 protected:
  DialogTest() : WindowTest{"scenes/one-robot.scene"} {}
};

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

TEST_F(DialogTest, DebugKeysAreSentByTheButton) {
  window->bringToFront("debugKeys");
  auto* key = widget<QComboBox>("debugKeys", "key");
  key->setEditText("ImageProcessor/grid");
  click("debugKeys", "always");
  const auto drawn = [](Console& console) {
    return (*console.firstRobot())->observed().drawings().contains("ImageProcessor/grid");
  };
  ASSERT_TRUE(execute("run 200 ms"));
  EXPECT_FALSE(on(drawn));
  click("debugKeys", "send");
  finish();
  ASSERT_TRUE(execute("run 200 ms"));
  EXPECT_TRUE(on(drawn));
  // It is kept, and sent again only if it is asked for.
  Dialog* const dialog = window->dialog("debugKeys");
  const QJsonObject settings = dialog->settings();
  click("debugKeys", "disableAll");
  EXPECT_NE(dialog->settings(), settings);
  click("debugKeys", "send");
  finish();
  EXPECT_FALSE(on(drawn));
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings(), settings);
  EXPECT_EQ(widget<QTableWidget>("debugKeys", "table")->item(0, 2)->text(), "not yet");
}

TEST_F(DialogTest, SolutionsAreSwitched) {
  window->bringToFront("solutions");
  const auto active = [](Console& console) {
    return (*(*console.firstRobot())->observed().task("BallLocator"))->active;
  };
  const std::string before = on(active);
  EXPECT_TRUE(until([&] {
    return window->dialog("solutions")->findChild<QComboBox*>("BallLocator") != nullptr;
  }));
  EXPECT_TRUE(widget<QComboBox>("solutions", "BallLocator")->currentText().endsWith(" *"));
  choose("solutions", "BallLocator", "disabled");
  auto* box = widget<QComboBox>("solutions", "BallLocator");
  Q_EMIT box->activated(box->currentIndex());
  finish();
  EXPECT_EQ(on(active), "disabled");
  // The setting default brings the configuration's solution back.
  EXPECT_TRUE(until(
      [&] { return widget<QComboBox>("solutions", "BallLocator")->currentText() == "disabled"; }));
  auto* setting = widget<QComboBox>("solutions", "setting");
  setting->setCurrentIndex(0);
  EXPECT_TRUE(until([&] {
    Q_EMIT setting->activated(0);
    finish();
    return on(active) == before;
  }));
}

TEST_F(DialogTest, ValuesAreRecordedAndShownOverTime) {
  window->bringToFront("plot");
  auto* input = widget<QLineEdit>("plot", "value");
  QTest::keyClicks(input, "RobotPose.pose.rotation");
  QTest::keyClick(input, Qt::Key_Return);
  const auto points = [](Console& console) {
    const auto& series = console.recorder().series();
    const auto found = series.find("red3.RobotPose.pose.rotation");
    return found == series.end() ? std::size_t{0} : found->second.size();
  };
  EXPECT_TRUE(
      until([&] { return window->dialog("plot")->settings()["values"].toArray().size() == 1; }));
  finish();
  ASSERT_TRUE(execute("run 2s"));
  EXPECT_EQ(on(points), 50u);
  // After a reset it is recorded again.
  ASSERT_TRUE(execute("reset"));
  EXPECT_TRUE(until([&] {
    finish();
    return execute("run 200 ms") && on(points) > 0;
  }));
  QTest::keyClicks(input, "no.such.value");
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_TRUE(until([&] { return !input->toolTip().isEmpty(); }));
  EXPECT_EQ(window->dialog("plot")->settings()["values"].toArray().size(), 1);
}

/// Chooses an entry of the context menu that a widget shows, by the texts on the way to it.
void chooseInMenu(QWidget* target, const QStringList& way) {
  QTimer answers;
  bool chosen = false;
  QObject::connect(&answers, &QTimer::timeout, [&] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return;
    QMenu* part = menu;
    for (const QString& text : way)
      for (QAction* action : part->actions())
        if (action->text() == text) {
          if (action->menu()) {
            part = action->menu();
          } else {
            action->trigger();
            chosen = true;
          }
          break;
        }
    menu->close();
  });
  answers.start(20);
  Q_EMIT target->customContextMenuRequested({5, 5});
  EXPECT_TRUE(chosen) << way.join(" > ").toStdString();
}

TEST_F(DialogTest, CurvesHaveAxesFiltersAndCursors) {
  window->bringToFront("plot");
  ASSERT_TRUE(execute("place ball 0 0 400 0"));
  auto* input = widget<QLineEdit>("plot", "value");
  for (const char* name : {"ball.x", "ball.speed"}) {
    QTest::keyClicks(input, name);
    QTest::keyClick(input, Qt::Key_Return);
    EXPECT_TRUE(until([&] { return input->text().isEmpty(); }));
  }
  finish();
  ASSERT_TRUE(execute("run 2s"));
  auto* plot = window->dialog("plot")->findChild<QCustomPlot*>();
  ASSERT_TRUE(until([&] { return plot->graph(0)->dataCount() > 40; }));
  const QCPGraph* x = plot->graph(0);
  chooseInMenu(plot, {"ball.x", "Axis", "Second right"});
  EXPECT_EQ(plot->axisRect()->axis(QCPAxis::atRight, 1), x->valueAxis());
  EXPECT_TRUE(x->valueAxis()->visible());
  // How fast x grows is the ball's speed, as the session knows both.
  chooseInMenu(plot, {"ball.x", "Filter", "Derivative (per s)"});
  const auto points = [this](const std::string& name) {
    return on([name](Console& console) { return console.recorder().series().at(name); });
  };
  const auto xs = points("ball.x");
  ASSERT_GT(xs.size(), 40u);
  for (int i = 20; i < 25; ++i) {
    const auto& now = xs[static_cast<std::size_t>(i)];
    const auto& before = xs[static_cast<std::size_t>(i) - 1];
    const auto found = x->data()->findBegin(static_cast<double>(now.time.ms) / 1000, false);
    EXPECT_NEAR(found->value, 1000 * (now.value - before.value) / double(now.time - before.time),
                1e-6);
  }
  // The cursors: what lies at each of them, and between both.
  click("plot", "cursors");
  auto* values = widget<QTreeWidget>("plot", "cursorValues");
  ASSERT_EQ(values->topLevelItemCount(), 3);
  const double first = values->topLevelItem(0)->text(1).toDouble();
  const double second = values->topLevelItem(0)->text(2).toDouble();
  EXPECT_LT(first, second);
  const auto at = [&](double time) { return int(std::lround(plot->xAxis->coordToPixel(time))); };
  const int middle = plot->axisRect()->center().y();
  QTest::mousePress(plot, Qt::LeftButton, {}, {at(first), middle});
  QTest::mouseMove(plot, {at(1), middle});
  QTest::mouseRelease(plot, Qt::LeftButton, {}, {at(1), middle});
  EXPECT_NEAR(values->topLevelItem(0)->text(1).toDouble(), 1, 0.1);
  const auto speeds = points("ball.speed");
  const double speedAtOne =
      std::ranges::lower_bound(speeds, Time{1000}, {}, &ObservedRobot::Point::time)->value;
  EXPECT_NEAR(values->topLevelItem(1)->text(1).toDouble(), speedAtOne, 30);
  // One over the other, kept with the layout.
  chooseInMenu(plot, {"X axis", "ball.speed"});
  EXPECT_FALSE(x->visible());
  EXPECT_EQ(plot->xAxis->label(), "ball.speed");
  EXPECT_TRUE(until([&] {
    const auto* over = qobject_cast<QCPCurve*>(plot->plottable(1));
    return over && over->visible() && over->dataCount() > 40;
  }));
  const QJsonObject settings = window->dialog("plot")->settings();
  window->dialog("plot")->restore({});
  EXPECT_EQ(plot->plottableCount(), 0);
  window->dialog("plot")->restore(settings);
  EXPECT_EQ(window->dialog("plot")->settings(), settings);
}

TEST_F(WindowTest, TheToolbarOfViewsOpensDialogs) {
  window->open("views");
  EXPECT_FALSE(window->dialog("behaviorGraph"));
  click("views", "open.behaviorGraph");
  EXPECT_TRUE(window->dialog("behaviorGraph"));
}

TEST_F(DialogTest, ASceneIsEditedAndBegun) {
  window->open("sceneEditor");
  click("sceneEditor", "current");
  auto* text = widget<QPlainTextEdit>("sceneEditor", "text");
  const QString scene = text->toPlainText();
  EXPECT_TRUE(scene.contains("<robots>"));
  // What is wrong is shown at its place.
  auto* errors = widget<QListWidget>("sceneEditor", "errors");
  const auto shown = [&](const QString& what) {
    return until([&] { return errors->count() > 0 && errors->item(0)->text().contains(what); });
  };
  EXPECT_TRUE(shown("Nothing is wrong")) << errors->item(0)->text().toStdString();
  // As typing does, and unlike setPlainText, this changes the document.
  const auto type = [&](const QString& all) {
    text->selectAll();
    text->insertPlainText(all);
  };
  type(QString{scene}.replace("<balls>", "\n<bals>").replace("</balls>", "</bals>"));
  EXPECT_TRUE(shown("bals")) << errors->item(0)->text().toStdString();
  const int line = text->toPlainText().split("<bals>").front().count('\n') + 1;
  EXPECT_TRUE(errors->item(0)->text().contains(QString{".scene:%1:"}.arg(line)))
      << errors->item(0)->text().toStdString();
  emit errors->itemClicked(errors->item(0));
  EXPECT_EQ(text->textCursor().blockNumber() + 1, line);
  // Another place of the ball, in a file of its own.
  type(QString{scene}.replace("<ball x=\"0\"", "<ball x=\"700\""));
  ASSERT_TRUE(window->dialog("sceneEditor")->unsaved());
  const std::string stray = (folder.path() / "edited.scene").string();
  answerWith(stray);
  click("sceneEditor", "save");
  EXPECT_EQ(*readFile(stray), text->toPlainText().toStdString());
  // A scene names other files from its own folder: here they are missing.
  EXPECT_TRUE(shown("there is no folder")) << errors->item(0)->text().toStdString();
  click("sceneEditor", "begin");
  EXPECT_TRUE(until([&] {
    return widget<QLabel>("sceneEditor", "state")->text().contains("there is no");
  })) << widget<QLabel>("sceneEditor", "state")->text().toStdString();
  EXPECT_EQ(value("ball.x"), "0");
  for (const char* name : {"config", "layouts", "models"})
    std::filesystem::create_directory_symlink(std::filesystem::absolute(session->root().path(name)),
                                              folder.path() / name);
  const std::string file = (folder.path() / "scenes" / "edited.scene").string();
  std::filesystem::create_directory(folder.path() / "scenes");
  answerWith(file);
  click("sceneEditor", "saveAs");
  EXPECT_FALSE(window->dialog("sceneEditor")->unsaved());
  EXPECT_TRUE(shown("Nothing is wrong")) << errors->item(0)->text().toStdString();
  click("sceneEditor", "begin");
  finish();
  EXPECT_EQ(value("ball.x"), "700");
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

TEST_F(WindowTest, ThingsArePutOnTheFieldByTheContextMenu) {
  auto* field = dynamic_cast<ViewDialog*>(window->dialog("field"));
  ASSERT_TRUE(field);
  EXPECT_TRUE(until([&] { return field->sheet().sheet() != nullptr; }));
  const auto put = [&](const QString& what, double x, double y) {
    QMenu menu;
    const Sheet& sheet = *field->sheet().sheet();
    field->sheet().addActions(menu, {sheet.width() / 2.0 + x * fieldViewScale,
                                     sheet.height() / 2.0 - y * fieldViewScale});
    for (QAction* action : menu.actions().front()->menu()->actions())
      if (action->text() == what) action->trigger();
  };
  const auto stands = [&](const std::string& what, const std::string& where) {
    return until([&] { return value(what + ".x") + " " + value(what + ".y") == where; });
  };
  put("ball", 700, -300);
  EXPECT_TRUE(stands("ball", "700 -300"));
  // The blue team looks from the other side.
  field->setRobot("blue1");
  put("red2", 800, 100);
  EXPECT_TRUE(stands("red2", "-800 -100"));
}

TEST_F(DialogTest, TimesAreMeasuredOverSomeTime) {
  window->open("times");
  auto* modules = widget<QTreeWidget>("times", "modules");
  ASSERT_TRUE(execute("run 1s"));
  const auto find = [&](const char* name) {
    const auto items = modules->findItems(name, Qt::MatchExactly);
    return items.isEmpty() ? nullptr : items.front();
  };
  EXPECT_TRUE(until([&] { return find("ImageProcessor") != nullptr; }));
  ASSERT_TRUE(execute("run 8s"));
  // 25 images and 125 frames of sensors a second.
  EXPECT_TRUE(until([&] {
    session->execute("run 200 ms");
    return std::abs(find("ImageProcessor")->text(4).toDouble() - 25) < 2;
  }));
  EXPECT_GT(find("ImageProcessor")->text(2).toDouble(), 0);
  EXPECT_NEAR(find("WalkingEngine")->text(4).toDouble(), 125, 10);
  QTest::keyClicks(widget<QLineEdit>("times", "filter"), "walk");
  EXPECT_FALSE(find("ImageProcessor"));
  EXPECT_TRUE(find("WalkingEngine"));
}

TEST_F(DialogTest, NetworksAreKeptAndConnectedTo) {
  window->open("connections");
  Dialog* const dialog = window->dialog("connections");
  dialog->restore(
      {{"networks",
        QJsonObject{{"lab", QJsonArray{QJsonArray{true, "dog", "tcp://127.0.0.1:39471"},
                                       QJsonArray{false, "cat", "tcp://127.0.0.1:39472"}}}}},
       {"current", "lab"}});
  const QJsonObject settings = dialog->settings();
  widget<QTableWidget>("connections", "robots")->item(1, 1)->setText("hound");
  EXPECT_NE(dialog->settings(), settings);
  click("connections", "connect");
  finish();
  EXPECT_TRUE(printed("dog does not answer"));
  const auto names = on([](Console& console) {
    std::vector<std::string> list;
    for (const auto& robot : console.session().robots()) list.push_back(robot->name());
    return list;
  });
  EXPECT_EQ(names, (std::vector<std::string>{"red3", "dog"}));
  EXPECT_TRUE(until([&] {
    return widget<QLabel>("connections", "state")->text().startsWith("dog: does not answer");
  }));
  // A robot that does not answer does not hold up the window.
  choose("simulation", "robot", "dog");
  finish();
  EXPECT_EQ(on([](Console& console) { return console.selection(); }),
            std::vector<std::string>{"dog"});
}

TEST_F(DialogTest, TheConfigurationIsCopiedForARobot) {
  window->open("connections");
  Dialog* const dialog = window->dialog("connections");
  dialog->restore({{"networks", QJsonObject{{"lab", QJsonArray{}}}}, {"current", "lab"}});
  click("connections", "addRobot");
  auto* table = widget<QTableWidget>("connections", "robots");
  const QString target = settings() + "/a stick";
  table->item(0, 1)->setText("dog");
  table->item(0, 2)->setText("tcp://10.0.1.7:15007");
  table->item(0, 5)->setText(target);
  qobject_cast<QComboBox*>(table->cellWidget(0, 3))->setCurrentText("blue");
  qobject_cast<QComboBox*>(table->cellWidget(0, 4))->setCurrentText("defender");
  const QJsonObject settings = dialog->settings();
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings(), settings);
  QTest::mouseClick(table->cellWidget(0, 6), Qt::LeftButton);
  finish();
  const std::string stick = target.toStdString();
  const auto player = readFile(stick + "/player.cfg");
  ASSERT_TRUE(player) << player.error().text();
  EXPECT_THAT(*player, ::testing::HasSubstr("teamColor blue"));
  EXPECT_THAT(*player, ::testing::HasSubstr("playerRole defender"));
  const auto network = readFile(stick + "/network.cfg");
  ASSERT_TRUE(network) << network.error().text();
  EXPECT_THAT(*network, ::testing::HasSubstr("robot dog"));
  EXPECT_THAT(*network, ::testing::HasSubstr("tcp://0.0.0.0:15007"));
  EXPECT_EQ(*readFile(stick + "/coltable.c64"), *readFile("config/coltable.c64"));
  EXPECT_TRUE(printed("playerRole defender"));
}

TEST_F(DialogTest, AColorTableIsMadeByClicking) {
  ASSERT_TRUE(execute("run 500 ms"));
  window->open("colorTable");
  auto* image = dynamic_cast<SheetWidget*>(widget<QWidget>("colorTable", "image"));
  ASSERT_TRUE(image);
  EXPECT_TRUE(until([&] { return image->sheet() != nullptr; }));
  widget<QCheckBox>("colorTable", "hold")->setChecked(true);
  choose("colorTable", "class", "pink");
  const QPoint middle{image->width() / 2, image->height() / 2};
  const QPointF place = image->toSheet(middle);
  const auto classThere = [&] {
    return on([place](Console& console) {
      ObservedRobot& robot = (*console.firstRobot())->observed();
      const Image seen = **robot.value<Image>();
      const Pixel pixel = seen.at(static_cast<int>(place.x()) / 4, static_cast<int>(place.y()) / 4);
      return (**robot.value<ColorTable64>())[pixel];
    });
  };
  const ColorClass before = classThere();
  ASSERT_NE(before, ColorClass::pink);
  QTest::mouseClick(image, Qt::LeftButton, {}, middle);
  finish();
  EXPECT_EQ(classThere(), before) << "nothing goes to the robot before the button is pressed";
  click("colorTable", "send");
  finish();
  EXPECT_TRUE(until([&] { return classThere() == ColorClass::pink; }));
  click("colorTable", "undo");
  click("colorTable", "send");
  finish();
  EXPECT_TRUE(until([&] { return classThere() == before; }));
  QTest::mouseClick(image, Qt::RightButton, {}, middle);
  click("colorTable", "send");
  finish();
  EXPECT_TRUE(until([&] { return classThere() == ColorClass::noColor; }));
}

TEST_F(DialogTest, AMessageIsWrittenAndSent) {
  ASSERT_TRUE(execute("sr BehaviorControl disabled"));
  window->open("messages");
  choose("messages", "type", "MotionRequest");
  auto* text = widget<QPlainTextEdit>("messages", "text");
  EXPECT_TRUE(text->toPlainText().contains("\"stand\"")) << text->toPlainText().toStdString();
  text->setPlainText("{\"type\": \"walk\", \"walk\": {\"translation\": {\"x\": 70, \"y\": 0}}}");
  click("messages", "send");
  EXPECT_EQ(widget<QLabel>("messages", "fault")->text(), "");
  finish();
  ASSERT_TRUE(execute("run 100 ms"));
  EXPECT_EQ(value("MotionRequest.walk.translation.x"), "70");
  // What is wrong is refused, and said.
  text->setPlainText("{\"type\": \"fly\"}");
  click("messages", "send");
  EXPECT_TRUE(widget<QLabel>("messages", "fault")->text().contains("type"));
  click("messages", "fromRobot");
  EXPECT_TRUE(until([&] { return text->toPlainText().contains("70"); }));
  // Texts are kept for each type.
  choose("messages", "type", "LedRequest");
  choose("messages", "type", "MotionRequest");
  EXPECT_TRUE(text->toPlainText().contains("70"));
}

TEST_F(DialogTest, ViewersSayWhyDrawingsDoNotCome) {
  window->bringToFront("field");
  auto* hint = widget<QLabel>("field", "hint");
  const auto says = [&](const char* text) {
    return until([&] {
      EXPECT_TRUE(execute("run 80 ms"));
      return hint->isVisible() == (*text != 0) && (!*text || hint->text().contains(text));
    });
  };
  const auto drawn = [](Console& console) {
    return (*console.firstRobot())->observed().drawings().contains("SelfLocator/pose");
  };
  EXPECT_TRUE(says("") && until([&] {
                EXPECT_TRUE(execute("run 80 ms"));
                return on(drawn);
              }));
  ASSERT_TRUE(execute("dk SelfLocator/pose off"));
  EXPECT_TRUE(says("SelfLocator/pose (off)"));
  EXPECT_FALSE(on(drawn));
  Q_EMIT hint->linkActivated("on");
  finish();
  EXPECT_TRUE(says(""));
  EXPECT_TRUE(on(drawn));
  ASSERT_TRUE(execute("sr BallLocator disabled"));
  EXPECT_TRUE(says("BallLocator/ball (BallLocator is disabled)"));
  QJsonObject settings = window->dialog("field")->settings();
  settings["drawings"] = QJsonArray{"NoModule/nothing"};
  window->dialog("field")->restore(settings);
  EXPECT_TRUE(says("NoModule/nothing (unknown to red3)"));
}

TEST_F(WindowTest, TheTimelineGoesBackInTime) {
  window->open("timeline");
  auto* marks = widget<QTreeWidget>("timeline", "marks");
  auto* slider = widget<QSlider>("timeline", "time");
  ASSERT_TRUE(execute("robot all"));
  ASSERT_TRUE(execute("ci off"));  // faster
  click("game", "ready");
  finish();
  ASSERT_TRUE(execute("run 26s"));
  // The referee's events are marked.
  ASSERT_TRUE(until([&] { return marks->topLevelItemCount() > 0; }));
  const int count = on([](Console& console) {
    return static_cast<int>(console.session().simulation().referee().events().size());
  });
  EXPECT_TRUE(until([&] { return marks->topLevelItemCount() == count; }));
  const std::int64_t first = marks->topLevelItem(0)->data(0, Qt::UserRole).toLongLong();
  const std::string before = value("ball.x") + " " + value("red2.x") + " " + value("blue3.y");
  // A double click goes to before it.
  Q_EMIT marks->itemDoubleClicked(marks->topLevelItem(0), 1);
  finish();
  EXPECT_EQ(session->status().time.ms, (first - 2000) / tickMs * tickMs);
  EXPECT_TRUE(until([&] { return slider->value() == session->status().time.ms; }));
  EXPECT_EQ(slider->maximum(), 26000);
  EXPECT_EQ(marks->topLevelItemCount(), count) << "it happens again";
  // The keys go on, to where it was: the same has happened.
  slider->setFocus();
  QTest::keyClick(slider, Qt::Key_End);
  finish();
  EXPECT_EQ(session->status().time.ms, 26000);
  EXPECT_EQ(value("ball.x") + " " + value("red2.x") + " " + value("blue3.y"), before);
  // Bookmarks are kept with the layout.
  QTimer::singleShot(100, [] {
    auto* input = qobject_cast<QInputDialog*>(QApplication::activeModalWidget());
    ASSERT_TRUE(input);
    input->setTextValue("look here");
    input->accept();
  });
  click("timeline", "bookmark");
  EXPECT_EQ(marks->topLevelItemCount(), count + 1);
  const QJsonObject settings = window->dialog("timeline")->settings();
  EXPECT_EQ(settings["bookmarks"][0][1].toString(), "look here");
  marks->setCurrentItem(marks->topLevelItem(count));
  click("timeline", "remove");
  EXPECT_EQ(marks->topLevelItemCount(), count);
  window->dialog("timeline")->restore(settings);
  EXPECT_EQ(window->dialog("timeline")->settings(), settings);
}

TEST_F(DialogTest, ButtonsAndSlidersExecuteLinesOfTheConsole) {
  Dialog* const dialog = window->open("controls");
  QTimer::singleShot(100, [] {
    QWidget* form = QApplication::activeModalWidget();
    ASSERT_TRUE(form);
    QTest::keyClicks(form->findChild<QLineEdit*>("text"), "Kick-off place");
    QTest::keyClicks(form->findChild<QLineEdit*>("line"), "place ball 120 -40");
    QTest::keyClick(form, Qt::Key_Return);
  });
  click("controls", "add");
  click("controls", "control0");
  finish();
  EXPECT_EQ(value("ball.x") + " " + value("ball.y"), "120 -40");
  // A line with a place for a number belongs to a slider. Layouts keep all.
  QJsonObject settings = dialog->settings();
  QJsonArray controls = settings["controls"].toArray();
  ASSERT_EQ(controls.size(), 1);
  controls.append(QJsonObject{{"text", "Speed"},
                              {"line", "set WalkingEngine.InvKin.gameSpeed %1"},
                              {"key", ""},
                              {"low", 0.2},
                              {"high", 1},
                              {"value", 1}});
  settings["controls"] = controls;
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings(), settings);
  auto* slider = widget<QSlider>("controls", "control1");
  EXPECT_EQ(slider->value(), slider->maximum());
  for (int step = slider->maximum(); step >= 100; step -= 10) slider->setValue(step);
  EXPECT_TRUE(until([&] { return value("WalkingEngine.InvKin.gameSpeed") == "0.6"; }));
  EXPECT_NEAR(dialog->settings()["controls"][1]["value"].toDouble(), 0.6, 1e-9);
}

TEST_F(WindowTest, EightImagesShowRobotsOfTheirOwn) {
  Dialog* dialog = window->open("images");
  QJsonObject settings = dialog->settings();
  QJsonArray fields = settings["fields"].toArray();
  ASSERT_EQ(fields.size(), 8);
  fields[2] = QJsonObject{{"robot", "blue3"}, {"image", "image"}};
  settings["fields"] = fields;
  dialog->restore(settings);
  EXPECT_EQ(dialog->settings()["fields"].toArray()[2].toObject()["robot"].toString(), "blue3");
  ASSERT_TRUE(execute("run 200 ms"));
  auto* own = dynamic_cast<ViewDialog*>(dialog->findChild<Dialog*>("field3"));
  auto* classes = dynamic_cast<ViewDialog*>(dialog->findChild<Dialog*>("field2"));
  ASSERT_TRUE(own && classes);
  EXPECT_TRUE(until([&] { return own->sheet().sheet() && classes->sheet().sheet(); }));
  EXPECT_NE(own->sheet().image(1), classes->sheet().image(1));
}

}  // namespace
}  // namespace gt
