#include <QAction>
#include <QElapsedTimer>
#include <QFile>
#include <QJsonArray>
#include <QLineEdit>
#include <QMenu>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <vector>

#include "workbench/Application.h"
#include "workbench/CommandPalette.h"
#include "workbench/TestWindow.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

TEST_F(WindowTest, TheFirstStartShowsAUsefulArrangement) {
  for (const char* key : {"field", "scene", "image", "xabsl", "console", "simulation"})
    EXPECT_TRUE(window->dialog(key)) << key;
  // Each viewer has a sheet of the first robot after a moment.
  EXPECT_TRUE(execute("run 1s"));
  for (const char* key : {"field", "image", "xabsl"}) {
    window->bringToFront(key);
    auto* viewer = dynamic_cast<ViewDialog*>(window->dialog(key));
    ASSERT_TRUE(viewer);
    EXPECT_TRUE(until([&] { return viewer->sheet().sheet() && viewer->sheet().text().isEmpty(); }))
        << key << viewer->sheet().text().toStdString();
  }
  EXPECT_EQ(on([](Console& console) { return console.selection(); }).size(), 1u);
}

TEST_F(WindowTest, TimePassesAndStandsByTheToolbar) {
  EXPECT_EQ(session->status().time.ms, 0);
  click("simulation", "step");
  finish();
  EXPECT_EQ(session->status().time.ms, 8);
  click("simulation", "start");
  EXPECT_TRUE(until([&] { return session->status().time.ms > 400; }));
  EXPECT_TRUE(session->status().started);
  click("simulation", "start");
  finish();
  EXPECT_FALSE(session->status().started);
  click("simulation", "reset");
  finish();
  EXPECT_EQ(session->status().time.ms, 0);
}

TEST_F(WindowTest, TheSpeedIsChosen) {
  choose("simulation", "speed", "0.5×");
  finish();
  EXPECT_EQ(session->status().pace, 0.5);
  const std::int64_t before = session->status().time.ms;
  QElapsedTimer clock;
  clock.start();
  click("simulation", "start");
  EXPECT_TRUE(until([&] { return session->status().time.ms > before + 500; }));
  EXPECT_GE(clock.elapsed(), 900);
}

TEST_F(WindowTest, ARobotIsConnectedByTheToolbarAndStaysSoAfterAReset) {
  choose("simulation", "robot", "blue2");
  finish();
  const auto selection = [](Console& console) { return console.selection(); };
  EXPECT_EQ(on(selection), std::vector<std::string>{"blue2"});
  click("simulation", "reset");
  finish();
  EXPECT_EQ(on(selection), std::vector<std::string>{"blue2"});
}

TEST_F(WindowTest, ACommandThatRunsIsStoppedAndDoesNotBlockTheWindow) {
  session->execute("run 100 min");
  EXPECT_TRUE(until([&] { return session->status().time.ms > 500; }));
  EXPECT_TRUE(session->busy());
  // Views are made meanwhile.
  EXPECT_NE(value("ball.x").substr(0, 5), "error");
  qint64 longest = 0;
  QElapsedTimer clock;
  clock.start();
  for (int i = 0; i < 100; ++i) {
    const qint64 before = clock.elapsed();
    QCoreApplication::processEvents();
    longest = std::max(longest, clock.elapsed() - before);
    QTest::qSleep(5);
  }
  EXPECT_LT(longest, 2000) << "ms";
  click("simulation", "start");
  EXPECT_TRUE(until([&] { return !session->busy(); }));
  EXPECT_TRUE(printed("stopped at"));
}

TEST_F(WindowTest, TimeStartsAlsoWhileACommandIsExecuted) {
  for (int i = 0; i < 100; ++i) session->execute("gc playing");  // one of them, when it is clicked
  click("simulation", "start");
  EXPECT_TRUE(until([&] { return session->status().started; }));
}

