#include "workbench/clicks/Hand.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QMenuBar>
#include <QMessageBox>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QTabBar>
#include <QTreeWidget>
#include <QtTest>
#include <stdexcept>

#include "workbench/SheetWidget.h"

namespace gt {
namespace {

constexpr int pollInterval = 20;  // ms
constexpr int imageWidth = 176;   // pixels, of a camera's image

/// A text without what only menus and buttons have.
QString plain(QString text) {
  return text.remove('&').remove(QStringLiteral("…"));
}

/// How well a name fits to a widget; 0: not at all.
int fit(const QWidget& widget, const QString& name) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  if (button && plain(button->text()) == plain(name)) return 4;
  if (widget.objectName() == name) return 3;
  if (const auto* form =
          widget.parentWidget() ? widget.parentWidget()->findChild<QFormLayout*>() : nullptr)
    if (const auto* label =
            qobject_cast<QLabel*>(form->labelForField(&const_cast<QWidget&>(widget)));
        label && label->text() == name)
      return 3;
  const auto* line = qobject_cast<const QLineEdit*>(&widget);
  if (line && !line->placeholderText().isEmpty() && line->placeholderText() == name) return 2;
  return !name.isEmpty() && widget.toolTip().startsWith(name, Qt::CaseInsensitive) ? 1 : 0;
}

bool canBeSeen(const QWidget& widget) {
  return widget.isVisible() && !widget.visibleRegion().isEmpty();
}

QPoint place(const QWidget& widget, const QPointF& share) {
  return {static_cast<int>(share.x() * widget.width()),
          static_cast<int>(share.y() * widget.height())};
}

/// Types into a field instead of what stands there.
void replace(QWidget& field, const QString& text) {
  field.setFocus();
  QTest::keySequence(&field, QKeySequence::SelectAll);
  QTest::keyClicks(&field, text);
}

}  // namespace

void waitUntil(const std::function<bool()>& holds, const QString& what, int seconds) {
  constexpr int msPerSecond = 1000;
  if (!QTest::qWaitFor(holds, seconds * msPerSecond)) fail(what);
}

Hand::Hand(MainWindow& window) : window_{window} {
  // An answer may raise the next question; a timer does not fire within its own slot.
  QObject::connect(&answering_, &QTimer::timeout, &window,
                   [this] { QTimer::singleShot(0, &answering_, [this] { answer(); }); });
  answering_.start(pollInterval);
}

void Hand::finishQuestions() {
  waitUntil([this] { return answers_.isEmpty() && !QApplication::activeModalWidget(); },
            "nothing asks for " + answers_.join(", "));
}

/// Answers what has come up.
void Hand::answer() {
  if (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
      menu && !path_.isEmpty())
    return choose(*menu, std::exchange(path_, {}));
  auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
  if (!dialog || answers_.isEmpty() || !dialog->isVisible()) return;
  QString text = answers_.takeFirst();
  if (auto* box = qobject_cast<QMessageBox*>(dialog)) {
    for (QAbstractButton* button : box->buttons())
      if (plain(button->text()) == text) {
        count(1);
        return QTest::mouseClick(button, Qt::LeftButton);
      }
    return dialog->reject();
  }
  if (qobject_cast<QFileDialog*>(dialog)) text = QDir::current().absoluteFilePath(text);
  auto* field = dialog->findChild<QLineEdit*>();
  if (!field) return dialog->reject();
  field->setText(text);  // typed, it would be completed
  ++texts_;
  QTest::keyClick(field, Qt::Key_Return);
}

