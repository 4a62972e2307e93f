#include <QAbstractButton>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QDialog>
#include <QLineEdit>
#include <QRandomGenerator>
#include <QTimer>
#include <QTreeWidget>
#include <QWheelEvent>
#include <iterator>

#include "workbench/TestWindow.h"

namespace gt {
namespace {

/// Clicks, keys, wheels and drags at random places of all dialogs.
class RandomInput : public WindowTest {
 protected:
  RandomInput() {
    // A person who is asked for a file says no.
    QObject::connect(&refusal_, &QTimer::timeout, [] {
      if (auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget()))
        dialog->reject();
    });
    refusal_.start(20);
  }

  int below(int end) { return random_.bounded(end); }

  QWidget* randomWidget() {
    QList<QWidget*> all;
    for (QWidget* known : window->findChildren<QWidget*>())
      if (known->isVisible() && known->isEnabled() && !known->visibleRegion().isEmpty())
        all << known;
    return all.isEmpty() ? nullptr : all[below(static_cast<int>(all.size()))];
  }

  void step() {
    QWidget* const target = randomWidget();
    if (!target) return;
    const QPoint at{below(target->width()), below(target->height())};
    if (auto* tree = qobject_cast<QTreeWidget*>(target); tree && tree->topLevelItemCount() > 0) {
      QTreeWidgetItem* item = tree->topLevelItem(below(tree->topLevelItemCount()));
      if (item->childCount() > 0) item = item->child(below(item->childCount()));
      item->setExpanded(!item->isExpanded());
    } else if (qobject_cast<QLineEdit*>(target) && target->objectName() == "input") {
      const char* const lines[] = {"run 80 ms", "reset",    "gc ready", "robot all", "robot blue2",
                                   "start",     "no such",  "stop",     "step 3",    "seed 3",
                                   "cls",       "ball \"x", "dk ? ?",   "help",      "lp play"};
      QTest::keyClicks(target, lines[below(static_cast<int>(std::size(lines)))]);
      QTest::keyClick(target, Qt::Key_Return);
    } else if (qobject_cast<QLineEdit*>(target) || qobject_cast<QAbstractSpinBox*>(target) ||
               qobject_cast<QAbstractSlider*>(target)) {
      const Qt::Key keys[] = {Qt::Key_Up, Qt::Key_Down, Qt::Key_Backspace, Qt::Key_A,
                              Qt::Key_7,  Qt::Key_Tab,  Qt::Key_Return};
      QTest::keyClick(target, keys[below(static_cast<int>(std::size(keys)))]);
    } else if (auto* box = qobject_cast<QComboBox*>(target); box && box->count() > 0) {
      box->setCurrentIndex(below(box->count()));
      Q_EMIT box->activated(box->currentIndex());
    } else if (below(4) == 0) {
      QWheelEvent turn{
          at, target->mapToGlobal(at), {},   QPoint{0, 120 * (below(5) - 2)}, Qt::NoButton,
          {}, Qt::NoScrollPhase,       false};
      QApplication::sendEvent(target, &turn);
    } else {
      QTest::mousePress(target, Qt::LeftButton, {}, at);
      QTest::mouseMove(target, at + QPoint{below(41) - 20, below(41) - 20});
      QTest::mouseRelease(target, Qt::LeftButton, {}, at);
    }
  }

  /// Another seed N by --gtest_shuffle --gtest_random_seed=N.
  QRandomGenerator random_{
      static_cast<quint32>(1 + testing::UnitTest::GetInstance()->random_seed())};
  QTimer refusal_;
};

TEST_F(RandomInput, BreaksNothing) {
  constexpr int steps = 600;
  const auto types = Dialog::types();
  for (int i = 0; i < steps; ++i) {
    if (i % 15 == 0)
      window->open(types[static_cast<std::size_t>(below(static_cast<int>(types.size())))].id);
    if (i % 100 == 99) {
      EXPECT_TRUE(window->arrange(window->arrangement()));
    }
    step();
    QCoreApplication::processEvents();
    if (i % 10 == 0) QTest::qWait(20);
  }
  // All that was asked for is done or refused, and the session still does what it is told.
  session->interrupt();
  EXPECT_TRUE(execute("stop"));
  EXPECT_TRUE(execute("reset"));
  EXPECT_TRUE(execute("run 80 ms"));
  EXPECT_EQ(session->status().time.ms, 80);
}

}  // namespace
}  // namespace gt