TEST_F(WindowTest, ATypedLineIsExecutedAndItsErrorShown) {
  window->bringToFront("console");
  auto* input = widget<QLineEdit>("console", "input");
  QTest::keyClicks(input, "place ball 500 300");
  QTest::keyClick(input, Qt::Key_Return);
  finish();
  EXPECT_EQ(value("ball.x"), "500");
  QTest::keyClicks(input, "plaec ball 1 2");
  QTest::keyClick(input, Qt::Key_Return);
  finish();
  auto* output = widget<QPlainTextEdit>("console", "output");
  EXPECT_TRUE(until([&] { return output->toPlainText().contains("there is no such command"); }));
  QTest::keyClick(input, Qt::Key_Up);
  QTest::keyClick(input, Qt::Key_Up);
  EXPECT_EQ(input->text(), "place ball 500 300");
}

TEST_F(WindowTest, TheTabKeyCompletes) {
  auto* input = widget<QLineEdit>("console", "input");
  QTest::keyClicks(input, "fideli");
  QTest::keyClick(input, Qt::Key_Tab);
  EXPECT_TRUE(until([&] { return input->text() == "fidelity "; }));
  QTest::keyClicks(input, "dyn");
  QTest::keyClick(input, Qt::Key_Tab);
  EXPECT_TRUE(until([&] { return input->text() == "fidelity dynamic "; }));
}

TEST_F(WindowTest, LayoutsAreSavedChosenRenamedAndDeleted) {
  window->open("radar");
  ASSERT_TRUE(window->saveLayout("vision"));
  window->open("times");
  delete window->dialog("radar")->parentWidget();
  ASSERT_TRUE(window->saveLayout("speed"));
  ASSERT_TRUE(window->chooseLayout("vision"));
  EXPECT_TRUE(window->dialog("radar"));
  EXPECT_FALSE(window->dialog("times"));
  ASSERT_TRUE(window->layouts().rename("vision", "perception"));
  EXPECT_TRUE(window->layouts().isOwn("perception") && window->layouts().isOwn("speed"));
  EXPECT_FALSE(window->layouts().isOwn("vision"));
  EXPECT_FALSE(window->layouts().rename("perception", "speed"));
  ASSERT_TRUE(window->layouts().remove("speed"));
  EXPECT_FALSE(window->chooseLayout("speed"));
  // The next window begins with the layout that was chosen last.
  window = std::make_unique<MainWindow>(*session, settings());
  EXPECT_TRUE(window->dialog("radar"));
}

TEST_F(WindowTest, ALayoutBelongsToAScene) {
  window->open("radar");
  ASSERT_TRUE(window->saveLayout("lonely"));
  window->layouts().setOfScene("one-robot.scene", "lonely");
  window->arrangeAtFirst();
  window->layouts().setCurrent({});
  EXPECT_FALSE(window->dialog("radar"));
  ASSERT_TRUE(execute("scene one-robot"));
  EXPECT_TRUE(until([&] { return window->dialog("radar") != nullptr; }));
}

TEST_F(WindowTest, ALayoutWaitsForWhatIsAsked) {
  ASSERT_TRUE(window->saveLayout("lonely"));
  window->layouts().setOfScene("one-robot.scene", "lonely");
  window->layouts().setCurrent({});
  const QPointer<Dialog> field = window->dialog("field");
  ASSERT_TRUE(field);
  // As a dialog's question or menu: who asks must still be there when the answer comes.
  bool there = false;
  {
    QMenu menu{field};
    menu.addAction("an entry");
    QTimer::singleShot(0, &menu, [&] {
      EXPECT_TRUE(execute("scene one-robot"));
      QTest::qWait(200);
      there = static_cast<bool>(field);
      menu.close();
    });
    menu.exec(QPoint{10, 10});
  }
  EXPECT_TRUE(there);
  EXPECT_TRUE(until([&] { return window->layouts().current() == "lonely"; }));
  EXPECT_FALSE(field);
}

