#include "Play.h"

#include <fmt/core.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <thread>

#include "console/Console.h"
#include "match/report/Report.h"

namespace gt {
namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

/// A line at the terminal's bottom that shows how far the match is; commentary scrolls above it.
/// Without a terminal only the commentary is printed.
class ProgressBar {
 public:
  explicit ProgressBar(double minutes)
      : total_{minutes * 60}, terminal_{isatty(STDOUT_FILENO) != 0} {}

  void say(const std::string& line) {
    if (terminal_) fmt::print("\r\033[K");
    fmt::print("{}\n", line);
    if (terminal_) fmt::print("{}", last_);
    std::fflush(stdout);
  }
  void show(const Match& match, int red, int blue) {
    const double simulated = static_cast<double>(match.time().ms) / 1000,
                 real = secondsSince(begin_);
    if (!terminal_ || real < shown_ + 0.1) return;
    shown_ = real;
    const auto width = static_cast<std::size_t>(std::min(simulated / total_, 1.0) * 40);
    last_ = fmt::format("\r[{:<40}] {:2.0f}:{:02.0f}  {}:{}  {:.1f} times real time",
                        std::string(width, '='), std::floor(simulated / 60),
                        std::floor(std::fmod(simulated, 60)), red, blue, simulated / real);
    fmt::print("{}", last_);
    std::fflush(stdout);
  }
  void end() const {
    if (terminal_) fmt::print("\r\033[K");
  }
  double seconds() const { return secondsSince(begin_); }

 private:
  double total_;
  bool terminal_;
  double shown_ = 0;
  std::string last_;
  Clock::time_point begin_ = Clock::now();
};

/// Holds the simulation back to real time.
class Pace {
 public:
  /// Waits until the clock has come to a simulated time. Who falls far behind does not run to catch
  /// up, but goes on from there.
  void wait(Time time) {
    const auto due = begin_ + std::chrono::milliseconds{time.ms};
    const auto now = Clock::now();
    if (now > due + std::chrono::milliseconds{100}) begin_ += now - due;
    std::this_thread::sleep_until(due);
  }

 private:
  Clock::time_point begin_ = Clock::now();
};

/// How robots outside kept up.
void tellRemote(const Match& match) {
  for (const RemoteRobot* robot : match.remoteRobots()) {
    const RemoteStatistics& s = robot->statistics();
    fmt::print("{}: {} of {} frames and {} of {} pictures without an answer in time\n",
               robot->name(), s.missedFrames, s.frames, s.missedPictures, s.pictures);
  }
}

/// A match with its progress bar and commentary, as the console's world.
class ShownMatch : public ConsoleWorld {
 public:
  ShownMatch(Match& match, const PlayOptions& options)
      : match_{match},
        bar_{options.match.minutes},
        paced_{options.realTime || !options.match.remote.empty()} {}

  std::vector<NamedRobot> robots() override {
    std::vector<NamedRobot> robots;
    for (SimulatedRobot* robot : match_.robots())
      robots.push_back({robot->name(), &robot->robot()});
    return robots;
  }
  bool step() override {
    if (match_.finished()) return false;
    match_.step();
    if (paced_) pace_.wait(match_.time());
    const Referee& referee = match_.simulation().referee();
    for (; told_ < referee.events().size(); ++told_)
      bar_.say(minutes(referee.events()[told_].time) + "  " + describe(referee.events()[told_]));
    bar_.show(match_, referee.score(TeamColor::red), referee.score(TeamColor::blue));
    return true;
  }
  Time time() const override { return match_.time(); }
  void print(std::string_view line) override { bar_.say(std::string{line}); }
  void end() { bar_.end(); }
  double seconds() const { return bar_.seconds(); }

 private:
  static std::string minutes(Time time) {
    return fmt::format("{:2}:{:02}", time.ms / 60000, time.ms / 1000 % 60);
  }

  Match& match_;
  ProgressBar bar_;
  Pace pace_;
  bool paced_;
  std::size_t told_ = 0;
};

int fail(const Error& error) {
  fmt::print(stderr, "simgt: {}\n", error.text());
  return 2;
}

/// The time that the tasks do not take is the simulator's: world, sensors, cameras.
MatchTimes timesOf(const Match& match, double seconds, std::size_t threads) {
  MatchTimes times;
  times.seconds = seconds;
  times.realTimeFactor = static_cast<double>(match.time().ms) / 1000 / seconds;
  times.threads = static_cast<int>(threads);
  times.parts = match.times();
  return times;
}

Result<void> writeResults(const Match& match, const MatchTimes& times,
                          const std::filesystem::path& out) {
  std::vector<ReportPicture> pictures;
  for (const Match::Picture& picture : match.pictures())
    pictures.push_back(reportPicture(picture.title, picture.image, picture.drawings));
  const MatchSummary summary = match.summary();
  if (auto done = writeMatchJson((out / "match.json").string(), summary); !done) return done;
  if (auto done = writeTimesJson((out / "times.json").string(), times); !done) return done;
  return writeReport((out / "report.html").string(), summary, times, pictures);
}

}  // namespace

int play(PlayOptions options) {
  for (const std::string& robot : options.remote) {
    const auto end = std::min(robot.find('='), robot.size());
    options.match.remote[robot.substr(0, end)] = robot.substr(std::min(end + 1, robot.size()));
  }
  if (!options.keys.empty()) {
    auto keys = loadKeys(options.keys);
    if (!keys) return fail(keys.error());
    options.match.keys = std::move(*keys);
  }
  const std::filesystem::path out{options.out};
  std::error_code failed;
  std::filesystem::create_directories(out, failed);
  if (failed) return fail({options.out, 0, "", failed.message()});
  if (options.logs) options.match.logs = options.out;
  options.match.pictures = 12;
  auto match = Match::make(options.match);
  if (!match) return fail(match.error());

  fmt::print("{}, {} minutes, seed {}\n", options.match.scene, options.match.minutes,
             options.match.seed);
  ShownMatch shown{**match, options};
  if (!options.script.empty()) {
    Console console{shown};
    const auto done = console.call(options.script);
    if (!done) shown.end();
    if (!done) return fail(done.error());
  }
  while (shown.step()) {
  }
  const MatchTimes times = timesOf(**match, shown.seconds(), options.match.threads);
  shown.end();
  if (const auto done = (*match)->close(); !done) return fail(done.error());
  if (const auto done = writeResults(**match, times, out); !done) return fail(done.error());
  const Referee& referee = (*match)->simulation().referee();
  fmt::print("Final score red {} : {} blue, {:.1f} times real time\n",
             referee.score(TeamColor::red), referee.score(TeamColor::blue), times.realTimeFactor);
  tellRemote(**match);
  fmt::print("Report: {}\n", (out / "report.html").string());
  fmt::print("Data:   {}, {}{}\n", (out / "match.json").string(), (out / "times.json").string(),
             options.logs ? ", logs beside them (*.mcap)" : "");
  return 0;
}

}  // namespace gt