Dialog& Hand::dialog(const QString& title) {
  Dialog* found = nullptr;
  for (QWidget* widget : window_.findChildren<QWidget*>()) {
    const QWidget* frame = widget->parentWidget();
    if (frame && frame->parentWidget() == &window_ && frame->windowTitle() == title)
      if (auto* known = dynamic_cast<Dialog*>(widget)) found = known;
  }
  if (!found) fail("the dialog " + title + " is not open");
  if (canBeSeen(*found)) return *found;
  for (QTabBar* bar : window_.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
    for (int i = 0; i < bar->count(); ++i)
      if (bar->tabText(i) == title) {
        count(1);
        QTest::mouseClick(bar, Qt::LeftButton, {}, bar->tabRect(i).center());
      }
  waitUntil([&] { return canBeSeen(*found); }, "the dialog " + title + " cannot be seen");
  return *found;
}

QWidget& Hand::find(const QString& thing, const QString& title) {
  Dialog& in = dialog(title);
  if (thing.isEmpty()) return in;
  QWidget* best = nullptr;
  const auto look = [&] {
    int most = 0;
    for (QWidget* widget : in.findChildren<QWidget*>())
      if (const int now = canBeSeen(*widget) ? fit(*widget, thing) : 0; now > most) {
        most = now;
        best = widget;
      }
    return best && best->isEnabled();
  };
  waitUntil(look, title + " shows nothing that is called " + thing + " and can be used", 10);
  return *best;
}

template <typename Widget>
Widget& Hand::find(const QString& thing, const QString& title) {
  QWidget& found = find(thing, title);
  if (auto* widget = dynamic_cast<Widget*>(&found)) return *widget;
  for (QWidget* part : found.findChildren<QWidget*>())
    if (auto* widget = dynamic_cast<Widget*>(part)) return *widget;
  fail(thing + " of " + title + " is something else");
}

void Hand::open(const QString& title) {
  for (const DialogType& type : Dialog::types())
    if (title == type.title) return chooseInMenuBar({"View", type.group, title});
  fail("there is no dialog " + title);
}

void Hand::chooseInMenuBar(const QStringList& path) {
  for (QAction* action : window_.menuBar()->actions())
    if (plain(action->text()) == path.first()) {
      count(1);
      QTest::mouseClick(window_.menuBar(), Qt::LeftButton, {},
                        window_.menuBar()->actionGeometry(action).center());
      waitUntil([&] { return action->menu()->isVisible(); }, path.first() + " does not open", 5);
      return choose(*action->menu(), path.mid(1));
    }
  fail("there is no menu " + path.first());
}

void Hand::choose(QMenu& menu, const QStringList& path) {
  for (QAction* action : menu.actions())
    if (plain(action->text()) == plain(path.first())) {
      if (!action->isEnabled()) break;
      count(1);
      const QPoint at = menu.actionGeometry(action).center();
      QTest::mouseMove(&menu, at);
      QTest::mouseClick(&menu, Qt::LeftButton, {}, at);
      if (path.size() == 1) return;
      waitUntil([&] { return action->menu() && action->menu()->isVisible(); },
                path.first() + " does not open", 5);
      return choose(*action->menu(), path.mid(1));
    }
  while (QWidget* open = QApplication::activePopupWidget()) open->close();
  fail("the menu has no entry " + path.first() + " that can be chosen");
}

void Hand::chooseInContextMenu(const QStringList& path, const QString& title, const QString& thing,
                               const QPointF& at) {
  QWidget& target = find(thing, title);
  QWidget* child = target.childAt(place(target, at));
  QWidget& under = child ? *child : target;
  const QPoint point = under.mapFrom(&target, place(target, at));
  count(1);
  path_ = path;
  QContextMenuEvent event{QContextMenuEvent::Mouse, point, under.mapToGlobal(point)};
  QApplication::sendEvent(&under, &event);
  waitUntil([this] { return path_.isEmpty() && !QApplication::activePopupWidget(); },
            title + " has no context menu there", 5);
}

void Hand::click(const QString& thing, const QString& title) {
  auto& button = find<QAbstractButton>(thing, title);
  count(1);
  QTest::mouseClick(&button, Qt::LeftButton, {},
                    button.isCheckable() ? QPoint{8, button.height() / 2} : QPoint{});
}

void Hand::clickPixel(const QPoint& pixel, const QString& thing, const QString& title,
                      Qt::MouseButton button) {
  auto& sheet = find<SheetWidget>(thing, title);
  waitUntil([&] { return sheet.sheet() != nullptr; }, title + " shows no image");
  const double scale = static_cast<double>(sheet.sheet()->width()) / imageWidth;
  const QPointF origin = sheet.toSheet({0, 0}), unit = sheet.toSheet({1, 1}) - origin;
  const QPointF wanted = scale * (QPointF{pixel} + QPointF{0.5, 0.5}) - origin;
  count(1);
  QTest::mouseClick(&sheet, button, {},
                    QPointF{wanted.x() / unit.x(), wanted.y() / unit.y()}.toPoint());
}

void Hand::choose(const QString& entry, const QString& thing, const QString& title) {
  auto& box = find<QComboBox>(thing, title);
  const auto index = [&] {
    const int exact = box.findText(entry);
    return exact >= 0 ? exact : box.findText(entry + " *");  // the configuration's solution
  };
  waitUntil([&] { return index() >= 0; }, thing + " has no entry " + entry);
  count(2);
  QTest::mouseClick(&box, Qt::LeftButton, {}, {box.width() - 8, box.height() / 2});
  waitUntil([&] { return box.view()->isVisible(); }, thing + " does not open", 5);
  // By keys, for a long list scrolls under the pointer.
  box.view()->setCurrentIndex(box.model()->index(index(), box.modelColumn()));
  QTest::keyClick(box.view(), Qt::Key_Return);
  waitUntil([&] { return !box.view()->isVisible(); }, entry + " is not chosen", 5);
}

void Hand::type(const QString& text, const QString& thing, const QString& title) {
  QWidget& found = find(thing, title);
  count(1);
  ++texts_;
  QTest::mouseClick(&found, Qt::LeftButton, {}, {8, found.height() / 2});
  if (auto* lines = qobject_cast<QPlainTextEdit*>(&found)) return replace(*lines, text);
  replace(found, text);
  QTest::keyClick(&found, Qt::Key_Return);
}

namespace {

/// A visible line of a tree by its text, or by "GROUP > TEXT"; null if there is none.
QTreeWidgetItem* lineOf(const QTreeWidget& tree, const QString& text) {
  for (QTreeWidgetItem* item :
       tree.findItems(text.section(" > ", -1), Qt::MatchExactly | Qt::MatchRecursive, 0)) {
    const QString group = text.contains(" > ") ? text.section(" > ", 0, 0) : QString{};
    if (item->isHidden() || !item->parent() ||
        (!group.isEmpty() && item->parent()->text(0) != group))
      continue;
    return item;
  }
  return nullptr;
}

}  // namespace

void Hand::expand(const QString& text, const QString& title) {
  auto& tree = find<QTreeWidget>("", title);
  waitUntil([&] { return lineOf(tree, text) != nullptr; }, title + " has no line " + text);
  QTreeWidgetItem* const item = lineOf(tree, text);
  tree.scrollToItem(item);
  const QRect line = tree.visualItemRect(item);
  count(1);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {},
                    {line.left() - tree.indentation() / 2, line.center().y()});
  if (!item->isExpanded()) fail(text + " is not opened");
}