TEST_F(WindowTest, NoTabIsEverMovedWithinItsBar) {
  int bars = 0;
  for (const DialogType& type : Dialog::types()) {
    ASSERT_TRUE(window->open(type.id));
    QCoreApplication::sendPostedEvents();  // no timer
    for (QTabBar* bar : window->findChildren<QTabBar*>(Qt::FindDirectChildrenOnly)) {
      EXPECT_FALSE(bar->isVisible() && bar->isMovable()) << type.id;
      ++bars;
    }
  }
  EXPECT_GT(bars, 0);
}

TEST_F(WindowTest, ABrokenLayoutLeavesTheFirstArrangement) {
  QFile file{settings() + "/broken.layout.json"};
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"dialogs\": [");
  file.close();
  window->layouts().setCurrent("broken");
  window = std::make_unique<MainWindow>(*session, settings());
  EXPECT_TRUE(window->dialog("field"));
  const auto done = window->arrange(QJsonObject{{"version", 1}, {"dialogs", 7}});
  EXPECT_FALSE(done);
  EXPECT_TRUE(window->dialog("field"));
}

TEST_F(WindowTest, LayoutsComeWithTheProgram) {
  ASSERT_GE(window->layouts().names().size(), 4);
  for (const QString& name : window->layouts().names()) {
    EXPECT_FALSE(window->layouts().isOwn(name)) << name.toStdString();
    ASSERT_TRUE(window->chooseLayout(name)) << name.toStdString();
    // Each of its dialogs is there, and one of each place can be seen.
    const auto layout = window->layouts().load(name);
    ASSERT_TRUE(layout);
    for (const QJsonValue entry : (*layout)["dialogs"].toArray())
      EXPECT_TRUE(window->dialog(entry["dialog"].toString()))
          << name.toStdString() << ": " << entry["dialog"].toString().toStdString();
    Dialog* const first = window->dialog((*layout)["dialogs"][0]["dialog"].toString());
    EXPECT_TRUE(until([&] { return !first->visibleRegion().isEmpty(); })) << name.toStdString();
  }
  // The user's own one goes before it.
  ASSERT_TRUE(window->chooseLayout("Vision"));
  window->open("robot");
  ASSERT_TRUE(window->saveLayout("Vision"));
  EXPECT_TRUE(window->layouts().isOwn("Vision"));
  window->arrangeAtFirst();
  ASSERT_TRUE(window->chooseLayout("Vision"));
  EXPECT_TRUE(window->dialog("robot"));
  ASSERT_TRUE(window->layouts().remove("Vision"));
  ASSERT_TRUE(window->chooseLayout("Vision"));
  EXPECT_FALSE(window->dialog("robot"));
}

TEST_F(WindowTest, ABrokenFileLeavesItsLastGoodState) {
  window->open("radar");
  ASSERT_TRUE(window->saveLayout("mine"));
  window->open("times");
  ASSERT_TRUE(window->saveLayout("mine"));
  const auto spoil = [&](const QString& name) {
    QFile file{settings() + "/" + name};
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write("{ no JSON");
  };
  spoil("mine.layout.json");
  spoil("settings.json");
  window = std::make_unique<MainWindow>(*session, settings());
  EXPECT_EQ(window->layouts().current(), "mine");
  EXPECT_TRUE(window->dialog("radar"));
  EXPECT_FALSE(window->dialog("times"));
  const QString line = window->statusBar()->currentMessage();
  EXPECT_TRUE(line.contains("its last good state is used")) << line.toStdString();
  EXPECT_FALSE(line.contains('\n'));
}

/// Closes the window, and answers the question about what is not saved by one of its buttons.
/// Returns what it listed.
QString closeAndAnswer(QWidget& window, QMessageBox::StandardButton answer) {
  QString text;
  QTimer::singleShot(0, &window, [&] {
    auto* box = qobject_cast<QMessageBox*>(QApplication::activeModalWidget());
    if (!box) return;
    text = box->text();
    QTest::mouseClick(box->button(answer), Qt::LeftButton);
  });
  window.close();
  QCoreApplication::processEvents();
  return text;
}

