#include "workbench/MainMenus.h"

#include <QActionGroup>
#include <QFileDialog>
#include <QFileInfo>
#include <QInputDialog>
#include <QMenuBar>
#include <QMessageBox>
#include <algorithm>

#include "workbench/CommandPalette.h"
#include "workbench/MainWindow.h"
#include "workbench/SaveImage.h"

namespace gt {

MainMenus::MainMenus(MainWindow& window, SessionThread& session)
    : window_{window}, session_{session} {
  addFileMenu();
  addSimulationMenu();
  addViewMenu();
  QMenu* robots = add("&Robots");
  QObject::connect(robots, &QMenu::aboutToShow, &window_,
                   [this, robots] { fillRobotMenu(*robots); });
  QMenu* layouts = add("&Layouts");
  fillLayoutMenu(*layouts);
  QObject::connect(layouts, &QMenu::aboutToShow, &window_,
                   [this, layouts] { fillLayoutMenu(*layouts); });
  addHelpMenu();
}

QMenu* MainMenus::add(const QString& title) {
  return window_.menuBar()->addMenu(title);
}

void MainMenus::addFileMenu() {
  QMenu* file = add("&File");
  file->addAction("Open &scene…", QKeySequence::Open, &window_, [this] { openScene(); });
  file->addAction("Open &log…", QKeySequence{"Ctrl+L"}, &window_, [this] { openLog(); });
  file->addAction("Run s&cript…", &window_, [this] {
    const QString script =
        QFileDialog::getOpenFileName(&window_, "Run a script", "scenes", "Console scripts (*.con)");
    if (!script.isEmpty()) session_.execute("call \"" + script.toStdString() + "\"");
  });
  file->addSeparator();
  file->addAction("&Save state…", QKeySequence::Save, &window_, [this] {
    const QString state = QFileDialog::getSaveFileName(
        &window_, "Save the simulation's state", "out/states/match.state", "States (*.state)");
    if (!state.isEmpty()) session_.execute("save \"" + state.toStdString() + "\"");
  });
  file->addAction("L&oad state…", &window_, [this] {
    const QString state =
        QFileDialog::getOpenFileName(&window_, "Load a state", "out/states", "States (*.state)");
    if (!state.isEmpty()) session_.execute("load \"" + state.toStdString() + "\"");
  });
  file->addSeparator();
  file->addAction("Save &picture of the window…", &window_, [this] {
    const QString picture =
        QFileDialog::getSaveFileName(&window_, "Save a picture", "window.png", "Images (*.png)");
    if (!picture.isEmpty()) window_.report(saveImage(window_.grab().toImage(), picture));
  });
  file->addAction("&Quit", QKeySequence::Quit, &window_, [this] { window_.close(); })
      ->setObjectName("quit");
}

void MainMenus::addSimulationMenu() {
  QMenu* simulation = add("&Simulation");
  QAction* start = simulation->addAction("&Start or pause", QKeySequence{"F5"}, &window_, [this] {
    if (session_.busy())
      session_.interrupt();
    else
      session_.execute(session_.status().started ? "stop" : "start");
  });
  start->setToolTip("Lets simulated time pass, or stand");
  simulation->addAction("S&tep", QKeySequence{"F10"}, &window_,
                        [this] { session_.execute("step"); });
  simulation->addAction("&Reset", QKeySequence{"Ctrl+F5"}, &window_,
                        [this] { session_.execute("reset"); });
  simulation->addAction("Stop the &command that is executed", QKeySequence{"Shift+F5"}, &window_,
                        [this] { session_.interrupt(); });
}

void MainMenus::addViewMenu() {
  QMenu* view = add("&View");
  view->setToolTipsVisible(true);
  std::map<QString, QMenu*> groups;
  for (const DialogType& type : Dialog::types()) {
    QMenu*& group = groups[type.group];
    if (!group) {
      group = view->addMenu(type.group);
      group->setToolTipsVisible(true);
    }
    const QString id = type.id;
    QAction* action = group->addAction(type.title, &window_, [this, id] { window_.open(id); });
    action->setObjectName("view." + id);
    action->setToolTip(helpOf(type));
    action->setStatusTip(helpOf(type));
  }
  view->addSeparator();
  auto* themes = new QActionGroup{&window_};
  for (const auto& [name, theme] : {std::pair{"Light", Theme::light}, {"Dark", Theme::dark}}) {
    QAction* action =
        view->addAction(name, &window_, [this, chosen = theme] { window_.showTheme(chosen); });
    action->setObjectName(QString{"theme."} + name);
    action->setCheckable(true);
    action->setActionGroup(themes);
    action->setChecked((window_.layouts().setting("theme").toString() == "dark") ==
                       (theme == Theme::dark));
  }
}

void MainMenus::fillRobotMenu(QMenu& menu) {
  menu.clear();
  const SessionStatus status = session_.status();
  auto* group = new QActionGroup{&menu};
  const auto add = [&](const QString& text, const std::string& name, bool checked) {
    QAction* action =
        menu.addAction(text, &window_, [this, name] { session_.execute("robot " + name); });
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
  menu.addAction("Connect to robots elsewhere…", &window_, [this] {
    const QString robots = QInputDialog::getText(
        &window_, "Connect", "Addresses, or NAME=ENDPOINT, as in the console command sc:");
    if (!robots.isEmpty()) session_.execute("sc " + robots.toStdString());
  });
}

void MainMenus::fillLayoutMenu(QMenu& menu) {
  menu.clear();
  auto* group = new QActionGroup{&menu};
  const auto choose = [this](const QString& name) {
    if (mayDiscard(&window_, window_.unsavedOnLayoutChange()))
      window_.report(window_.chooseLayout(name));
  };
  for (const QString& name : window_.layouts().names()) {
    QAction* action = menu.addAction(name, &window_, [choose, name] { choose(name); });
    action->setCheckable(true);
    action->setChecked(name == window_.layouts().current());
    action->setActionGroup(group);
  }
  menu.addSeparator();
  const QString current = window_.layouts().current();
  const bool own = window_.layouts().isOwn(current);
  QAction* save = menu.addAction("&Save", &window_,
                                 [this, current] { window_.report(window_.saveLayout(current)); });
  menu.addAction("Save &as…", &window_, [this] {
    const QString name = QInputDialog::getText(&window_, "Save the layout", "Name:");
    if (!name.isEmpty()) window_.report(window_.saveLayout(name));
  });
  QAction* rename = menu.addAction("&Rename…", &window_, [this, current] {
    const QString name =
        QInputDialog::getText(&window_, "Rename the layout", "Name:", QLineEdit::Normal, current);
    if (!name.isEmpty()) window_.report(window_.layouts().rename(current, name));
  });
  QAction* remove = menu.addAction("&Delete", &window_, [this, current] {
    if (QMessageBox::question(&window_, "Delete", "Delete the layout " + current + "?") ==
        QMessageBox::Yes)
      window_.report(window_.layouts().remove(current));
  });
  QAction* ofScene = menu.addAction("Use for the scene " + window_.scene());
  ofScene->setCheckable(true);
  ofScene->setChecked(!current.isEmpty() && window_.layouts().ofScene(window_.scene()) == current);
  QObject::connect(ofScene, &QAction::toggled, &window_, [this, current](bool on) {
    window_.layouts().setOfScene(window_.scene(), on ? current : QString{});
  });
  for (QAction* action : {save, ofScene}) action->setEnabled(!current.isEmpty());
  for (QAction* action : {rename, remove}) action->setEnabled(own);
  menu.addSeparator();
  menu.addAction("As at the &first start", &window_, [this] {
    if (mayDiscard(&window_, window_.unsavedOnLayoutChange())) window_.arrangeAtFirst();
  });
}

void MainMenus::openScene() {
  const QString scene = QFileDialog::getOpenFileName(
      &window_, "Open a scene", QFileInfo{QString::fromStdString(session_.status().scene)}.path(),
      "Scenes (*.scene)");
  if (!scene.isEmpty()) session_.execute("scene \"" + scene.toStdString() + "\"");
}

void MainMenus::openLog() {
  const QString log = QFileDialog::getOpenFileName(&window_, "Open a log", "out/logs",
                                                   "Logs (*.mcap *.log);;All (*)");
  if (log.isEmpty()) return;
  const std::string name =
      "log-" + QFileInfo{log}.completeBaseName().replace(' ', '_').toStdString();
  session_.execute("sl " + name + " \"" + log.toStdString() + "\"", &window_,
                   [this, name](const Result<void>& done) {
                     if (!done) return window_.report(done);
                     session_.execute("robot " + name);
                     window_.open("logPlayer");
                   });
}

void MainMenus::addHelpMenu() {
  QMenu* help = add("&Help");
  help->addAction("&Find a command…", QKeySequence{"Ctrl+Shift+P"}, &window_,
                  [this] { showPalette(); });
  help->addAction("Commands of the &console", &window_, [this] {
    window_.open("console");
    session_.execute("help");
  });
  help->addAction("&About", &window_, [this] {
    QMessageBox::about(&window_, "RobotControl",
                       "The workbench for robots of the simulator, on logs and elsewhere.\n"
                       "docs/robotcontrol.md describes it.");
  });
}

QList<QAction*> MainMenus::commands() const {
  QList<QAction*> all;
  const std::function<void(const QMenu&)> collect = [&](const QMenu& menu) {
    for (QAction* action : menu.actions()) {
      if (const QMenu* part = action->menu())
        collect(*part);
      else if (!action->isSeparator() && action->isEnabled())
        all << action;
    }
  };
  for (const QAction* action : window_.menuBar()->actions())
    if (const QMenu* menu = action->menu()) collect(*menu);
  return all;
}

void MainMenus::showPalette() {
  for (const QAction* action : window_.menuBar()->actions())
    if (QMenu* menu = action->menu()) Q_EMIT menu->aboutToShow();
  CommandPalette palette{&window_, commands(), session_};
  palette.exec();
}

}  // namespace gt
