#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QTreeWidget>
#include <filesystem>

#include "framework/SolutionTable.h"
#include "representations/behavior/BehaviorState.h"
#include "representations/behavior/TeamMessage.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

class BehaviorHistoryTest : public WindowTest {
 protected:
  BehaviorHistoryTest() : WindowTest{"scenes/one-robot.scene"} {}

  /// What the robot's behavior does now, from the root on.
  BehaviorState state() {
    return on([](Console& console) {
      const BehaviorState* const newest =
          console.selected().front()->observed().newest<BehaviorState>();
      return newest ? *newest : BehaviorState{};
    });
  }
};

TEST_F(BehaviorHistoryTest, StatesAreShownOverTimeAndWhyTheyBegan) {
  ASSERT_TRUE(execute("dk BehaviorControl/activations on"));
  // The trace may be on already, as it is while a log is recorded.
  ASSERT_TRUE(execute("dk BehaviorControl/trace on"));
  ASSERT_TRUE(execute("run 400 ms"));
  window->open("behaviorHistory");
  auto* strip = widget<QWidget>("behaviorHistory", "strip");
  auto* why = widget<QPlainTextEdit>("behaviorHistory", "why");
  ASSERT_TRUE(execute("run 1 s"));
  ASSERT_TRUE(execute("gc ready"));
  ASSERT_TRUE(execute("run 1 s"));
  const auto whyAt = [&](const QPoint& at) {
    return until([&] {
      QTest::mouseClick(strip, Qt::LeftButton, {}, at);
      return !why->toPlainText().isEmpty();
    });
  };
  // The newest state of the root option, which is the first row.
  const BehaviorState now = state();
  ASSERT_FALSE(now.activations.empty());
  const BehaviorState::Activation& root = now.activations.front();
  ASSERT_TRUE(whyAt({strip->width() - 3, 5}));
  EXPECT_TRUE(until([&] {
    QTest::mouseClick(strip, Qt::LeftButton, {}, {strip->width() - 3, 5});
    return why->toPlainText().contains(QString::fromStdString("-> " + root.state));
  })) << why->toPlainText().toStdString();
  EXPECT_TRUE(why->toPlainText().contains(QString::fromStdString(root.name)));
  EXPECT_TRUE(why->toPlainText().contains("yes: ")) << why->toPlainText().toStdString();
}

TEST_F(BehaviorHistoryTest, ItFollowsTheConnectedRobotThroughAReset) {
  window->open("behaviorHistory");
  auto* strip = widget<QWidget>("behaviorHistory", "strip");
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(execute("reset"));
    EXPECT_TRUE(until([&] { return session->status().beginnings == 2u + i; }));
    auto* why = widget<QPlainTextEdit>("behaviorHistory", "why");
    why->clear();
    // The dialog sees the reset a little later.
    EXPECT_TRUE(until([&] {
      EXPECT_TRUE(execute("run 200 ms"));
      QTest::mouseClick(strip, Qt::LeftButton, {}, {strip->width() - 3, 5});
      return !why->toPlainText().isEmpty();
    }));
  }
}

using OverviewTest = WindowTest;

TEST_F(OverviewTest, AFilmIsMade) {
  window->open("film");
  const std::filesystem::path file = folder.path() / "of the robot.mp4";
  widget<QLineEdit>("film", "file")->setText(QString::fromStdString(file.string()));
  choose("film", "view", "field");
  auto* state = widget<QLabel>("film", "state");
  click("film", "start");
  EXPECT_TRUE(until([&] { return state->text().endsWith("is being filmed"); }));
  ASSERT_TRUE(execute("run 400 ms"));
  click("film", "stop");
  EXPECT_TRUE(until([&] { return state->text().endsWith("is written"); }));
  EXPECT_GT(std::filesystem::file_size(file), 1000u);
  click("film", "stop");
  EXPECT_TRUE(until([&] { return !state->text().endsWith("is written"); }));
}

TEST_F(OverviewTest, ASolutionIsSwitchedInTheModuleGraph) {
  window->open("modules");
  auto* graph = widget<QWidget>("modules", "graph");
  EXPECT_TRUE(until([&] { return graph->minimumHeight() > 200; }));
  // Below the headings of its process and of those before it.
  const int row = on([](Console& console) {
    int rows = 0;
    for (const auto& process : **console.selected().front()->observed().processes()) {
      ++rows;
      for (const auto& task : process.tasks) {
        if (task.name == "BallLocator") return rows;
        ++rows;
      }
    }
    return -1;
  });
  ASSERT_GT(row, 0);
  QTimer choosing;
  QObject::connect(&choosing, &QTimer::timeout, [] {
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    if (!menu) return;
    for (QAction* action : menu->actions())
      if (action->text().toStdString() == SolutionTable::disabled) menu->setActiveAction(action);
    QTest::keyClick(menu, Qt::Key_Return);
  });
  choosing.start(20);
  constexpr int rowHeight = 22;
  QTest::mouseClick(graph, Qt::LeftButton, {}, {50, row * rowHeight + rowHeight / 2});
  finish();
  EXPECT_EQ(on([](Console& console) {
              return (*console.selected().front()->observed().task("BallLocator"))->active;
            }),
            SolutionTable::disabled);
}

TEST_F(OverviewTest, TheTeamShowsWhatItsRobotsHeard) {
  window->open("team");
  ASSERT_TRUE(execute("robot red2"));
  ASSERT_TRUE(execute("gc ready"));
  ASSERT_TRUE(execute("run 2 s"));
  auto* members = widget<QTreeWidget>("team", "members");
  EXPECT_TRUE(until([&] { return members->topLevelItemCount() == 4; }));
  // How long ago red2 heard from red3, as the robot knows it.
  const std::int64_t ago = on([](Console& console) {
    ObservedRobot& robot = console.session().find("red2")->observed();
    return robot.time() - (**robot.value<TeamMessages>()).byPlayer[2].timeReceived;
  });
  constexpr int hears3 = 8;
  const QString shown = QString{"%1 s"}.arg(static_cast<double>(ago) / 1000, 0, 'f', 1);
  EXPECT_TRUE(until([&] {
    const QTreeWidgetItem* red2 = members->topLevelItem(1);
    return red2->text(0) == "red2" && red2->text(hears3) == shown;
  })) << members->topLevelItem(1)->text(hears3).toStdString()
      << " instead of " << shown.toStdString();
  EXPECT_LT(ago, 2000);
}

}  // namespace
}  // namespace gt
