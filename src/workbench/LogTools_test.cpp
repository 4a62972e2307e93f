#include <QComboBox>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QSpinBox>
#include <QTreeWidget>
#include <filesystem>

#include "base/File.h"
#include "labels/LabelErrors.h"
#include "logs/LogPlayer.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/modeling/BallModel.h"
#include "representations/perception/BallPercept.h"
#include "workbench/ChartWidget.h"
#include "workbench/CustomPlot.h"
#include "workbench/SheetWidget.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// Two seconds of a robot that looks at a ball, as a log.
class LogTools : public WindowTest {
 protected:
  LogTools() : WindowTest{"scenes/one-robot.scene"} {
    EXPECT_TRUE(execute("place red3 -600 0 0"));
    EXPECT_TRUE(execute("place ball 0 0"));
    EXPECT_TRUE(execute("sr BehaviorControl disabled"));
    EXPECT_TRUE(execute("hcm lookStraightAhead"));
    EXPECT_TRUE(execute("run 1 s"));
    EXPECT_TRUE(execute("log start"));
    EXPECT_TRUE(execute("run 2 s"));
    EXPECT_TRUE(execute("log save " + log));
    EXPECT_TRUE(execute("log stop"));
  }

  void write(const QString& dialog, const QString& name, const std::string& text) {
    widget<QLineEdit>(dialog, name)->setText(QString::fromStdString(text));
  }
  QString text(const QString& dialog, const QString& name) {
    return widget<QLabel>(dialog, name)->text();
  }

  std::string log = (folder.path() / "recorded.mcap").string();
};

TEST_F(LogTools, TwoSolutionsAreComparedOnOneLogAndShownThere) {
  window->open("compare");
  write("compare", "fileA", log);
  choose("compare", "taskA", "BallLocator");
  choose("compare", "solutionA", "PIDSmoothed");
  choose("compare", "taskB", "BallLocator");
  choose("compare", "solutionB", "Probabilistic");
  click("compare", "compare");
  ASSERT_TRUE(until([&] { return text("compare", "state").contains("are the same"); }))
      << text("compare", "state").toStdString();
  auto* tree = widget<QTreeWidget>("compare", "differences");
  QTreeWidgetItem* ball = nullptr;
  for (int i = 0; i < tree->topLevelItemCount(); ++i) {
    if (tree->topLevelItem(i)->text(0) == "BallModel") ball = tree->topLevelItem(i);
  }
  ASSERT_TRUE(ball);
  ASSERT_GT(ball->childCount(), 0);
  QTreeWidgetItem* x = nullptr;
  for (int i = 0; i < ball->childCount(); ++i)
    if (ball->child(i)->text(0) == "position.x") x = ball->child(i);
  ASSERT_TRUE(x);
  // The chosen row's curves, and the place where it differs first.
  ball->setExpanded(true);
  tree->setCurrentItem(x);
  auto* curves = widget<QCustomPlot>("compare", "curves");
  ASSERT_GT(curves->graph(0)->dataCount(), 5);
  const double time = curves->graph(0)->data()->at(0)->key;
  const double a = curves->graph(0)->data()->at(0)->value;
  const double b = curves->graph(1)->data()->at(0)->value;
  EXPECT_NE(a, b);
  click("compare", "jump");
  const auto shown = [&](const std::string& solution) {
    return on([solution](Console& console) -> std::optional<std::pair<double, double>> {
      ConsoleRobot* robot = console.session().find("recorded-" + solution);
      if (!robot || (*robot->observed().task("BallLocator"))->active != solution)
        return std::nullopt;
      const auto model = robot->observed().value<BallModel>();
      if (!model) return std::nullopt;
      return std::pair{static_cast<double>(robot->onLog()->player().now().ms) / 1000,
                       (*model)->position.x()};
    });
  };
  ASSERT_TRUE(
      until([&] { return shown("Probabilistic") && shown("Probabilistic")->first == time; }));
  EXPECT_DOUBLE_EQ(shown("PIDSmoothed")->first, time);
  EXPECT_DOUBLE_EQ(shown("PIDSmoothed")->second, a);
  EXPECT_DOUBLE_EQ(shown("Probabilistic")->second, b);
  // The next one of the same row lies later.
  click("compare", "next");
  click("compare", "jump");
  EXPECT_TRUE(until([&] { return shown("Probabilistic")->first > time; }));
}

