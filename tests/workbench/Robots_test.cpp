#include <QAbstractButton>
#include <QLabel>
#include <QRegularExpression>
#include <QSlider>
#include <QTableWidget>

#include "logs/LogPlayer.h"
#include "representations/infrastructure/CameraSettings.h"
#include "support/ProgramFolder.h"
#include "support/RobotElsewhere.h"
#include "workbench/CustomPlot.h"
#include "workbench/TestWindow.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

enum class Kind { simulated, onLog, elsewhere };

/// The programs of a robot elsewhere, if the test is about one; before there is a window.
struct Programs {
  explicit Programs(Kind kind) {
    if (kind == Kind::elsewhere) robot = std::make_unique<testing::RobotElsewhere>(programFolder());
  }
  std::optional<Keys> keys() const {
    if (!robot) return std::nullopt;
    const auto read = loadKeys(robot->key());
    return read ? std::optional{*read} : std::nullopt;
  }
  std::unique_ptr<testing::RobotElsewhere> robot;
};

/// A window whose dialogs are connected with one robot of each kind.
class Robots : public ::testing::WithParamInterface<Kind>, public Programs, public WindowTest {
 protected:
  Robots()
      : Programs{GetParam()},
        WindowTest{GetParam() == Kind::elsewhere ? "scenes/empty.scene" : "scenes/one-robot.scene",
                   keys()} {
    name_ = "red3";
    if (GetParam() == Kind::onLog) {
      name_ = "recorded";
      const std::string log = (folder.path() / "recorded.mcap").string();
      for (const std::string& line :
           {std::string{"log start"}, std::string{"run 4s"}, "log save " + log,
            "sl recorded " + log, std::string{"robot recorded"}, std::string{"lp loop on"},
            std::string{"lp play"}})
        EXPECT_TRUE(execute(line)) << line;
    } else if (robot) {
      EXPECT_TRUE(robot->made());
      name_ = robot->address().substr(robot->address().rfind('.') + 1);
      EXPECT_TRUE(execute("sc " + robot->address()));
      EXPECT_TRUE(execute("robot " + name_));
    }
    EXPECT_TRUE(eventually([this] { return of<Image>() && of<SensorDataBuffer>(); }));
  }

  /// Lets time pass until something holds.
  template <typename Condition>
  bool eventually(Condition condition) {
    QElapsedTimer clock;
    clock.start();
    while (clock.elapsed() < patience) {
      if (condition()) return true;
      if (GetParam() == Kind::elsewhere)
        QTest::qWait(40);
      else
        EXPECT_TRUE(execute("run 40 ms"));
    }
    return condition();
  }
  /// A value that the robot itself reports; empty if none has come yet.
  template <typename T>
  std::optional<T> of() {
    return on([name = name_](Console& console) -> std::optional<T> {
      const auto known = console.session().find(name)->observed().value<T>();
      return known ? std::optional{**known} : std::nullopt;
    });
  }
  std::string active(const std::string& task) {
    return on([name = name_, task](Console& console) -> std::string {
      const auto known = console.session().find(name)->observed().task(task);
      return known ? (*known)->active : known.error().text();
    });
  }
  void solve(const QString& task, const QString& solution) {
    const QString name = GetParam() == Kind::elsewhere ? task + ".physical" : task;
    window->bringToFront("solutions");
    ASSERT_TRUE(eventually(
        [&] { return window->dialog("solutions")->findChild<QComboBox*>(name) != nullptr; }));
    choose("solutions", name, solution);
    auto* box = widget<QComboBox>("solutions", name);
    Q_EMIT box->activated(box->currentIndex());
    finish();
    EXPECT_TRUE(eventually([&] { return active(task.toStdString()) == solution.toStdString(); }));
  }

  std::string name_;
};

TEST_P(Robots, AreShownByAllViewers) {
  for (const DialogType& type : Dialog::types()) {
    // What is drawn in space needs OpenGL, and is no ViewDialog here.
    Dialog* const dialog =
        window->dialog(type.id) ? window->dialog(type.id) : window->open(type.id);
    auto* const viewer = dynamic_cast<ViewDialog*>(dialog);
    if (!viewer) continue;
    const bool ofSimulator = std::string_view{type.group} == "Simulator";
    if (ofSimulator && GetParam() != Kind::simulated) continue;
    viewer->setRobot(name_);
    EXPECT_TRUE(eventually([&] {
      window->bringToFront(type.id);
      return viewer->sheet().sheet() && viewer->sheet().text().isEmpty();
    })) << type.id
        << ": " << viewer->sheet().text().toStdString();
  }
}