TEST_F(WindowTest, ClosingAsksForWhatIsNotSaved) {
  ASSERT_TRUE(window->saveLayout("mine"));
  ASSERT_TRUE(execute("run 200 ms"));
  EXPECT_TRUE(window->unsaved().empty());
  window->open("radar");
  ASSERT_TRUE(execute("log start"));
  ASSERT_TRUE(execute("run 200 ms"));
  EXPECT_TRUE(until([&] { return !session->status().recordings.empty(); }));
  const QString text = closeAndAnswer(*window, QMessageBox::Cancel);
  EXPECT_TRUE(text.contains("the layout mine")) << text.toStdString();
  EXPECT_TRUE(text.contains("the recording of red1")) << text.toStdString();
  EXPECT_TRUE(window->isVisible());
  ASSERT_TRUE(execute("log stop"));  // viewers ask the robot, whose answers would be recorded
  ASSERT_TRUE(execute("log save " + (folder.path() / "kept.mcap").string()));
  EXPECT_TRUE(until([&] { return session->status().recordings.empty(); }));
  // Only the layout is left, which needs no file name.
  EXPECT_FALSE(closeAndAnswer(*window, QMessageBox::Save).contains("recording"));
  EXPECT_FALSE(window->isVisible());
  ASSERT_TRUE(window->chooseLayout("mine"));
  EXPECT_TRUE(window->dialog("radar"));
}

TEST_F(WindowTest, ClosingADialogAsksForWhatItHolds) {
  ASSERT_TRUE(execute("run 400 ms"));
  Dialog* dialog = window->open("colorTable");
  auto* sheet = widget<SheetWidget>("colorTable", "image");
  EXPECT_TRUE(until([&] { return sheet->sheet() != nullptr; }));
  EXPECT_FALSE(dialog->unsaved());
  QTest::mouseClick(sheet, Qt::LeftButton, {}, sheet->rect().center());
  ASSERT_TRUE(dialog->unsaved());
  EXPECT_TRUE(closeAndAnswer(*dialog->parentWidget(), QMessageBox::Cancel).contains("color table"));
  EXPECT_TRUE(window->dialog("colorTable"));
  closeAndAnswer(*dialog->parentWidget(), QMessageBox::Discard);
  EXPECT_TRUE(until([&] { return !window->dialog("colorTable"); }));
}

TEST_F(WindowTest, EveryDialogOpensShowsItselfAndKeepsItsSettings) {
  for (const DialogType& type : Dialog::types()) {
    Dialog* const dialog = window->open(type.id);
    ASSERT_TRUE(dialog) << type.id;
    EXPECT_TRUE(until([&] { return dialog->isVisible(); })) << type.id;
    dialog->refresh();
    const QJsonObject settings = dialog->settings();
    dialog->restore(settings);
    EXPECT_EQ(dialog->settings(), settings) << type.id;
    dialog->restore({{"robot", 7}, {"image", "no such"}, {"range", "far"}});
    EXPECT_GT(std::string_view{type.help}.size(), 20u) << type.id;
  }
  ASSERT_TRUE(execute("run 200ms"));
  const QJsonObject arrangement = window->arrangement();
  EXPECT_TRUE(window->arrange(arrangement));
}

