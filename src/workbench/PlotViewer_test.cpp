#include <QLineEdit>
#include <QMenu>
#include <QTreeWidget>
#include <algorithm>
#include <cmath>

#include "workbench/CustomPlot.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

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
  const QString help = input->toolTip();
  QTest::keyClicks(input, "no.such.value");
  QTest::keyClick(input, Qt::Key_Return);
  EXPECT_TRUE(until([&] { return input->toolTip() != help; }));
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

}  // namespace
}  // namespace gt
