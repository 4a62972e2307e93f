#include "workbench/MainWindow.h"

#include <QApplication>
#include <QChildEvent>
#include <QCloseEvent>
#include <QEventLoop>
#include <QFileDialog>
#include <QFileInfo>
#include <QStatusBar>
#include <QTabBar>

#include "views/ViewText.h"

namespace gt {
namespace {

constexpr int refreshInterval = 40;  // ms
constexpr int messageTime = 8000;    // ms

}  // namespace

MainWindow::MainWindow(SessionThread& session, const QString& folder)
    : session_{session},
      layouts_{folder, QString::fromStdString(session.root().path("config/workbench"))},
      docks_{*this, session},
      menus_{*this, session} {
  setWindowTitle("RobotControl");
  resize(1280, 760);
  setDockNestingEnabled(true);
  // Neither grouped dragging nor animations: Qt 6.4 crashes when it restores a state over a group
  // that floats, or while a dock moves.
  setDockOptions(AllowNestedDocks | AllowTabbedDocks);
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

  showTheme(layouts_.setting("theme").toString() == "dark" ? Theme::dark : Theme::light);
  scene_ = QFileInfo{QString::fromStdString(session_.status().scene)}.fileName();
  QString layout = layouts_.ofScene(scene_);
  if (layout.isEmpty()) layout = layouts_.current();
  if (layout.isEmpty())
    arrangeAtFirst();
  else
    report(chooseLayout(layout));
  report(layouts_.fault());
  QObject::connect(&timer_, &QTimer::timeout, this, [this] { refresh(); });
  timer_.start(refreshInterval);
}

void MainWindow::report(const Result<void>& done) {
  if (!done) statusBar()->showMessage(QString::fromStdString(done.error().text()), messageTime);
}

void MainWindow::showTheme(Theme theme) {
  setTheme(theme);
  layouts_.set("theme", theme == Theme::dark ? "dark" : "light");
}

// Layouts.

Result<void> MainWindow::arrange(const QJsonObject& arrangement) {
  const auto done = docks_.arrange(arrangement);
  chosen_ = docks_.arrangement()["dialogs"];
  return done;
}

void MainWindow::arrangeAtFirst() {
  layouts_.setCurrent({});
  docks_.arrangeAtFirst();
}

Result<void> MainWindow::chooseLayout(const QString& name) {
  const auto layout = layouts_.load(name);
  if (!layout) {
    if (docks_.empty()) arrangeAtFirst();
    return layout.error();
  }
  layouts_.setCurrent(name);
  return arrange(*layout);
}

Result<void> MainWindow::saveLayout(const QString& name) {
  if (auto done = layouts_.save(name, arrangement()); !done) return done;
  layouts_.setCurrent(name);
  chosen_ = docks_.arrangement()["dialogs"];
  statusBar()->showMessage("Layout " + name + " is saved", messageTime);
  return {};
}

// While it runs.

void MainWindow::refresh() {
  if (session_.ended()) {
    timer_.stop();
    close();
    return;
  }
  docks_.refresh();
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
  // What a dialog asks, it asks in an event loop within its own work: it must not be gone then.
  const bool asks = QApplication::activeModalWidget() || QApplication::activePopupWidget();
  if (scene == scene_ || asks) return;
  scene_ = scene;
  if (const QString layout = layouts_.ofScene(scene); !layout.isEmpty() &&
                                                      layout != layouts_.current() &&
                                                      mayDiscard(this, unsavedOnLayoutChange()))
    report(chooseLayout(layout));
}

/// Qt 6.4 crashes when a tab is moved within the bar of docks that come and go (QTabBar's
/// setupMovableTab): docks are dragged out of it only. A bar is polished before it can be seen.
void MainWindow::childEvent(QChildEvent* event) {
  if (event->polished())
    if (auto* bar = qobject_cast<QTabBar*>(event->child())) bar->setMovable(false);
  QMainWindow::childEvent(event);
}

// What is not saved.

std::vector<Unsaved> MainWindow::unsavedOnLayoutChange() {
  std::vector<Unsaved> all = docks_.unsaved();
  const QString layout = layouts_.current();
  if (!layout.isEmpty() && docks_.arrangement()["dialogs"] != chosen_)
    all.push_back({"the layout " + layout, [this, layout] {
                     const auto done = saveLayout(layout);
                     report(done);
                     return static_cast<bool>(done);
                   }});
  return all;
}

std::vector<Unsaved> MainWindow::unsaved() {
  std::vector<Unsaved> all = unsavedOnLayoutChange();
  for (const RecordingInfo& recording : session_.status().recordings)
    all.push_back({QString{"the recording of %1 (%2 messages)"}
                       .arg(QString::fromStdString(recording.robot))
                       .arg(recording.messages),
                   [this, robot = recording.robot] { return saveRecording(robot); }});
  return all;
}

bool MainWindow::saveRecording(const std::string& robot) {
  const QString file = QFileDialog::getSaveFileName(
      this, "Save what was recorded", QString::fromStdString("out/logs/" + robot + ".mcap"),
      "Logs (*.mcap)");
  if (file.isEmpty()) return false;
  QEventLoop saving;
  bool saved = false;
  session_.executeFor(robot, "log save \"" + file.toStdString() + "\"", &saving,
                      [&](const Result<void>& done) {
                        report(done);
                        saved = static_cast<bool>(done);
                        saving.quit();
                      });
  saving.exec();
  return saved;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  // Whoever ended the session by a command has no window to return to.
  const bool discard = mayDiscard(this, unsaved());
  if (!discard && !session_.ended()) return event->ignore();
  timer_.stop();
  event->accept();
}

}  // namespace gt
