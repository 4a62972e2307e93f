#include <QInputDialog>
#include <QJsonArray>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QSlider>
#include <QTableWidget>
#include <QTreeWidget>
#include <cmath>
#include <filesystem>

#include "base/File.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// Whether somebody can click or type there, and it is not a part of another control.
bool isControl(const QWidget& widget) {
  const bool kind =
      qobject_cast<const QAbstractButton*>(&widget) || qobject_cast<const QComboBox*>(&widget) ||
      qobject_cast<const QAbstractSpinBox*>(&widget) || qobject_cast<const QSlider*>(&widget) ||
      qobject_cast<const QLineEdit*>(&widget);
  for (const QWidget* around = widget.parentWidget(); kind && around && !around->isWindow();
       around = around->parentWidget())
    if (qobject_cast<const QComboBox*>(around) || qobject_cast<const QAbstractSpinBox*>(around) ||
        qobject_cast<const QLineEdit*>(around) || qobject_cast<const QAbstractItemView*>(around))
      return false;
  return kind && !widget.objectName().startsWith("qt_");
}

TEST_F(DialogTest, EachControlHasANameAndATooltip) {
  std::vector<std::string> lacking;
  for (const DialogType& type : Dialog::types()) {
    window->open(type.id);
    const QWidget* dialog = window->dialog(type.id);
    ASSERT_TRUE(dialog) << type.id;
    for (const QWidget* widget : dialog->findChildren<QWidget*>())
      if (isControl(*widget) && (widget->objectName().isEmpty() || widget->toolTip().isEmpty()))
        lacking.push_back(std::string{type.id} + ": " + widget->metaObject()->className() + " \"" +
                          widget->objectName().toStdString() + "\"");
  }
  EXPECT_THAT(lacking, testing::IsEmpty());
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
  const auto sent = [&] {
    return widget<QTableWidget>("debugKeys", "table")->item(0, 2)->text().toStdString();
  };
  EXPECT_EQ(sent(), "not yet");
  click("debugKeys", "send");
  EXPECT_TRUE(until([&] { return sent() == "yes"; }));
}

TEST_F(DialogTest, DebugKeysTellWhatTheRobotRefusesAndOfferItsOwn) {
  window->bringToFront("debugKeys");
  auto* key = widget<QComboBox>("debugKeys", "key");
  EXPECT_TRUE(until([&] { return key->findText("ImageProcessor/grid") >= 0; }));
  key->setEditText("ImageProcessor/nonsense");
  click("debugKeys", "always");
  click("debugKeys", "send");
  const auto* table = widget<QTableWidget>("debugKeys", "table");
  EXPECT_TRUE(until([&] { return table->item(0, 2)->text() == "refused"; }));
  EXPECT_THAT(table->item(0, 2)->toolTip().toStdString(),
              ::testing::HasSubstr("there is no such debug key"));
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
  Q_EMIT errors->itemClicked(errors->item(0));
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

}  // namespace
}  // namespace gt
