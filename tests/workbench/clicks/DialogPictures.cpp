#include "workbench/clicks/DialogPictures.h"

#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QJsonDocument>
#include <QtTest>
#include <algorithm>
#include <array>
#include <string_view>

#include "base/TemporaryFolder.h"
#include "workbench/MainWindow.h"
#include "workbench/clicks/Walk.h"

namespace gt {
namespace {

constexpr QSize sizes[] = {{1280, 720}, {2560, 1440}};
constexpr int settling = 700;  // ms, until a dialog shows what there is

/// A match that has begun, and of which there is something to show in all dialogs.
constexpr const char* commands[] = {"st on 1",
                                    "robot red4",
                                    "log start",
                                    "run 34 s",
                                    "log save out/logs/workbench",
                                    "sl recorded workbench",
                                    "robot recorded red4",
                                    "lp message 400",
                                    "robot red4",
                                    "run 2 s"};

/// What is shown for the robot that runs on a log.
constexpr std::array<std::string_view, 3> dialogsOfLogs = {"labels", "logPlayer", "timeline"};

void waitForCommands(SessionThread& session) {
  bool done = false;
  QObject receiver;
  session.execute("# done", &receiver, [&](const Result<void>&) { done = true; });
  constexpr int patience = 300'000;  // ms
  if (!QTest::qWaitFor([&] { return done; }, patience))
    throw std::runtime_error{"the commands do not end"};
}

/// Takes pictures of all dialogs in a window of a size: each in its place of the first arrangement.
void takePictures(MainWindow& window, SessionThread& session, const QJsonObject& settings,
                  const DialogPictures& options, Theme theme, const QSize& size) {
  window.showTheme(theme);
  window.resize(size);
  const bool kept = theme == Theme::light && size == sizes[0] && !options.dialogs.empty();
  const QString folder =
      QString{"%1/%2-%3x%4/"}
          .arg(QString::fromStdString(options.out), theme == Theme::dark ? "dark" : "light")
          .arg(size.width())
          .arg(size.height());
  for (const DialogType& type : Dialog::types()) {
    if (!options.only.empty() && options.only != type.id) continue;
    const bool ofLog =
        std::ranges::find(dialogsOfLogs, std::string_view{type.id}) != dialogsOfLogs.end();
    session.execute(ofLog ? "robot recorded" : "robot red4");
    window.arrangeAtFirst();
    window.resize(size);
    Dialog* const known = window.dialog(type.id);
    Dialog* const dialog = known ? known : window.open(type.id);
    window.bringToFront(type.id);
    if (settings.contains(type.id)) dialog->restore(settings[type.id].toObject());
    QWidget* const frame = dialog->parentWidget();
    frame->show();
    QTest::qWait(settling);
    session.execute("run 400 ms");
    waitForCommands(session);
    QTest::qWait(settling);
    savePicture(window.grab(), folder + type.id + ".png");
    if (kept)
      savePicture(frame->grab(), QString::fromStdString(options.dialogs) + "/" + type.id + ".png");
  }
}

}  // namespace

Result<void> takePictures(const DialogPictures& options) {
  QFile file{QString::fromStdString(options.settings)};
  if (!file.open(QIODevice::ReadOnly))
    return Error{.file = options.settings, .what = "cannot be read"};
  const QJsonObject settings = QJsonDocument::fromJson(file.readAll()).object();
  MatchOptions match{options.root};
  match.seed = 7;
  match.threads = 2;
  auto session = SessionThread::make(match);
  if (!session) return session.error();
  QDir{}.mkpath("out/logs");
  for (const char* command : commands) (*session)->execute(command);
  const TemporaryFolder folder;
  MainWindow window{**session, QString::fromStdString(folder.path().string())};
  window.show();
  waitForCommands(**session);
  for (const Theme theme : {Theme::light, Theme::dark})
    for (const QSize& size : sizes) takePictures(window, **session, settings, options, theme, size);
  return {};
}

}  // namespace gt
