#include "workbench/Docks.h"

#include <QCloseEvent>
#include <QJsonArray>
#include <QTabBar>
#include <QTimer>
#include <QToolBar>
#include <algorithm>

namespace gt {
namespace {

constexpr int arrangementVersion = 1;

Qt::DockWidgetArea areaOf(DialogPlace place) {
  switch (place) {
    case DialogPlace::left:
      return Qt::LeftDockWidgetArea;
    case DialogPlace::right:
      return Qt::RightDockWidgetArea;
    case DialogPlace::center:
      return Qt::TopDockWidgetArea;
    default:
      return Qt::BottomDockWidgetArea;
  }
}

/// A dock that asks before it is closed with something that was not saved.
class Dock : public QDockWidget {
 public:
  Dock(const QString& title, QWidget* parent, Dialog& dialog)
      : QDockWidget{title, parent}, dialog_{dialog} {
    setAttribute(Qt::WA_DeleteOnClose);
    setWidget(&dialog);
  }

 protected:
  void closeEvent(QCloseEvent* event) override {
    std::vector<Unsaved> unsaved;
    if (auto one = dialog_.unsaved()) unsaved.push_back(std::move(*one));
    event->setAccepted(mayDiscard(this, unsaved));
  }

 private:
  Dialog& dialog_;
};

/// Brings a dock before those that share its place.
void raiseDock(QMainWindow& window, QDockWidget* dock) {
  dock->raise();
  // A dock that lies over its siblings anyway is not raised by Qt, although its tab may be behind.
  for (QTabBar* bar : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
    for (int i = 0; i < bar->count(); ++i)
      if (bar->tabText(i) == dock->windowTitle()) bar->setCurrentIndex(i);
}

}  // namespace

QString helpOf(const DialogType& type) {
  const QString help = QString{type.help};
  return *type.report ? help + " (report " + type.report + ")" : help;
}

Dialog* Docks::dialog(const QString& key) const {
  const auto found = dialogs_.find(key);
  return found == dialogs_.end() ? nullptr : found->second.data();
}

Dialog* Docks::create(const DialogType& type, const QString& key) {
  Dialog* dialog = type.make(session_);
  dialog->setObjectName(key);
  const QString number = key.section('#', 1);
  const QString title = number.isEmpty() ? type.title : QString{type.title} + " " + number;
  dialogs_[key] = dialog;
  if (type.place == DialogPlace::toolbar) {
    auto* bar = new QToolBar{title, &window_};
    bar->setObjectName("toolbar." + key);
    bar->addWidget(dialog);
    bar->setToolTip(helpOf(type));
    // In a row of its own: what does not fit into a row makes the window wider than the screen.
    if (!type.atFirst) window_.addToolBarBreak();
    window_.addToolBar(bar);
    frames_[key] = bar;
    return dialog;
  }
  auto* dock = new Dock{title, &window_, *dialog};
  dock->setObjectName("dock." + key);
  dock->setToolTip(helpOf(type));
  dialog->setToolTip({});
  frames_[key] = dock;
  return dialog;
}

/// Gives a dock that was just made a place: with others of its kind, if there are any.
void Docks::place(const DialogType& type, const QString& key) {
  auto* const dock = qobject_cast<QDockWidget*>(frames_[key].data());
  if (!dock) return;
  window_.addDockWidget(areaOf(type.place), dock);
  for (const auto& [other, frame] : frames_) {
    auto* const beside = qobject_cast<QDockWidget*>(frame.data());
    const DialogType* const known = Dialog::typeOf(other);
    if (beside && beside != dock && !beside->isFloating() && known && known->place == type.place)
      return window_.tabifyDockWidget(beside, dock);
  }
}

void Docks::bringToFront(const QString& key) {
  const auto found = frames_.find(key);
  if (found == frames_.end() || !found->second) return;
  found->second->show();
  auto* dock = qobject_cast<QDockWidget*>(found->second.data());
  if (!dock) return;
  raiseDock(window_, dock);
  // Of a dock that was just made the tab comes with the next events.
  QTimer::singleShot(0, dock, [&window = window_, dock] { raiseDock(window, dock); });
}

Dialog* Docks::open(const QString& id) {
  const DialogType* type = Dialog::typeOf(id);
  if (!type) return nullptr;
  Dialog* known = dialog(id);
  QString key = id;
  if (known && type->several)
    for (int number = 2; known; ++number) {
      key = id + "#" + QString::number(number);
      known = dialog(key);
    }
  if (!known) {
    known = create(*type, key);
    place(*type, key);
  }
  bringToFront(key);
  return known;
}

void Docks::refresh() {
  std::erase_if(dialogs_, [](const auto& entry) { return !entry.second; });
  std::erase_if(frames_, [](const auto& entry) { return !entry.second; });
  // A dialog may open or close others.
  const auto open = dialogs_;
  for (const auto& [key, dialog] : open)
    if (dialog && dialog->isVisible() && !dialog->visibleRegion().isEmpty()) dialog->refresh();
}

void Docks::closeAll() {
  for (const auto& [key, frame] : frames_) delete frame.data();
  frames_.clear();
  dialogs_.clear();
}

std::vector<Unsaved> Docks::unsaved() const {
  std::vector<Unsaved> all;
  for (const auto& [key, dialog] : dialogs_)
    if (dialog)
      if (auto one = dialog->unsaved()) all.push_back(std::move(*one));
  return all;
}

// Arrangements.

QJsonObject Docks::arrangement() const {
  QJsonArray open;
  for (const auto& [key, dialog] : dialogs_)
    if (dialog) open.append(QJsonObject{{"dialog", key}, {"settings", dialog->settings()}});
  return {{"version", arrangementVersion},
          {"dialogs", open},
          {"geometry", QString::fromLatin1(window_.saveGeometry().toBase64())},
          {"state", QString::fromLatin1(window_.saveState(arrangementVersion).toBase64())}};
}

Result<void> Docks::arrange(const QJsonObject& arrangement) {
  if (arrangement["version"].toInt() != arrangementVersion || !arrangement["dialogs"].isArray()) {
    arrangeAtFirst();
    return Error{.field = "layout", .what = "is none of this version; the first one is shown"};
  }
  closeAll();
  QStringList keys;
  for (const QJsonValue entry : arrangement["dialogs"].toArray()) {
    const QString key = entry["dialog"].toString();
    const DialogType* type = Dialog::typeOf(key);
    if (!type || dialog(key)) continue;  // of another program's version
    create(*type, key)->restore(entry["settings"].toObject());
    keys << key;
  }
  addMissingToolbars();
  if (!arrangement["state"].isString()) {
    arrangeByPlaces(keys);
    return {};
  }
  for (const QString& key : keys) place(*Dialog::typeOf(key), key);
  const auto bytes = [&](const char* name) {
    return QByteArray::fromBase64(arrangement[name].toString().toLatin1());
  };
  window_.restoreGeometry(bytes("geometry"));
  window_.restoreState(bytes("state"), arrangementVersion);
  return {};
}

void Docks::arrangeAtFirst() {
  closeAll();
  QStringList keys;
  for (const DialogType& type : Dialog::types()) {
    if (!type.atFirst) continue;
    create(type, type.id);
    // Field and image come before scene and behavior, the console before the plots.
    keys.insert(type.place == DialogPlace::bottom ? keys.size() : 0, type.id);
  }
  addMissingToolbars();
  arrangeByPlaces(keys);
}

/// Toolbars that an arrangement does not name are there, too, so that they can be switched on.
void Docks::addMissingToolbars() {
  for (const DialogType& type : Dialog::types())
    if (type.place == DialogPlace::toolbar && !dialog(type.id)) {
      create(type, type.id);
      frames_[type.id]->hide();
    }
}

/// Three columns, of which the middle one has what is in the center above what is at the bottom;
/// on the right, the first is above the others.
void Docks::arrangeByPlaces(const QStringList& keys) {
  std::map<DialogPlace, QList<QPointer<QDockWidget>>> docks;
  for (const QString& key : keys)
    if (auto* dock = qobject_cast<QDockWidget*>(frames_[key].data()))
      docks[Dialog::typeOf(key)->place] << dock;
  QList<QDockWidget*> columns;
  for (const DialogPlace place : {DialogPlace::left, DialogPlace::center, DialogPlace::right})
    if (!docks[place].isEmpty()) columns << docks[place].first();
  for (QDockWidget* column : columns) {
    window_.addDockWidget(Qt::TopDockWidgetArea, column);
    if (column != columns.front())
      window_.splitDockWidget(columns[columns.indexOf(column) - 1], column, Qt::Horizontal);
  }
  const auto addBelow = [&](DialogPlace place, QDockWidget* below) {
    if (docks[place].isEmpty())
      window_.addDockWidget(Qt::BottomDockWidgetArea, below);
    else
      window_.splitDockWidget(docks[place].first(), below, Qt::Vertical);
  };
  const auto tabify = [&](const QList<QPointer<QDockWidget>>& list) {
    for (qsizetype i = 1; i < list.size(); ++i) window_.tabifyDockWidget(list[i - 1], list[i]);
  };
  if (!docks[DialogPlace::bottom].isEmpty())
    addBelow(DialogPlace::center, docks[DialogPlace::bottom].first());
  if (auto others = docks[DialogPlace::right]; others.size() > 1) {
    others.removeFirst();
    addBelow(DialogPlace::right, others.first());
    tabify(others);
  }
  for (const DialogPlace place : {DialogPlace::left, DialogPlace::center, DialogPlace::bottom})
    tabify(docks[place]);
  // Places have their sizes once the window has its own.
  QTimer::singleShot(0, &window_, [&window = window_, docks]() mutable {
    for (const auto& [place, list] : docks)
      for (const QPointer<QDockWidget>& dock : list)
        if (!dock) return;  // another arrangement was chosen meanwhile
    const auto resize = [&](std::initializer_list<std::pair<DialogPlace, double>> shares,
                            Qt::Orientation orientation) {
      const int whole = orientation == Qt::Horizontal ? window.width() : window.height();
      QList<QDockWidget*> list;
      QList<int> sizes;
      for (const auto& [place, share] : shares)
        if (!docks[place].isEmpty()) {
          list << docks[place].first();
          sizes << static_cast<int>(share * whole);
        }
      window.resizeDocks(list, sizes, orientation);
    };
    resize({{DialogPlace::left, 0.22}, {DialogPlace::center, 0.46}, {DialogPlace::right, 0.32}},
           Qt::Horizontal);
    resize({{DialogPlace::center, 0.62}, {DialogPlace::bottom, 0.38}}, Qt::Vertical);
    for (const auto& [place, list] : docks)
      if (!list.isEmpty()) raiseDock(window, list.first());
  });
}

}  // namespace gt