void Hand::edit(const QString& text, const QString& value, const QString& title) {
  auto& tree = find<QTreeWidget>("", title);
  waitUntil([&] { return lineOf(tree, text) != nullptr; }, title + " has no line " + text);
  tree.scrollToItem(lineOf(tree, text));
  const QRect line = tree.visualItemRect(lineOf(tree, text));
  const QPoint at{tree.columnViewportPosition(1) + 8, line.center().y()};
  count(2);
  QTest::mouseClick(tree.viewport(), Qt::LeftButton, {}, at);
  QTest::mouseDClick(tree.viewport(), Qt::LeftButton, {}, at);
  QLineEdit* field = nullptr;
  waitUntil([&] { return (field = tree.viewport()->findChild<QLineEdit*>()) != nullptr; },
            text + " cannot be changed", 5);
  ++texts_;
  replace(*field, value);
  QTest::keyClick(field, Qt::Key_Return);
  waitUntil([&] { return tree.viewport()->findChild<QLineEdit*>() == nullptr; },
            text + " is still being changed", 5);
}

void Hand::drag(const QPointF& from, const QPointF& to, const QString& thing,
                const QString& title) {
  QWidget& whole = find(thing, title);
  QWidget* child = whole.childAt(place(whole, from));
  QWidget& target = child ? *child : whole;
  const auto at = [&](const QPointF& share) { return target.mapFrom(&whole, place(whole, share)); };
  count(1);
  QTest::mousePress(&target, Qt::LeftButton, {}, at(from));
  constexpr int steps = 4, pause = 30;  // ms
  for (int i = 1; i <= steps; ++i) {
    QTest::qWait(pause);
    QTest::mouseMove(&target, at(from + (to - from) * i / steps));
  }
  QTest::qWait(pause);
  QTest::mouseRelease(&target, Qt::LeftButton, {}, at(to));
}

QStringList Hand::texts(const QString& title) {
  QStringList all;
  Dialog& in = dialog(title);
  for (const auto* label : in.findChildren<QLabel*>())
    if (canBeSeen(*label)) all << label->text();
  for (const QWidget* part : in.findChildren<QWidget*>())
    if (const auto* sheet = dynamic_cast<const SheetWidget*>(part); sheet && canBeSeen(*sheet))
      all << sheet->text();
  for (const auto* lines : in.findChildren<QPlainTextEdit*>())
    if (canBeSeen(*lines)) all << lines->toPlainText();
  for (const auto* tree : in.findChildren<QTreeWidget*>())
    for (int i = 0; i < tree->topLevelItemCount(); ++i) {
      QStringList row;
      for (int column = 0; column < tree->columnCount(); ++column)
        row << tree->topLevelItem(i)->text(column);
      all << row.join(' ');
    }
  return all;
}

}  // namespace gt