TEST_F(LogTools, TwoLogsAreCompared) {
  const std::string part = (folder.path() / "part.mcap").string();
  ASSERT_TRUE(execute("sl whole " + log));
  ASSERT_TRUE(execute("robot whole"));
  ASSERT_TRUE(execute("lp cut " + part + " 0 2"));
  window->open("compare");
  write("compare", "fileA", log);
  write("compare", "fileB", part);
  click("compare", "compare");
  ASSERT_TRUE(until([&] { return text("compare", "state").contains("are the same"); }))
      << text("compare", "state").toStdString();
  auto* tree = widget<QTreeWidget>("compare", "differences");
  ASSERT_GT(tree->topLevelItemCount(), 3);
  for (int i = 0; i < tree->topLevelItemCount(); ++i)
    EXPECT_TRUE(tree->topLevelItem(i)->text(2).endsWith("only B 0"))
        << tree->topLevelItem(i)->text(0).toStdString();
  write("compare", "fileB", "no/such.mcap");
  click("compare", "compare");
  EXPECT_TRUE(until([&] { return text("compare", "state").contains("no/such.mcap"); }));
}

TEST_F(LogTools, LogsAreCutAndJoined) {
  window->open("logEditor");
  answerWith(log);
  click("logEditor", "add");
  auto* topics = widget<QTreeWidget>("logEditor", "topics");
  ASSERT_TRUE(until([&] { return topics->topLevelItemCount() > 2; }));
  const std::string without = topics->topLevelItem(0)->text(0).toStdString();
  topics->topLevelItem(0)->setCheckState(0, Qt::Unchecked);
  widget<QDoubleSpinBox>("logEditor", "to")->setValue(2);
  const std::string part = (folder.path() / "part.mcap").string();
  answerWith(part);
  click("logEditor", "write");
  ASSERT_TRUE(until([&] { return text("logEditor", "state").endsWith("messages"); }))
      << text("logEditor", "state").toStdString();
  // A robot on it ends there, and the log does not hold that kind any more.
  ASSERT_TRUE(execute("sl cut " + part));
  on([without](Console& console) {
    const LogPlayer& player = console.session().find("cut")->onLog()->player();
    EXPECT_LE(player.end().ms, 2000);
    EXPECT_GT(player.end().ms, 1800);
    for (const McapChannel& channel : player.log().channels()) EXPECT_NE(channel.topic, without);
    return true;
  });
  // Joined with the whole log, all of its messages come again.
  const std::uint64_t messages = LogPlayer::open(log)->messages(),
                      kept = LogPlayer::open(part)->messages();
  EXPECT_LT(kept, messages);
  answerWith(part);
  click("logEditor", "add");
  const std::string joined = (folder.path() / "joined.mcap").string();
  answerWith(joined);
  click("logEditor", "write");
  ASSERT_TRUE(until([&] {
    return text("logEditor", "state").endsWith(QString{"%1 messages"}.arg(messages + kept));
  })) << text("logEditor", "state").toStdString();
  EXPECT_EQ(LogPlayer::open(joined)->messages(), messages + kept);
}

class LabelsTest : public LogTools {
 protected:
  LabelsTest() {
    EXPECT_TRUE(execute("sl seen " + log));
    EXPECT_TRUE(execute("robot seen"));
    EXPECT_TRUE(execute("lp pause"));
    window->open("labels");
    number_ = widget<QSpinBox>("labels", "number");
    EXPECT_TRUE(until([&] { return number_->maximum() > 20; }));
    number_->setValue(20);
    finish();
    // The dialog itself shows the number again as soon as it has the image.
    {
      const QSignalBlocker quiet{number_};
      number_->setValue(-1);
    }
    EXPECT_TRUE(execute("# looks again"));
    EXPECT_TRUE(until([&] { return number_->value() == 20; }));
    ball = on([](Console& console) {
      return **console.session().find("seen")->observed().value<BallPercept>();
    });
    EXPECT_TRUE(ball.seen);
  }

  /// Drags on the image, in its pixels.
  void drag(const Vector2d& from, const Vector2d& to) {
    constexpr double zoom = 3;
    auto* sheet = widget<SheetWidget>("labels", "image");
    const QPointF corner = sheet->toSheet({0, 0});
    const double scale = 1 / (sheet->toSheet({1, 0}).x() - corner.x());
    const auto at = [&](const Vector2d& place) {
      return ((QPointF{place.x(), place.y()} * zoom - corner) * scale).toPoint();
    };
    QTest::mousePress(sheet, Qt::LeftButton, {}, at(from));
    QTest::mouseMove(sheet, at((from + to) / 2));
    QTest::mouseMove(sheet, at(to));
    QTest::mouseRelease(sheet, Qt::LeftButton, {}, at(to));
  }

