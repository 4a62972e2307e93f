#include "workbench/MainWindow.h"

#include <QAction>
#include <QActionGroup>
#include <QApplication>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QJsonArray>
#include <QMenuBar>
#include <QMessageBox>
#include <QStatusBar>
#include <QTabBar>
#include <QToolBar>
#include <algorithm>
#include <set>

#include "views/ViewText.h"
#include "workbench/CommandPalette.h"

namespace gt {
namespace {

constexpr int refreshInterval = 40;  // ms
constexpr int messageTime = 8000;    // ms
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

/// Brings a dock before those that share its place.
void raiseDock(QMainWindow& window, QDockWidget* dock) {
  dock->raise();
  // A dock that lies over its siblings anyway is not raised by Qt, although its tab may be behind.
  for (QTabBar* bar : window.findChildren<QTabBar*>(Qt::FindDirectChildrenOnly))
    for (int i = 0; i < bar->count(); ++i)
      if (bar->tabText(i) == dock->windowTitle()) bar->setCurrentIndex(i);
}

QString helpOf(const DialogType& type) {
  const QString help = QString{type.help};
  return *type.report ? help + " (report " + type.report + ")" : help;
}

const DialogType* typeOf(const std::vector<DialogType>& types, const QString& id) {
  const auto found =
      std::ranges::find_if(types, [&](const DialogType& type) { return id == type.id; });
  return found == types.end() ? nullptr : &*found;
}

}  // namespace

MainWindow::MainWindow(SessionThread& session, const QString& folder)
    : session_{session}, layouts_{folder} {
  setWindowTitle("RobotControl");
  resize(1280, 760);
  setDockNestingEnabled(true);
  // No GroupedDragging: Qt 6.4 crashes when it restores a state over a group that floats.
  setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
  setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
  // Docks fill the whole window.
  auto* nothing = new QWidget;
  nothing->setMaximumSize(0, 0);
  setCentralWidget(nothing);
  nothing->hide();

  for (QLabel** label : {&robotLabel_, &timeLabel_, &gameLabel_, &busyLabel_}) {
    *label = new QLabel;
    statusBar()->addWidget(*label);
  }
  logLabel_ = new QLabel;
  statusBar()->addPermanentWidget(logLabel_);
  robotLabel_->setObjectName("status.robot");
  timeLabel_->setObjectName("status.time");
  logLabel_->setObjectName("status.log");

  addMenus();
  showTheme(layouts_.setting("theme").toString() == "dark" ? Theme::dark : Theme::light);
  scene_ = QFileInfo{QString::fromStdString(session_.status().scene)}.fileName();
  QString layout = layouts_.ofScene(scene_);
  if (layout.isEmpty()) layout = layouts_.current();
  if (layout.isEmpty())
    arrangeAtFirst();
  else
    report(chooseLayout(layout));
  QObject::connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(refreshInterval);
}

void MainWindow::report(const Result<void>& done) {
  if (!done) statusBar()->showMessage(QString::fromStdString(done.error().text()), messageTime);
}

// Menus.

void MainWindow::addMenus() {
  QMenu* file = menuBar()->addMenu("&File");
  file->addAction("Open &scene…", QKeySequence::Open, this, [this] { openScene(); });
  file->addAction("Open &log…", QKeySequence{"Ctrl+L"}, this, [this] { openLog(); });
  file->addAction("Run s&cript…", this, [this] {
    const QString script =
        QFileDialog::getOpenFileName(this, "Run a script", "scenes", "Console scripts (*.con)");
    if (!script.isEmpty()) session_.execute("call \"" + script.toStdString() + "\"");
  });
  file->addSeparator();
  file->addAction("&Save state…", QKeySequence::Save, this, [this] {
    const QString state = QFileDialog::getSaveFileName(
        this, "Save the simulation's state", "out/states/match.state", "States (*.state)");
    if (!state.isEmpty()) session_.execute("save \"" + state.toStdString() + "\"");
  });
  file->addAction("L&oad state…", this, [this] {
    const QString state =
        QFileDialog::getOpenFileName(this, "Load a state", "out/states", "States (*.state)");
    if (!state.isEmpty()) session_.execute("load \"" + state.toStdString() + "\"");
  });
  file->addSeparator();
  file->addAction("Save &picture of the window…", this, [this] {
    const QString picture =
        QFileDialog::getSaveFileName(this, "Save a picture", "window.png", "Images (*.png)");
    if (!picture.isEmpty()) grab().save(picture);
  });
  file->addAction("&Quit", QKeySequence::Quit, this, [this] { close(); });

  QMenu* simulation = menuBar()->addMenu("&Simulation");
  QAction* start = simulation->addAction("&Start or pause", QKeySequence{"F5"}, this, [this] {
    if (session_.busy())
      session_.interrupt();
    else
      session_.execute(session_.status().started ? "stop" : "start");
  });
  start->setToolTip("Lets simulated time pass, or stand");
  simulation->addAction("S&tep", QKeySequence{"F10"}, this, [this] { session_.execute("step"); });
  simulation->addAction("&Reset", QKeySequence{"Ctrl+F5"}, this,
                        [this] { session_.execute("reset"); });
  simulation->addAction("Stop the &command that is executed", QKeySequence{"Shift+F5"}, this,
                        [this] { session_.interrupt(); });

  addViewMenu();

  QMenu* robots = menuBar()->addMenu("&Robots");
  QObject::connect(robots, &QMenu::aboutToShow, this, [this, robots] { fillRobotMenu(*robots); });

  QMenu* layouts = menuBar()->addMenu("&Layouts");
  fillLayoutMenu(*layouts);
  QObject::connect(layouts, &QMenu::aboutToShow, this,
                   [this, layouts] { fillLayoutMenu(*layouts); });

  QMenu* help = menuBar()->addMenu("&Help");
  help->addAction("&Find a command…", QKeySequence{"Ctrl+Shift+P"}, this,
                  [this] { showPalette(); });
  help->addAction("Commands of the &console", this, [this] {
    open("console");
    session_.execute("help");
  });
  help->addAction("&About", this, [this] {
    QMessageBox::about(this, "RobotControl",
                       "The workbench for robots of the simulator, on logs and elsewhere.\n"
                       "docs/robotcontrol.md describes it.");
  });
}

void MainWindow::addViewMenu() {
  QMenu* view = menuBar()->addMenu("&View");
  view->setToolTipsVisible(true);
  std::map<QString, QMenu*> groups;
  for (const DialogType& type : Dialog::types()) {
    QMenu*& group = groups[type.group];
    if (!group) {
      group = view->addMenu(type.group);
      group->setToolTipsVisible(true);
    }
    const QString id = type.id;
    QAction* action = group->addAction(type.title, this, [this, id] { open(id); });
    action->setObjectName("view." + id);
    action->setToolTip(helpOf(type));
    action->setStatusTip(helpOf(type));
  }
  view->addSeparator();
  auto* themes = new QActionGroup{this};
  for (const auto& [name, theme] : {std::pair{"Light", Theme::light}, {"Dark", Theme::dark}}) {
    QAction* action = view->addAction(name, this, [this, chosen = theme] { showTheme(chosen); });
    action->setObjectName(QString{"theme."} + name);
    action->setCheckable(true);
    action->setActionGroup(themes);
    action->setChecked((layouts_.setting("theme").toString() == "dark") == (theme == Theme::dark));
  }
}

void MainWindow::showTheme(Theme theme) {
  setTheme(theme);
  layouts_.set("theme", theme == Theme::dark ? "dark" : "light");
}

void MainWindow::fillRobotMenu(QMenu& menu) {
  menu.clear();
  const SessionStatus status = session_.status();
  auto* group = new QActionGroup{&menu};
  const auto add = [&](const QString& text, const std::string& name, bool checked) {
    QAction* action =
        menu.addAction(text, this, [this, name] { session_.execute("robot " + name); });
    action->setCheckable(true);
    action->setChecked(checked);
    action->setActionGroup(group);
  };
  const auto selected = std::ranges::count_if(status.robots, &RobotInfo::selected);
  for (const RobotInfo& robot : status.robots)
    add(QString::fromStdString(robot.name) + (robot.onLog     ? " (log)"
                                              : robot.inScene ? ""
                                                              : " (elsewhere)"),
        robot.name, selected == 1 && robot.selected);
  add("All robots", "all", selected > 1);
  menu.addSeparator();
  menu.addAction("Connect to robots elsewhere…", this, [this] {
    const QString robots = QInputDialog::getText(
        this, "Connect", "Addresses, or NAME=ENDPOINT, as in the console command sc:");
    if (!robots.isEmpty()) session_.execute("sc " + robots.toStdString());
  });
}

void MainWindow::fillLayoutMenu(QMenu& menu) {
  menu.clear();
  auto* group = new QActionGroup{&menu};
  for (const QString& name : layouts_.names()) {
    QAction* action = menu.addAction(name, this, [this, name] { report(chooseLayout(name)); });
    action->setCheckable(true);
    action->setChecked(name == layouts_.current());
    action->setActionGroup(group);
  }
  menu.addSeparator();
  const QString current = layouts_.current();
  QAction* save = menu.addAction("&Save", this, [this, current] { report(saveLayout(current)); });
  menu.addAction("Save &as…", this, [this] {
    const QString name = QInputDialog::getText(this, "Save the layout", "Name:");
    if (!name.isEmpty()) report(saveLayout(name));
  });
  QAction* rename = menu.addAction("&Rename…", this, [this, current] {
    const QString name =
        QInputDialog::getText(this, "Rename the layout", "Name:", QLineEdit::Normal, current);
    if (!name.isEmpty()) report(layouts_.rename(current, name));
  });
  QAction* remove = menu.addAction("&Delete", this, [this, current] {
    if (QMessageBox::question(this, "Delete", "Delete the layout " + current + "?") ==
        QMessageBox::Yes)
      report(layouts_.remove(current));
  });
  QAction* ofScene = menu.addAction("Use for the scene " + scene_);
  ofScene->setCheckable(true);
  ofScene->setChecked(!current.isEmpty() && layouts_.ofScene(scene_) == current);
  QObject::connect(ofScene, &QAction::toggled, this, [this, current](bool on) {
    layouts_.setOfScene(scene_, on ? current : QString{});
  });
  for (QAction* action : {save, rename, remove, ofScene}) action->setEnabled(!current.isEmpty());
  menu.addSeparator();
  menu.addAction("As at the &first start", this, [this] {
    layouts_.setCurrent({});
    arrangeAtFirst();
  });
}

void MainWindow::openScene() {
  const QString scene = QFileDialog::getOpenFileName(
      this, "Open a scene", QFileInfo{QString::fromStdString(session_.status().scene)}.path(),
      "Scenes (*.scene)");
  if (!scene.isEmpty()) session_.execute("scene \"" + scene.toStdString() + "\"");
}

void MainWindow::openLog() {
  const QString log =
      QFileDialog::getOpenFileName(this, "Open a log", "out/logs", "Logs (*.mcap *.log);;All (*)");
  if (log.isEmpty()) return;
  const std::string name =
      "log-" + QFileInfo{log}.completeBaseName().replace(' ', '_').toStdString();
  session_.execute("sl " + name + " \"" + log.toStdString() + "\"",
                   [this, name](const Result<void>& done) {
                     if (!done) return report(done);
                     session_.execute("robot " + name);
                     open("logPlayer");
                   });
}

QList<QAction*> MainWindow::commands() const {
  QList<QAction*> all;
  const std::function<void(const QMenu&)> collect = [&](const QMenu& menu) {
    for (QAction* action : menu.actions()) {
      if (const QMenu* part = action->menu())
        collect(*part);
      else if (!action->isSeparator() && action->isEnabled())
        all << action;
    }
  };
  for (const QAction* action : menuBar()->actions())
    if (const QMenu* menu = action->menu()) collect(*menu);
  return all;
}

void MainWindow::showPalette() {
  for (const QAction* action : menuBar()->actions())
    if (QMenu* menu = action->menu()) Q_EMIT menu->aboutToShow();
  CommandPalette palette{this, commands(), session_};
  palette.exec();
}

// Dialogs.

Dialog* MainWindow::dialog(const QString& key) const {
  const auto found = dialogs_.find(key);
  return found == dialogs_.end() ? nullptr : found->second.data();
}

Dialog* MainWindow::create(const DialogType& type, const QString& key) {
  Dialog* dialog = type.make(session_);
  dialog->setObjectName(key);
  const QString number = key.section('#', 1);
  const QString title = number.isEmpty() ? type.title : QString{type.title} + " " + number;
  dialogs_[key] = dialog;
  if (type.place == DialogPlace::toolbar) {
    auto* bar = new QToolBar{title, this};
    bar->setObjectName("toolbar." + key);
    bar->addWidget(dialog);
    bar->setToolTip(helpOf(type));
    addToolBar(bar);
    frames_[key] = bar;
    return dialog;
  }
  auto* dock = new QDockWidget{title, this};
  dock->setObjectName("dock." + key);
  dock->setAttribute(Qt::WA_DeleteOnClose);
  dock->setToolTip(helpOf(type));
  dialog->setToolTip({});
  dock->setWidget(dialog);
  frames_[key] = dock;
  return dialog;
}

/// Gives a dock that was just made a place: with others of its kind, if there are any.
void MainWindow::place(const DialogType& type, const QString& key) {
  auto* const dock = qobject_cast<QDockWidget*>(frames_[key].data());
  if (!dock) return;
  const auto types = Dialog::types();
  addDockWidget(areaOf(type.place), dock);
  for (const auto& [other, frame] : frames_) {
    auto* const beside = qobject_cast<QDockWidget*>(frame.data());
    const DialogType* const known = typeOf(types, other.section('#', 0, 0));
    if (beside && beside != dock && !beside->isFloating() && known && known->place == type.place)
      return tabifyDockWidget(beside, dock);
  }
}

void MainWindow::bringToFront(const QString& key) {
  const auto found = frames_.find(key);
  if (found == frames_.end() || !found->second) return;
  found->second->show();
  auto* dock = qobject_cast<QDockWidget*>(found->second.data());
  if (!dock) return;
  raiseDock(*this, dock);
  // Of a dock that was just made the tab comes with the next events.
  QTimer::singleShot(0, dock, [this, dock] { raiseDock(*this, dock); });
}

Dialog* MainWindow::open(const QString& id) {
  const auto types = Dialog::types();
  const DialogType* type = typeOf(types, id);
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

void MainWindow::closeAll() {
  for (const auto& [key, frame] : frames_) delete frame.data();
  frames_.clear();
  dialogs_.clear();
}

// Layouts.

QJsonObject MainWindow::arrangement() const {
  QJsonArray open;
  for (const auto& [key, dialog] : dialogs_)
    if (dialog) open.append(QJsonObject{{"dialog", key}, {"settings", dialog->settings()}});
  return {{"version", arrangementVersion},
          {"dialogs", open},
          {"geometry", QString::fromLatin1(saveGeometry().toBase64())},
          {"state", QString::fromLatin1(saveState(arrangementVersion).toBase64())}};
}

Result<void> MainWindow::arrange(const QJsonObject& arrangement) {
  if (arrangement["version"].toInt() != arrangementVersion || !arrangement["dialogs"].isArray()) {
    arrangeAtFirst();
    return Error{.field = "layout", .what = "is none of this version; the first one is shown"};
  }
  closeAll();
  const auto types = Dialog::types();
  for (const QJsonValue entry : arrangement["dialogs"].toArray()) {
    const QString key = entry["dialog"].toString();
    const DialogType* type = typeOf(types, key.section('#', 0, 0));
    if (!type || dialog(key)) continue;  // of another program's version
    create(*type, key)->restore(entry["settings"].toObject());
    place(*type, key);
  }
  // Toolbars that are not named are there, too, so that they can be switched on.
  for (const DialogType& type : types)
    if (type.place == DialogPlace::toolbar && !dialog(type.id)) {
      create(type, type.id);
      frames_[type.id]->hide();
    }
  const auto bytes = [&](const char* name) {
    return QByteArray::fromBase64(arrangement[name].toString().toLatin1());
  };
  restoreGeometry(bytes("geometry"));
  restoreState(bytes("state"), arrangementVersion);
  return {};
}

void MainWindow::arrangeAtFirst() {
  closeAll();
  std::map<DialogPlace, QList<QPointer<QDockWidget>>> docks;
  for (const DialogType& type : Dialog::types()) {
    const bool bar = type.place == DialogPlace::toolbar;
    if (!type.atFirst && !bar) continue;
    create(type, type.id);
    if (bar)
      frames_[type.id]->setVisible(type.atFirst);
    else
      docks[type.place] << qobject_cast<QDockWidget*>(frames_[type.id].data());
  }
  // Three columns, of which the middle one has what is in the center above what is at the bottom;
  // on the right, what a robot sees is above the others.
  QList<QDockWidget*> columns;
  for (const DialogPlace place : {DialogPlace::left, DialogPlace::center, DialogPlace::right})
    if (!docks[place].isEmpty()) columns << docks[place].last();
  for (QDockWidget* column : columns) {
    addDockWidget(Qt::TopDockWidgetArea, column);
    if (column != columns.front())
      splitDockWidget(columns[columns.indexOf(column) - 1], column, Qt::Horizontal);
  }
  const auto addBelow = [&](DialogPlace place, QDockWidget* below) {
    if (!docks[place].isEmpty()) splitDockWidget(docks[place].last(), below, Qt::Vertical);
  };
  const auto tabify = [&](QList<QPointer<QDockWidget>> list) {
    for (qsizetype i = 1; i < list.size(); ++i) tabifyDockWidget(list[i - 1], list[i]);
  };
  if (!docks[DialogPlace::bottom].isEmpty())
    addBelow(DialogPlace::center, docks[DialogPlace::bottom].first());
  auto others = docks[DialogPlace::right];
  if (others.size() > 1) {
    others.removeLast();
    addBelow(DialogPlace::right, others.first());
    tabify(others);
  }
  for (const DialogPlace place : {DialogPlace::left, DialogPlace::center}) {
    auto list = docks[place];
    std::ranges::reverse(list);
    tabify(list);
  }
  tabify(docks[DialogPlace::bottom]);
  // Places have their sizes once the window has its own.
  QTimer::singleShot(0, this, [this, docks]() mutable {
    for (const auto& [place, list] : docks)
      for (const QPointer<QDockWidget>& dock : list)
        if (!dock) return;  // another arrangement was chosen meanwhile
    const auto resize = [&](std::initializer_list<std::pair<DialogPlace, double>> shares,
                            Qt::Orientation orientation) {
      const int whole = orientation == Qt::Horizontal ? width() : height();
      QList<QDockWidget*> list;
      QList<int> sizes;
      for (const auto& [place, share] : shares)
        if (!docks[place].isEmpty()) {
          list << docks[place].last();
          sizes << static_cast<int>(share * whole);
        }
      resizeDocks(list, sizes, orientation);
    };
    resize({{DialogPlace::left, 0.22}, {DialogPlace::center, 0.46}, {DialogPlace::right, 0.32}},
           Qt::Horizontal);
    resize({{DialogPlace::center, 0.62}, {DialogPlace::bottom, 0.38}}, Qt::Vertical);
    for (const auto& [place, list] : docks)
      if (!list.isEmpty())
        raiseDock(*this, place == DialogPlace::bottom ? list.first() : list.last());
  });
}

Result<void> MainWindow::chooseLayout(const QString& name) {
  const auto layout = layouts_.load(name);
  if (!layout) {
    if (dialogs_.empty()) arrangeAtFirst();
    return layout.error();
  }
  layouts_.setCurrent(name);
  return arrange(*layout);
}

Result<void> MainWindow::saveLayout(const QString& name) {
  if (auto done = layouts_.save(name, arrangement()); !done) return done;
  layouts_.setCurrent(name);
  statusBar()->showMessage("Layout " + name + " is saved", messageTime);
  return {};
}

// While it runs.

void MainWindow::refresh() {
  if (session_.ended()) {
    close();
    return;
  }
  std::erase_if(dialogs_, [](const auto& entry) { return !entry.second; });
  std::erase_if(frames_, [](const auto& entry) { return !entry.second; });
  // A dialog may open or close others.
  const auto open = dialogs_;
  for (const auto& [key, dialog] : open)
    if (dialog && dialog->isVisible() && !dialog->visibleRegion().isEmpty()) dialog->refresh();
  showStatus();
}

void MainWindow::showStatus() {
  const SessionStatus status = session_.status();
  const auto text = [](const std::string& line) { return QString::fromStdString(line); };
  QStringList selected;
  for (const RobotInfo& robot : status.robots)
    if (robot.selected) selected << text(robot.name);
  robotLabel_->setText(selected.isEmpty()    ? "no robot"
                       : selected.size() > 1 ? QString{"%1 robots"}.arg(selected.size())
                                             : selected.front());
  timeLabel_->setText(text(clockText(status.time)) +
                      (status.started || session_.busy()
                           ? QString{"  %1×"}.arg(status.speed, 0, 'f', 1)
                           : "  stands"));
  gameLabel_->setText(QString{"red %1 : %2 blue, %3"}
                          .arg(status.score[0])
                          .arg(status.score[1])
                          .arg(text(std::string{enumName(status.state)})));
  const QString current = text(session_.current());
  busyLabel_->setText(current.isEmpty() ? "" : "executes " + current + " (Shift+F5 stops it)");
  logLabel_->setText(status.log ? QString{"%1: message %2 of %3"}
                                      .arg(QFileInfo{text(status.log->file)}.fileName())
                                      .arg(status.log->message)
                                      .arg(status.log->messages)
                                : "");
  const QString scene = QFileInfo{text(status.scene)}.fileName();
  setWindowTitle(scene + " – RobotControl");
  if (scene == scene_) return;
  scene_ = scene;
  if (const QString layout = layouts_.ofScene(scene);
      !layout.isEmpty() && layout != layouts_.current())
    report(chooseLayout(layout));
}

void MainWindow::closeEvent(QCloseEvent* event) {
  timer_.stop();
  event->accept();
}

}  // namespace gt
