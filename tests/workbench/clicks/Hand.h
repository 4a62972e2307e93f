#pragma once
#include <QList>
#include <QPoint>
#include <QPointer>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <functional>
#include <stdexcept>

#include "workbench/MainWindow.h"

class QMenu;

namespace gt {

/// What a page says cannot be done or is not there.
[[noreturn]] inline void fail(const QString& what) {
  throw std::runtime_error{what.toStdString()};
}

/// Uses the workbench as a person does: finds things by what is written on or beside them, presses
/// mouse buttons and keys, and counts that. Throws std::runtime_error if something cannot be found
/// or seen.
class Hand {
 public:
  explicit Hand(MainWindow& window);

  /// Mouse clicks, and texts that were typed, so far.
  int clicks() const { return clicks_; }
  int texts() const { return texts_; }

  /// What is answered to the questions (files, names, Save or Discard) that the next action raises.
  void expectQuestions(const QStringList& answers) { answers_ = answers; }
  /// Waits until all of them were raised.
  void finishQuestions();

  /// Chooses a dialog's entry in the menu View.
  void open(const QString& title);
  /// Chooses an entry of the menu bar, as {"File", "Open log…"}.
  void chooseInMenuBar(const QStringList& path);
  /// Chooses an entry of a context menu, at a share of a thing's width and height.
  void chooseInContextMenu(const QStringList& path, const QString& title, const QString& thing,
                           const QPointF& at);
  /// Clicks on a button or box with a tick.
  void click(const QString& thing, const QString& title);
  /// Clicks on a pixel of the camera's image where an image is shown.
  void clickPixel(const QPoint& pixel, const QString& thing, const QString& title,
                  Qt::MouseButton button);
  /// Chooses an entry of a box.
  void choose(const QString& entry, const QString& thing, const QString& title);
  /// Types into a field, and presses the Enter key.
  void type(const QString& text, const QString& thing, const QString& title);
  /// Opens a group of a tree.
  void expand(const QString& item, const QString& title);
  /// Changes a value of a tree in place.
  void edit(const QString& item, const QString& value, const QString& title);
  /// Drags from one place to another: shares of a thing's width and height.
  void drag(const QPointF& from, const QPointF& to, const QString& thing, const QString& title);

  /// The open dialog with a title. It is brought to the front by a click on its tab if others lie
  /// before it.
  Dialog& dialog(const QString& title);
  /// What a dialog says: the texts that can be read in it.
  QStringList texts(const QString& title);

 private:
  void count(int clicks) { clicks_ += clicks; }
  QWidget& find(const QString& thing, const QString& title);
  template <typename Widget>
  Widget& find(const QString& thing, const QString& title);
  void choose(QMenu& menu, const QStringList& path);
  void answer();

  MainWindow& window_;
  QStringList answers_, path_;  ///< For questions and context menus that come up.
  QTimer answering_;
  int clicks_ = 0, texts_ = 0;
};

/// Handles events until something holds; throws with the text if it never does.
void waitUntil(const std::function<bool()>& holds, const QString& what, int seconds = 30);

}  // namespace gt