TEST_F(WindowTest, SeveralViewersAreOpenOnSeveralRobots) {
  auto* first = dynamic_cast<ViewDialog*>(window->dialog("image"));
  auto* second = dynamic_cast<ViewDialog*>(window->open("image"));
  ASSERT_TRUE(first && second);
  EXPECT_NE(first, second);
  ASSERT_TRUE(execute("run 200 ms"));
  second->setRobot("blue3");
  EXPECT_TRUE(until([&] { return second->sheet().sheet() != nullptr; }))
      << second->sheet().text().toStdString();
  const QJsonObject arrangement = window->arrangement();
  ASSERT_TRUE(window->arrange(arrangement));
  second = dynamic_cast<ViewDialog*>(window->dialog("image#2"));
  ASSERT_TRUE(second);
  EXPECT_EQ(second->robot(), "blue3");
}

TEST_F(WindowTest, CommandsAreFoundBySomeLetters) {
  EXPECT_EQ(mismatch("", "Reset"), 0);
  EXPECT_LT(mismatch("xyz", "Reset"), 0);
  EXPECT_LT(mismatch("rst", "Reset"), mismatch("rst", "Robot: stop"));
  CommandPalette palette{window.get(), window->commands(), *session};
  palette.show();
  auto* edit = palette.findChild<QLineEdit*>();
  QTest::keyClicks(edit, "place ball 100 -200");
  QTest::keyClick(edit, Qt::Key_Return);
  finish();
  EXPECT_EQ(value("ball.y"), "-200");
  CommandPalette again{window.get(), window->commands(), *session};
  edit = again.findChild<QLineEdit*>();
  QTest::keyClicks(edit, "time diag");
  QTest::keyClick(edit, Qt::Key_Return);
  EXPECT_TRUE(window->dialog("times"));
}

/// Processor time of this thread in ms: what else runs on the machine does not count.
double threadTime() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

/// How much processor time passes of the event loop took for some seconds, in ms.
struct PassTimes {
  double most = 0;  ///< Of 95 %.
  double longest = 0;
};

PassTimes measurePasses() {
  std::vector<double> times;
  QElapsedTimer clock;
  clock.start();
  while (clock.elapsed() < 4000) {
    const double before = threadTime();
    QCoreApplication::processEvents();
    times.push_back(threadTime() - before);
    QTest::qSleep(1);
  }
  std::ranges::sort(times);
  const PassTimes found{times[times.size() * 95 / 100], times.back()};
  std::printf("event loop: 95 %% of %zu passes below %.1f ms, the longest %.1f ms\n", times.size(),
              found.most, found.longest);
  return found;
}

TEST_F(WindowTest, TheEventLoopIsNotHeldUp) {
  window->resize(1600, 1000);
  for (const char* key : {"image", "image", "image", "times", "radar", "values"}) window->open(key);
  ASSERT_TRUE(execute("plot ball.speed on"));
  ASSERT_TRUE(execute("st on 1"));
  session->execute("start");
  constexpr double mostAllowed = 16, longestAllowed = 50;
  // Other programs take this one's caches, so that a pass may take long once.
  PassTimes times = measurePasses();
  for (int i = 0; i < 2 && (times.most >= mostAllowed || times.longest >= longestAllowed); ++i)
    times = measurePasses();
  EXPECT_LT(times.most, mostAllowed);
  EXPECT_LT(times.longest, longestAllowed);
}

TEST_F(WindowTest, ItEndsInTheMiddleOfACommand) {
  session->execute("run 100 min");
  EXPECT_TRUE(until([&] { return session->status().time.ms > 100; }));
  QElapsedTimer clock;
  clock.start();
  window.reset();
  session.reset();
  EXPECT_LT(clock.elapsed(), 10000);
}

}  // namespace
}  // namespace gt

int main(int argc, char** argv) {
  // What no window here can do is nothing new: some hundred lines would hide what a test says.
  static QtMessageHandler print = nullptr;
  print = qInstallMessageHandler(
      [](QtMsgType type, const QMessageLogContext& context, const QString& text) {
        if (!text.startsWith("This plugin does not support ")) print(type, context, text);
      });
  gt::Application application{argc, argv};
  testing::InitGoogleMock(&argc, argv);
  return RUN_ALL_TESTS();
}