TEST_P(Robots, HaveDebugKeysSet) {
  window->bringToFront("debugKeys");
  // It shows the table of the connected robot's kind.
  auto* table = widget<QAbstractButton>("debugKeys",
                                        GetParam() == Kind::elsewhere ? "physical" : "simulated");
  EXPECT_TRUE(until([&] { return table->isChecked(); }));
  widget<QComboBox>("debugKeys", "key")->setEditText("ImageProcessor/grid");
  click("debugKeys", "always");
  click("debugKeys", "send");
  finish();
  EXPECT_TRUE(eventually([this] {
    return on([name = name_](Console& console) {
      return console.session().find(name)->observed().drawings().contains("ImageProcessor/grid");
    });
  }));
}

TEST_P(Robots, HaveSolutionsSet) {
  solve("BallLocator", "disabled");
}

TEST_P(Robots, AreMovedByTheMotionTester) {
  solve("BehaviorControl", "disabled");
  window->open("motion");
  choose("motion", "motion", "normal");
  widget<QSlider>("motion", "x")->setValue(120);
  click("motion", "send");
  finish();
  EXPECT_TRUE(eventually([this] {
    const auto request = of<MotionRequest>();
    return request && request->type == MotionType::walk && request->walk.translation.x() == 120;
  }));
}

TEST_P(Robots, HaveTheirCamerasSet) {
  window->bringToFront("camera");
  choose("camera", "gain", "low");
  click("camera", "send");
  finish();
  EXPECT_TRUE(eventually([this] {
    const auto settings = of<CameraSettings>();
    return settings && settings->gain == Gain::gain_low;
  }));
}

TEST_P(Robots, AreRecordedOverTime) {
  session->execute("start");  // joints are shown over the session's time
  window->open("joints");
  auto* joints = window->dialog("joints")->findChild<QCustomPlot*>();
  EXPECT_TRUE(eventually([&] { return joints->graph(0)->dataCount() > 5; }));
  session->execute("log clear");
  session->execute("log start");
  EXPECT_TRUE(eventually([this] {
    for (const RecordingInfo& recording : session->status().recordings)
      if (recording.robot == name_ && recording.messages > 20) return true;
    return false;
  }));
}

TEST_P(Robots, MayBeKilledInTheMiddle) {
  if (GetParam() != Kind::elsewhere) GTEST_SKIP() << "no program of its own";
  ASSERT_TRUE(execute("log start"));
  EXPECT_TRUE(eventually([this] {
    const auto recordings = session->status().recordings;
    return !recordings.empty() && recordings.front().messages > 20;
  }));
  window->open("connections");
  const auto state = [this] { return widget<QLabel>("connections", "state")->text(); };
  const QRegularExpression rates{"connected, [1-9]\\d* messages/s from it"};
  EXPECT_TRUE(eventually([&] { return state().contains(rates); })) << state().toStdString();
  for (const auto& process : robot->processes()) process->kill();
  // The window stays as quick as it was, and what was recorded can be saved.
  qint64 longest = 0;
  for (int i = 0; i < 100; ++i) {
    QElapsedTimer clock;
    clock.start();
    QCoreApplication::processEvents();
    longest = std::max(longest, clock.elapsed());
    QTest::qSleep(10);
  }
  EXPECT_LT(longest, 2000) << "ms";
  EXPECT_TRUE(eventually([&] { return state().contains("does not answer"); }))
      << state().toStdString();
  const std::string file = (folder.path() / "kept.mcap").string();
  EXPECT_TRUE(execute("log save " + file));
  EXPECT_TRUE(LogPlayer::open(file));
  EXPECT_TRUE(execute("mr nod"));  // goes nowhere
  QElapsedTimer clock;
  clock.start();
  window.reset();
  session.reset();
  EXPECT_LT(clock.elapsed(), patience);
}

std::string nameOf(const ::testing::TestParamInfo<Kind>& test) {
  return std::string{enumName(test.param)};
}
INSTANTIATE_TEST_SUITE_P(, Robots, ::testing::Values(Kind::simulated, Kind::onLog, Kind::elsewhere),
                         nameOf);

}  // namespace
}  // namespace gt

int main(int argc, char** argv) {
  QApplication application{argc, argv};
  ::testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
