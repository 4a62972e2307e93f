#include <QApplication>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QEvent>
#include <algorithm>
#include <ctime>
#include <fstream>
#include <functional>
#include <memory>
#include <numeric>
#include <span>
#include <thread>

#include "base/TemporaryFolder.h"
#include "commandline/CommandLine.h"
#include "logs/LogPlayer.h"
#include "measure/Figures.h"
#include "workbench/CustomPlot.h"
#include "workbench/MainWindow.h"
#include "workbench/SheetWidget.h"
#include "workbench/ViewDialog.h"

namespace gt {
namespace {

struct Options {
  DataRoot root;
  double seconds = 20;     ///< Of play.
  double logMinutes = 10;  ///< Of the log that is opened.
  std::string json = "out/bench.json";
  std::string only{};  ///< One part of it.
};

/// Processor time in ms: of this thread, or of the whole program.
double processorMs(clockid_t of = CLOCK_THREAD_CPUTIME_ID) {
  timespec time{};
  clock_gettime(of, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

double elapsedMs(const QElapsedTimer& clock) {
  return 1e-6 * static_cast<double>(clock.nsecsElapsed());
}

/// The program's memory in MB.
double memory() {
  std::ifstream file{"/proc/self/statm"};
  double pages = 0, resident = 0;
  file >> pages >> resident;
  constexpr double pageSize = 4096, megabyte = 1e6;
  return resident * pageSize / megabyte;
}

/// The slope of values over minutes, by least squares.
double slope(const std::vector<double>& minutes, const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double x = 0, y = 0, xx = 0, xy = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    x += minutes[i];
    y += values[i];
    xx += minutes[i] * minutes[i];
    xy += minutes[i] * values[i];
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

/// The camera image of a sheet, as a number that distinguishes it from the image before.
class ImageOnSheet : public SheetPainter {
 public:
  void line(std::span<const Vector2d>, bool, const Pen&) override {}
  void area(std::span<const Vector2d>, Color) override {}
  void circle(const Vector2d&, double, const Pen&) override {}
  void disk(const Vector2d&, double, Color) override {}
  void sector(const Vector2d&, double, double, double, Color) override {}
  void text(const Vector2d&, std::string_view, const Font&) override {}
  void picture(const RgbImage& picture, const Vector2d&, double) override {
    const auto* begin = reinterpret_cast<const char*>(picture.pixels.data());
    hash = std::hash<std::string_view>{}({begin, picture.pixels.size()});
  }

  std::size_t hash = 0;
};

/// Counts the images that a viewer paints one after another.
class ShownImages : public QObject {
 public:
  explicit ShownImages(ViewDialog& viewer) : widget_{&viewer.sheet()} {
    widget_->installEventFilter(this);
  }
  double count() const { return count_; }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Paint || !widget_->sheet() || widget_->sheet() == sheet_)
      return false;
    sheet_ = widget_->sheet();
    ImageOnSheet image;
    sheet_->paintOn(image);
    if (std::exchange(last_, image.hash) != image.hash) ++count_;
    return false;
  }

 private:
  SheetWidget* widget_;
  const Sheet* sheet_ = nullptr;
  std::size_t last_ = 0;
  double count_ = 0;
};

Result<std::unique_ptr<SessionThread>> play(const Options& options) {
  MatchOptions match{options.root};
  match.threads = 2;
  return SessionThread::make(match);
}

void handleEventsUntil(const std::function<bool()>& holds) {
  while (!holds()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 5);
}

/// Executes a command to its end.
void execute(SessionThread& session, const std::string& line) {
  bool done = false;
  session.execute(line, QCoreApplication::instance(), [&](const Result<void>& result) {
    if (!result) std::fprintf(stderr, "%s: %s\n", line.c_str(), result.error().text().c_str());
    done = true;
  });
  handleEventsUntil([&] { return done; });
}

/// How long it takes until there is a window on a match, painted.
Result<void> measureFirstWindow(Figures& figures, const Options& options,
                                const TemporaryFolder& folder) {
  constexpr int runs = 5;
  std::vector<double> times;
  for (int i = 0; i < runs; ++i) {
    QElapsedTimer clock;
    clock.start();
    auto session = play(options);
    if (!session) return session.error();
    MainWindow window{**session, QString::fromStdString(folder.path().string())};
    window.show();
    QCoreApplication::processEvents();
    window.repaint();
    times.push_back(elapsedMs(clock));
  }
  figures.add("workbench.window.first", "ms", times, Aim::atMost(1000));
  return {};
}

constexpr const char* viewers[] = {"image", "image#2", "image#3", "image#4"};

/// Twenty values over time, and a robot whose images are shown.
void showRobots(SessionThread& session, MainWindow& window) {
  QJsonArray values;
  int number = 0;
  for (const char* robot : {"red1", "red2", "red3", "red4"})
    for (const char* path : {"RobotPose.pose.translation.x", "RobotPose.pose.translation.y",
                             "RobotPose.pose.rotation", "RobotPose.validity", "x"})
      values.append(QJsonArray{QString{"%1.%2"}.arg(robot, path), number++ % 2 == 1});
  window.dialog("plot")->restore({{"values", values}, {"seconds", 20}});
  execute(session, "robot red4");
  execute(session, "run 1 s");
  execute(session, "st on 1");
}

/// What a developer has before the eyes: four image viewers beside each other, below them field,
/// 20 values over time, and the time diagram.
void openViewers(MainWindow& window) {
  window.resize(1600, 1000);
  QJsonArray dialogs;
  for (const char* key : {"image", "image#2", "image#3", "image#4", "field", "plot", "times"})
    dialogs.append(QJsonObject{{"dialog", key}, {"settings", QJsonObject{}}});
  static_cast<void>(window.arrange({{"version", 1}, {"dialogs", dialogs}}));
  const auto dock = [&](const char* key) {
    return static_cast<QDockWidget*>(window.dialog(key)->parentWidget());
  };
  const auto addRow = [&](std::span<const char* const> keys, Qt::DockWidgetArea area) {
    for (const char* key : keys) {
      window.removeDockWidget(dock(key));
      window.addDockWidget(area, dock(key), Qt::Horizontal);
      dock(key)->show();
    }
  };
  addRow(viewers, Qt::TopDockWidgetArea);
  const char* const below[] = {"field", "plot", "times"};
  addRow(below, Qt::BottomDockWidgetArea);
}

/// All dialogs that there are, and several image viewers: each is a window of its own, for what
/// lies behind another dialog is not refreshed.
void openEverything(MainWindow& window) {
  for (const DialogType& type : Dialog::types()) window.open(type.id);
  for (int i = 0; i < 3; ++i) window.open("image");
  for (auto* dock : window.findChildren<QDockWidget*>()) {
    dock->setFloating(true);
    dock->show();
  }
}

/// Eight robots play in real time with some dialogs open; figures' names begin with `prefix`.
Result<void> measurePlay(Figures& figures, const Options& options, const TemporaryFolder& folder,
                         const std::string& prefix, void (*open)(MainWindow&)) {
  auto session = play(options);
  if (!session) return session.error();
  MainWindow window{**session, QString::fromStdString(folder.path().string())};
  window.show();
  open(window);
  showRobots(**session, window);
  constexpr double warmUp = 3000, interval = 1000;  // ms
  (*session)->execute("start");
  std::vector<std::unique_ptr<ShownImages>> shown;
  for (const char* key : viewers)
    shown.push_back(std::make_unique<ShownImages>(dynamic_cast<ViewDialog&>(*window.dialog(key))));
  QElapsedTimer clock;
  clock.start();
  while (elapsedMs(clock) < warmUp) QCoreApplication::processEvents();
  std::vector<double> before, lost;
  for (const auto& viewer : shown) before.push_back(viewer->count());
  const Time begin = (*session)->status().time;
  std::vector<double> passes, processor, minutes, sizes;
  const double usedBefore = processorMs(CLOCK_PROCESS_CPUTIME_ID);
  clock.start();
  while (elapsedMs(clock) < 1000 * options.seconds) {
    const double from = elapsedMs(clock), used = processorMs();
    QCoreApplication::processEvents();
    passes.push_back(elapsedMs(clock) - from);
    processor.push_back(processorMs() - used);
    constexpr double perMinute = 60'000;
    if (elapsedMs(clock) >= interval * static_cast<double>(sizes.size())) {
      minutes.push_back(elapsedMs(clock) / perMinute);
      sizes.push_back(memory());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  }
  const auto simulated = static_cast<double>((*session)->status().time - begin);
  const double taken = elapsedMs(clock);
  const double usedAll = processorMs(CLOCK_PROCESS_CPUTIME_ID) - usedBefore;
  constexpr double imageInterval = 40;  // ms
  const double made = simulated / imageInterval;
  for (std::size_t i = 0; i < shown.size(); ++i)
    lost.push_back(std::max(0.0, 100 * (1 - (shown[i]->count() - before[i]) / made)));
  figures.add(prefix + ".images.lost", "%", lost, Aim::atMost(0));
  const double windows = std::accumulate(processor.begin(), processor.end(), 0.0);
  const auto addLoop = [&](const std::string& name, std::vector<double>& times) {
    std::ranges::sort(times);
    figures.add(name + ".p95", "ms", {times[times.size() * 95 / 100]}, Aim::atMost(16));
    figures.add(name + ".longest", "ms", {times.back()}, Aim::atMost(50));
  };
  addLoop(prefix + ".loop", passes);
  addLoop(prefix + ".loop.processor", processor);
  figures.add(prefix + ".realTime", "x", {simulated / taken}, Aim::atLeast(0.98));
  // What it takes in processors: of the window's thread, and of the whole.
  figures.add(prefix + ".processors.window", "1", {windows / taken});
  figures.add(prefix + ".processors", "1", {usedAll / taken}, Aim::atMost(2));
  figures.add(prefix + ".memory.growth", "MB/min", {slope(minutes, sizes)});
  return {};
}

Result<void> measureViewers(Figures& figures, const Options& options,
                            const TemporaryFolder& folder) {
  return measurePlay(figures, options, folder, "workbench", openViewers);
}
Result<void> measureEverything(Figures& figures, const Options& options,
                               const TemporaryFolder& folder) {
  return measurePlay(figures, options, folder, "workbench.everything", openEverything);
}

/// Lets a robot play alone, without a window, for its log.
Result<std::string> makeLog(const Options& options, const TemporaryFolder& folder) {
  MatchOptions match{options.root};
  match.scene = options.root.path("scenes/one-robot.scene");
  match.logs = folder.path().string();
  const auto made = Match::make(match);
  if (!made) return made.error();
  constexpr double msPerMinute = 60'000;
  while (static_cast<double>((*made)->time().ms) < msPerMinute * options.logMinutes)
    (*made)->step();
  if (auto done = (*made)->close(); !done) return done.error();
  return (folder.path() / ((*made)->robots().front()->name() + ".mcap")).string();
}

Result<void> measureLog(Figures& figures, const Options& options, const TemporaryFolder& folder) {
  const auto file = makeLog(options, folder);
  if (!file) return file.error();
  constexpr int opens = 5, seeks = 20;
  std::vector<double> opening, seeking;
  const auto ignore = [](const McapChannel&, const McapMessage&) { return Result<void>{}; };
  for (int i = 0; i < opens; ++i) {
    QElapsedTimer clock;
    clock.start();
    auto log = LogPlayer::open(*file);
    if (!log) return log.error();
    opening.push_back(elapsedMs(clock));
    for (int k = 0; k < seeks; ++k) {
      constexpr int stride = 7;  // there and back
      const std::int64_t length = log->end() - log->begin();
      clock.start();
      log->seekTime(log->begin() + length * ((k * stride) % seeks) / seeks);
      if (const auto done = log->next(ignore); !done) return done.error();
      seeking.push_back(elapsedMs(clock));
    }
  }
  figures.add("workbench.log.open", "ms", opening, Aim::atMost(1000));
  figures.add("workbench.log.seek", "ms", seeking, Aim::atMost(100));
  return {};
}

/// The value history, moved along a million points.
Result<void> measurePan(Figures& figures, const Options& options, const TemporaryFolder& folder) {
  auto session = play(options);
  if (!session) return session.error();
  MainWindow window{**session, QString::fromStdString(folder.path().string())};
  window.resize(1600, 1000);
  window.show();
  auto* plot = window.open("plot")->findChild<QCustomPlot*>();
  constexpr int points = 1'000'000, frames = 60;
  constexpr double interval = 0.008, shown = 0.25;  // s; of all points
  QVector<double> times(points), values(points);
  for (int i = 0; i < points; ++i) {
    times[i] = interval * i;
    values[i] = std::sin(0.001 * i) + 0.1 * std::sin(1.7 * i);
  }
  QCPGraph* const graph = plot->addGraph();
  graph->setAdaptiveSampling(true);
  graph->setData(times, values, true);
  plot->yAxis->setRange(-1.2, 1.2);
  std::vector<double> rates;
  const double length = interval * points;
  for (int i = 0; i < frames; ++i) {
    const double begin = (1 - shown) * length * i / frames;
    QElapsedTimer clock;
    clock.start();
    plot->xAxis->setRange(begin, begin + shown * length);
    plot->replot(QCustomPlot::rpImmediateRefresh);
    constexpr double msPerSecond = 1000;
    rates.push_back(msPerSecond / elapsedMs(clock));
  }
  figures.add("workbench.plot.pan", "1/s", rates, Aim::atLeast(30));
  return {};
}

Result<void> measure(int argc, char** argv, const Options& options) {
  QApplication application{argc, argv};
  const TemporaryFolder folder;
  Figures figures;
  const std::pair<const char*, decltype(&measurePan)> parts[] = {{"window", measureFirstWindow},
                                                                 {"plot", measurePan},
                                                                 {"play", measureViewers},
                                                                 {"everything", measureEverything},
                                                                 {"log", measureLog}};
  for (const auto& [name, part] : parts)
    if (options.only.empty() || options.only == name)
      if (auto done = part(figures, options, folder); !done) return done;
  figures.print();
  return figures.write(options.json);
}

}  // namespace
}  // namespace gt

/// Measures the workbench: `workbench.*`.
int main(int argc, char** argv) {
  gt::CommandLine line{argc, argv, "Benchmarks: the workbench's window"};
  gt::Options options{.root = line.root()};
  line.app()
      .add_option("--seconds", options.seconds,
                  "Of play with all open; 3600 shows what memory does")
      ->check(CLI::Range(1.0, 1e5))
      ->capture_default_str();
  line.app()
      .add_option("--log-minutes", options.logMinutes, "Length of the log that is opened")
      ->check(CLI::Range(0.1, 100.0))
      ->capture_default_str();
  line.app()
      .add_option("--only", options.only, "Measures one part")
      ->check(CLI::IsMember({"window", "plot", "play", "everything", "log"}));
  line.app().add_option("--json", options.json, "File for the figures")->capture_default_str();
  return line.run([&] { return gt::measure(argc, argv, options); });
}
