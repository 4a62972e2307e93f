#include <QSocketNotifier>
#include <QTimer>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "base/EndSignals.h"
#include "base/TemporaryFolder.h"
#include "base/UserFolder.h"
#include "commandline/CommandLine.h"
#include "crash/CrashHandler.h"
#include "logs/LogPlayer.h"
#include "workbench/Application.h"
#include "workbench/MainWindow.h"
#include "workbench/SaveImage.h"

namespace {

struct Options {
  gt::MatchOptions match;
  std::vector<std::string> scripts, commands;
  std::string settings;
  gt::FoxgloveAccess foxglove;
  bool start = false;
  std::string picture;            ///< A picture of the window is written, and the program ends.
  std::vector<std::string> open;  ///< Dialogs.
  std::string theme;
  int width = 1280, height = 760;
};

/// Writes a picture of the window once all commands are executed and the dialogs have shown it.
void takePicture(gt::SessionThread& session, gt::MainWindow& window, const std::string& file) {
  constexpr int settling = 1200;  // ms
  session.execute("# all is done", &window, [&window, file](const gt::Result<void>&) {
    QTimer::singleShot(settling, &window, [&window, file] {
      const auto saved = gt::saveImage(window.grab().toImage(), QString::fromStdString(file));
      if (!saved) std::fprintf(stderr, "robotcontrol: %s\n", saved.error().text().c_str());
      QApplication::exit(saved ? 0 : 2);
    });
  });
}

/// A log may be given in the place of a scene: a robot called log runs on it beside the scene's.
gt::Result<void> openLog(Options& options) {
  const std::string file = options.match.scene;
  if (!file.ends_with(".mcap")) return {};
  if (const auto log = gt::LogPlayer::open(file); !log) return log.error();
  options.match.scene = gt::MatchOptions{options.match.root}.scene;
  options.commands.insert(options.commands.begin(), {"sl log \"" + file + "\"", "robot log"});
  return {};
}

/// The folder of layouts and settings. Of a user who has none they last as long as the program.
class SettingsFolder {
 public:
  explicit SettingsFolder(const Options& options) : path_{options.settings} {
    if (!path_.empty()) return;
    const std::string own = gt::userFolder(gt::UserFolder::config);
    path_ = own.empty() ? passing_.emplace().path().string() : own + "/robotcontrol";
  }
  QString path() const { return QString::fromStdString(path_); }

 private:
  std::string path_;
  std::optional<gt::TemporaryFolder> passing_;
};

gt::Result<int> run(int argc, char** argv, Options options) {
  const gt::EndSignals signals;
  gt::Application application{argc, argv};
  QApplication::setApplicationName("robotcontrol");
  QApplication::setDesktopFileName("robotcontrol");
  QApplication::setOrganizationName("gt2003");
  if (const auto done = openLog(options); !done) return done.error();
  auto session = gt::SessionThread::make(options.match, options.foxglove);
  if (!session) return session.error();
  (*session)->executeQuietly("st on 1");
  (*session)->callStartScript();
  for (const std::string& script : options.scripts) (*session)->execute("call \"" + script + "\"");
  for (const std::string& command : options.commands) (*session)->execute(command);
  if (options.start) (*session)->execute("start");
  const SettingsFolder settings{options};
  gt::MainWindow window{**session, settings.path()};
  window.resize(options.width, options.height);
  if (!options.theme.empty())
    gt::setTheme(options.theme == "dark" ? gt::Theme::dark : gt::Theme::light);
  window.show();
  for (const std::string& dialog : options.open)
    if (!window.open(QString::fromStdString(dialog)))
      return gt::Error{.field = dialog, .what = "there is no such dialog"};
  if (!options.picture.empty()) takePicture(**session, window, options.picture);
  // Then nobody is asked what shall be saved.
  QSocketNotifier ended{signals.event(), QSocketNotifier::Read};
  QObject::connect(&ended, &QSocketNotifier::activated,
                   [&] { QApplication::exit(signals.status()); });
  const int status = QApplication::exec();
  const auto failure = application.takeFailure();
  if (signals.received() != 0 || failure)
    for (const auto& kept : (*session)->end())
      std::fprintf(stderr, "%s\n", (kept ? *kept : kept.error().text()).c_str());
  if (failure) return *failure;
  return status;
}

}  // namespace

/// RobotControl: the workbench (report 5.2).
int main(int argc, char** argv) {
  gt::installCrashHandler({"robotcontrol"});
  gt::CommandLine line{argc, argv,
                       "RobotControl: the workbench for robots of the simulator, on logs and "
                       "elsewhere"};
  Options options;
  options.match = gt::MatchOptions{line.root()};
  options.match.threads = 2;
  CLI::App& app = line.app();
  app.add_option("scene", options.match.scene,
                 "Scene file; or a log (.mcap), on which a robot runs beside a scene")
      ->capture_default_str();
  app.add_option("--seed", options.match.seed, "The same seed gives the same match")
      ->capture_default_str();
  app.add_option("--threads", options.match.threads, "Worker threads; they do not change the match")
      ->check(CLI::Range(1, 256))
      ->capture_default_str();
  app.add_option("--script", options.scripts, "Console scripts to begin with");
  app.add_option("-c,--command", options.commands, "Console commands to begin with")
      ->allow_extra_args(false);
  app.add_flag("--start", options.start, "Lets time pass at once");
  app.add_option("--settings", options.settings,
                 "Folder of layouts and settings, instead of the user's own");
  app.add_option("--foxglove", options.foxglove.endpoint,
                 "Shows the robots to Foxglove and Lichtblick, too, which connect to "
                 "ws://localhost:PORT; ADDRESS:PORT for viewers on other machines");
  app.add_option("--foxglove-origin", options.foxglove.origins,
                 "Lets in viewers that a browser has loaded from there, as from "
                 "https://app.foxglove.dev, not only from this machine")
      ->allow_extra_args(false)
      ->needs("--foxglove");
  app.add_option("--open", options.open, "Dialogs to open, by their names in layouts");
  app.add_option("--theme", options.theme, "How the window looks")
      ->check(CLI::IsMember({"light", "dark"}));
  app.add_option("--picture", options.picture,
                 "Writes a picture of the window (PNG) after the commands, and ends");
  app.add_option("--width", options.width, "Of the window, pixels")->check(CLI::Range(320, 8000));
  app.add_option("--height", options.height, "Of the window, pixels")->check(CLI::Range(240, 8000));
  return line.run([&] { return run(argc, argv, options); });
}
