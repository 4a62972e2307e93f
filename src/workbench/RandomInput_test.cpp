#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QDir>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QLineEdit>
#include <QMenu>
#include <QPlainTextEdit>
#include <QRandomGenerator>
#include <QTimer>
#include <QTreeWidget>
#include <QWheelEvent>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "base/File.h"
#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// Runs the test in a folder of its own, in which files lie that are broken.
class OwnFolder {
 protected:
  OwnFolder() {
    std::filesystem::current_path(own_.path());
    for (const char* name : files)
      EXPECT_TRUE(writeFile(name, "{\"version\": 1, \"dialogs\": [7, {}"));
  }
  ~OwnFolder() { std::filesystem::current_path(before_); }

  static constexpr const char* files[] = {"a.mcap", "b.log",  "c.hsi",   "d.c64",  "e.tsl",
                                          "f.mof",  "g.json", "h.state", "i.scene"};

 private:
  TemporaryFolder own_;
  std::filesystem::path before_ = std::filesystem::current_path();
};

/// Clicks, keys, wheels, drags and menus at random places of all dialogs; what asks is answered at
/// random, too. GT_MINUTES sets for how long (some seconds), GT_SEED which (1).
class RandomInput : OwnFolder, public WindowTest {
 protected:
  RandomInput() {
    // An answer may itself be asked for more; a timer does not fire within its own slot.
    QObject::connect(&answers_, &QTimer::timeout,
                     [this] { QTimer::singleShot(0, &answers_, [this] { answer(); }); });
    answers_.start(20);
  }

  static double variable(const char* name, double standard) {
    const char* text = std::getenv(name);
    return text ? std::atof(text) : standard;
  }

  int below(int end) { return random_.bounded(end); }
  template <typename List>
  decltype(auto) oneOf(const List& list) {
    return list[below(static_cast<int>(std::size(list)))];
  }

  static bool ends(const QAction& action) { return action.objectName() == "quit"; }