  BallPercept ball;
  QSpinBox* number_;
};

TEST_F(LabelsTest, ABallIsMarkedSavedComparedAndMadeATest) {
  // A little beside where vision finds it.
  const Vector2d center = ball.centerInImage + Vector2d{6, 0};
  choose("labels", "tool", "ball, whole");
  drag(center, center + Vector2d{0, ball.radiusInImage});
  choose("labels", "tool", "goal yellow");
  drag({20, 30}, {60, 50});
  EXPECT_EQ(widget<QListWidget>("labels", "labels")->count(), 2);
  const std::string base = (folder.path() / "by-hand").string();
  answerWith(base + "-labels.csv");
  click("labels", "saveAs");
  const auto saved = readImageLabels(base);
  ASSERT_TRUE(saved) << saved.error().text();
  ASSERT_TRUE(saved->balls.contains(20));
  const BallLabel& label = saved->balls.at(20);
  EXPECT_EQ(label.time, ball.time.ms);
  EXPECT_NEAR((label.center - center).norm(), 0, 1);
  EXPECT_NEAR(label.radius, ball.radiusInImage, 1);
  ASSERT_EQ(saved->fields.at(20).boxes.size(), 1u);
  EXPECT_NEAR(saved->fields.at(20).boxes.begin()->second.right(), 60, 1);
  EXPECT_FALSE(window->dialog("labels")->unsaved());
  // The angle between both, as the log's robot sees the ball when it looks again.
  click("labels", "compare");
  ASSERT_TRUE(until([&] { return text("labels", "summary").contains("ball: 1 of 1"); }))
      << text("labels", "summary").toStdString();
  auto* errors = widget<QCustomPlot>("labels", "errors");
  ASSERT_EQ(errors->graph(0)->dataCount(), 1);
  const double off = (label.center - ball.centerInImage).norm();
  EXPECT_NEAR(errors->graph(0)->data()->at(0)->value,
              toDegrees(std::atan(off / CameraInfo{}.focalX)), 0.1);
  EXPECT_NEAR(errors->graph(0)->data()->at(0)->key, static_cast<double>(ball.time.ms) / 1000, 1e-9);
  EXPECT_TRUE(text("labels", "summary").contains("goal: 0 of 1"))
      << text("labels", "summary").toStdString();
  // As a test it fails, since vision is more than four pixels off, and for the goal.
  const std::string script = (folder.path() / "image.con").string();
  answerWith(script);
  click("labels", "test");
  const auto done = execute("call " + script);
  ASSERT_FALSE(done);
  EXPECT_NE(done.error().text().find("abs(labeled.BallPercept.centerInImage.x"), std::string::npos)
      << done.error().text();
  EXPECT_NE(readFile(script)->find("labeled.BallPercept.seen == true"), std::string::npos);
}

TEST_F(LabelsTest, AnImageThatVisionSeesRightPassesItsTest) {
  choose("labels", "tool", "ball, whole");
  drag(ball.centerInImage, ball.centerInImage + Vector2d{ball.radiusInImage, 0});
  const std::string script = (folder.path() / "right.con").string();
  answerWith(script);
  click("labels", "test");
  const auto done = execute("call " + script);
  EXPECT_TRUE(done) << done.error().text();
  // The log's robot stands where the image is.
  EXPECT_EQ(value("labeled.BallPercept.time"), std::to_string(ball.time.ms));
}

class BehaviorGraphTest : public WindowTest {
 protected:
  BehaviorGraphTest() : WindowTest{"scenes/one-robot.scene"} {}

  int nodeOf(ChartWidget& chart, const QString& label) {
    for (std::size_t i = 0; i < chart.plan().nodes.size(); ++i)
      if (chart.plan().nodes[i].label == label) return static_cast<int>(i);
    return -1;
  }
  void clickNode(ChartWidget& chart, const QString& label) {
    ASSERT_TRUE(until([&] { return chart.placeOf(nodeOf(chart, label)).has_value(); }))
        << label.toStdString();
    QTest::mouseClick(&chart, Qt::LeftButton, {},
                      chart.placeOf(nodeOf(chart, label))->center().toPoint());
  }
};