  /// What is modal waits for an answer; the entry that ends the program is none.
  void answer() {
    if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
      QList<QAction*> actions;
      for (QAction* action : menu->actions())
        if (action->isEnabled() && !action->isSeparator() && !action->menu() && !ends(*action))
          actions << action;
      if (actions.isEmpty() || below(3) == 0) return static_cast<void>(menu->close());
      menu->setActiveAction(oneOf(actions));
      QTest::keyClick(menu, Qt::Key_Return);
      return;
    }
    if (QWidget* popup = QApplication::activePopupWidget())
      return static_cast<void>(popup->close());
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog) return;
    if (below(2) == 0) return dialog->reject();
    if (auto* chooser = qobject_cast<QFileDialog*>(dialog)) {
      // Nothing is written elsewhere.
      const QDir own = QDir::current();
      chooser->setDirectory(own);
      chooser->selectFile(own.absoluteFilePath(oneOf(files)));
      for (const QString& file : chooser->selectedFiles())
        if (QFileInfo{file}.absolutePath() != own.absolutePath()) return chooser->reject();
      QMetaObject::invokeMethod(chooser, "accept");
    } else if (auto* box = dialog->findChild<QDialogButtonBox*>();
               box && !box->buttons().isEmpty()) {
      for (auto* line : dialog->findChildren<QLineEdit*>()) line->setText(oneOf(texts));
      QTest::mouseClick(oneOf(box->buttons()), Qt::LeftButton);
    } else {
      dialog->accept();
    }
  }

  QWidget* randomWidget() {
    QList<QWidget*> all;
    for (QWidget* known : window->findChildren<QWidget*>())
      if (known->isVisible() && known->isEnabled() && !known->visibleRegion().isEmpty())
        all << known;
    return all.isEmpty() ? nullptr : oneOf(all);
  }

  void drag(QWidget* target, const QPoint& at, Qt::MouseButton button) {
    // Whatever is pressed may be gone before it is released.
    const QPointer<QWidget> alive{target};
    QTest::mousePress(target, button, {}, at);
    const QPoint to = at + QPoint{below(81) - 40, below(81) - 40};
    if (alive) QTest::mouseMove(target, to);
    if (alive) QTest::mouseRelease(target, button, {}, to);
    if (alive && below(4) == 0) QTest::mouseDClick(target, button, {}, at);
  }

  void type(QWidget* target) {
    if (auto* line = qobject_cast<QLineEdit*>(target); line && target->objectName() == "input") {
      line->setText(oneOf(lines));
      QTest::keyClick(target, below(3) ? Qt::Key_Return : Qt::Key_Tab);
    } else {
      const QPointer<QWidget> alive{target};
      if (below(2)) QTest::keyClicks(target, oneOf(texts));
      constexpr Qt::Key keys[] = {Qt::Key_Up,   Qt::Key_Down,   Qt::Key_Backspace, Qt::Key_Tab,
                                  Qt::Key_Home, Qt::Key_Return, Qt::Key_Delete,    Qt::Key_Escape};
      if (alive) QTest::keyClick(target, oneOf(keys));
    }
  }

  void step() {
    QWidget* const target = randomWidget();
    if (!target) return;
    const QPoint at{below(target->width()), below(target->height())};
    if (trace_)
      std::fprintf(stderr, "%s %s %d,%d\n", target->metaObject()->className(),
                   qPrintable(target->objectName()), at.x(), at.y());
    const int kind = below(10);
    if (auto* tree = qobject_cast<QTreeWidget*>(target);
        tree && tree->topLevelItemCount() > 0 && kind < 6) {
      QTreeWidgetItem* item = tree->topLevelItem(below(tree->topLevelItemCount()));
      if (item->childCount() > 0) item = item->child(below(item->childCount()));
      item->setExpanded(!item->isExpanded());
      if (item->flags() & Qt::ItemIsEditable) tree->editItem(item, tree->columnCount() - 1);
    } else if (kind < 6 &&
               (qobject_cast<QLineEdit*>(target) || qobject_cast<QPlainTextEdit*>(target) ||
                qobject_cast<QAbstractSpinBox*>(target) ||
                qobject_cast<QAbstractSlider*>(target))) {
      type(target);
    } else if (auto* box = qobject_cast<QComboBox*>(target); box && box->count() > 0 && kind < 8) {
      box->setCurrentIndex(below(box->count()));
      Q_EMIT box->activated(box->currentIndex());
    } else if (kind == 9) {
      QContextMenuEvent asked{QContextMenuEvent::Mouse, at, target->mapToGlobal(at)};
      QApplication::sendEvent(target, &asked);
    } else if (kind == 8) {
      QWheelEvent turn{
          at, target->mapToGlobal(at), {},   QPoint{0, 120 * (below(5) - 2)}, Qt::NoButton,
          {}, Qt::NoScrollPhase,       false};
      QApplication::sendEvent(target, &turn);
    } else {
      drag(target, at, kind == 7 ? Qt::RightButton : Qt::LeftButton);
    }
  }

  /// One of the menus' entries, but for the one that ends the program.
  void chooseCommand() {
    QList<QAction*> commands = window->commands();
    commands.removeIf([](const QAction* action) { return ends(*action); });
    QAction* const chosen = oneOf(commands);
    if (trace_) std::fprintf(stderr, "menu %s\n", qPrintable(chosen->text()));
    chosen->trigger();
  }

  static constexpr const char* texts[] = {"a", "7", "-3.5", "red2", "", "1e99", "\"\\", "a b;c"};
  static constexpr const char* lines[] = {
      "run 80 ms", "reset",      "gc ready",   "robot all",  "robot blue2", "start",
      "no such",   "stop",       "step 3",     "seed 3",     "cls",         "ball \"x",
      "dk ? ?",    "help",       "lp play",    "rewind 1 s", "set",         "log start",
      "log clear", "gc playing", "sl x a.mcap"};

  QRandomGenerator random_{static_cast<quint32>(variable("GT_SEED", 1))};
  const double seconds_ = 60 * variable("GT_MINUTES", 0.1);
  const bool trace_ = std::getenv("GT_MINUTES");
  QTimer answers_;
};

TEST_F(RandomInput, BreaksNothing) {
  const auto types = Dialog::types();
  QElapsedTimer clock;
  clock.start();
  constexpr double msPerSecond = 1000;
  for (int i = 0; static_cast<double>(clock.elapsed()) < msPerSecond * seconds_; ++i) {
    if (i % 15 == 0) window->open(oneOf(types).id);
    if (i % 40 == 39) chooseCommand();
    // Not too much at a time, and no run that takes hours.
    if (i % 200 == 199) {
      session->interrupt();
      EXPECT_TRUE(window->arrange(window->arrangement()));
    }
    if (i % 600 == 599) window->arrangeAtFirst();
    step();
    QCoreApplication::processEvents();
    if (i % 10 == 0) QTest::qWait(20);
    ASSERT_TRUE(window->isVisible());
  }
  // All that was asked for is done or refused, and the session still does what it is told.
  session->interrupt();
  EXPECT_TRUE(execute("stop"));
  EXPECT_TRUE(execute("scene \"" + session->root().path("scenes/match.scene") + "\""));
  EXPECT_TRUE(execute("run 80 ms"));
  EXPECT_EQ(session->status().time.ms, 80);
}

}  // namespace
}  // namespace gt