TEST_F(BehaviorGraphTest, StatesLightUpAndSayWhatTheyDecide) {
  ASSERT_TRUE(execute("dk BehaviorControl/activations on"));
  window->open("behaviorGraph");
  ASSERT_TRUE(execute("run 1 s"));
  ASSERT_TRUE(execute("gc ready"));
  ASSERT_TRUE(execute("run 1 s"));
  const BehaviorState now = on([](Console& console) {
    return *console.selected().front()->observed().newest<BehaviorState>();
  });
  ASSERT_GT(now.activations.size(), 1u);
  auto* options = widget<ChartWidget>("behaviorGraph", "options");
  auto* states = widget<ChartWidget>("behaviorGraph", "states");
  // All that is active is in the graph of options.
  for (const BehaviorState::Activation& activation : now.activations)
    EXPECT_TRUE(until([&] {
      return nodeOf(*options, QString::fromStdString(activation.name)) >= 0;
    })) << activation.name;
  const BehaviorState::Activation& root = now.activations.front();
  clickNode(*options, QString::fromStdString(root.name));
  EXPECT_EQ(widget<QComboBox>("behaviorGraph", "option")->currentText().toStdString(), root.name);
  clickNode(*states, QString::fromStdString(root.state));
  auto* why = widget<QPlainTextEdit>("behaviorGraph", "why");
  EXPECT_TRUE(until([&] { return why->toPlainText().contains("It is active"); }))
      << why->toPlainText().toStdString();
  EXPECT_TRUE(
      why->toPlainText().startsWith(QString::fromStdString("Decisions of " + root.state + ":\n")));
  EXPECT_TRUE(why->toPlainText().contains("Why it began lately"));
  EXPECT_TRUE(why->toPlainText().contains(QString::fromStdString("-> " + root.state)));
}

TEST_F(BehaviorGraphTest, OfARobotOnALogItComesFromTheLog) {
  const std::string log = (folder.path() / "recorded.mcap").string();
  ASSERT_TRUE(execute("log start"));
  ASSERT_TRUE(execute("gc ready"));
  ASSERT_TRUE(execute("run 2 s"));
  ASSERT_TRUE(execute("log save " + log));
  ASSERT_TRUE(execute("sl recorded " + log));
  ASSERT_TRUE(execute("robot recorded"));
  ASSERT_TRUE(execute("sr BehaviorControl disabled"));
  window->open("behaviorGraph");
  auto* options = widget<ChartWidget>("behaviorGraph", "options");
  ASSERT_TRUE(execute("run 1 s"));
  EXPECT_TRUE(until([&] { return options->plan().nodes.size() > 2; }));
}

TEST_F(BehaviorGraphTest, ASituationIsTriedAndSavedAsATest) {
  ASSERT_TRUE(execute("place ball 0 0 900 0"));
  window->open("situation");
  widget<QLineEdit>("situation", "condition")->setText("ball.x > 200");
  widget<QSpinBox>("situation", "runs")->setValue(2);
  widget<QDoubleSpinBox>("situation", "seconds")->setValue(1);
  std::filesystem::remove("out/tests/situation.csv");
  click("situation", "try");
  auto* state = widget<QLabel>("situation", "state");
  EXPECT_TRUE(until([&] { return state->text() == "It happened in 2 of 2 runs"; }))
      << state->text().toStdString();
  EXPECT_FALSE(std::filesystem::exists("out/tests/situation.csv")) << "nobody asked for it here";
  EXPECT_EQ(widget<QTreeWidget>("situation", "results")->topLevelItem(1)->text(2), "ball.x > 200");
  // The script puts it up again, wherever the ball is meanwhile.
  ASSERT_TRUE(execute("place red3 -1000 400 90"));
  const std::string script = (folder.path() / "situation.con").string();
  answerWith(script);
  click("situation", "save");
  EXPECT_TRUE(until([&] { return state->text().endsWith("is written"); }));
  ASSERT_TRUE(execute("run 1 s"));
  const auto done = execute("call " + script);
  EXPECT_TRUE(done) << done.error().text();
  EXPECT_GT(std::stod(value("ball.x")), 200);
  EXPECT_LT(session->status().time.ms, 1000);
  EXPECT_NEAR(std::stod(value("red3.y")), 400, 50);
}

}  // namespace
}  // namespace gt
