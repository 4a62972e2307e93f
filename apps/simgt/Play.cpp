#include "Play.h"

#include <fmt/core.h>

#include <chrono>
#include <csignal>
#include <filesystem>

#include "TerminalScreen.h"
#include "base/EndSignals.h"
#include "base/Guarded.h"
#include "base/OutputLock.h"
#include "match/report/Report.h"
#include "simulation/rules/GameEvent.h"

namespace gt {
namespace {

/// How robots outside kept up.
void printRemote(const Match& match) {
  for (const RemoteRobot* robot : match.remoteRobots()) {
    const RemoteStatistics& s = robot->statistics();
    fmt::print("{}: {} of {} frames and {} of {} images without an answer in time\n", robot->name(),
               s.missedFrames, s.frames, s.missedPictures, s.pictures);
  }
}

/// Prints what the robots reported as wrong.
Findings printWarnings(const Session& session) {
  Findings all;
  for (const auto& robot : session.robots()) all.add(robot->observed().warnings());
  for (const Error& finding : all.list()) fmt::print(stderr, "simgt: {}\n", finding.text());
  return all;
}

/// Prints which invariants did not hold, or that all did. Returns whether one is an error.
bool printBroken(const Match& match) {
  const std::vector<BrokenInvariant> all = match.summary().broken;
  if (all.empty()) fmt::print("All invariants held\n");
  bool failed = false;
  for (const BrokenInvariant& broken : all) {
    failed |= broken.severity == Severity::error;
    fmt::print(stderr, "simgt: {:.3f} to {:.3f} s: {}{}: {}: {}\n", broken.time.ms / 1000.,
               broken.until.ms / 1000.,
               broken.severity == Severity::error ? "" : "warning: ", broken.invariant, broken.who,
               broken.text);
  }
  return failed;
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

/// Writes the page, with the images that were kept.
Result<void> writePage(const Match& match, const MatchSummary& summary, const MatchTimes& times,
                       const std::string& file) {
  std::vector<ReportPicture> pictures;
  for (const ReportImage& kept : match.images())
    pictures.push_back(reportPicture(kept.title, kept.image, kept.drawings));
  return writeReport(file, summary, times, pictures);
}

/// Writes each file, whether the others can be written or not. Returns the first error.
Result<void> writeResults(const Match& match, const MatchTimes& times, bool interrupted,
                          const std::filesystem::path& out) {
  MatchSummary summary = match.summary();
  summary.interrupted = interrupted;
  std::error_code ignored;                            // then writing reports what is wrong
  std::filesystem::create_directories(out, ignored);  // somebody may have removed it
  Result<void> first;
  const auto write = [&](const auto& work) {
    if (const auto done = guarded(work); first && !done) first = done;
  };
  write([&] { return writeMatchJson((out / "match.json").string(), summary); });
  write([&] { return writeTimesJson((out / "times.json").string(), times); });
  write([&] { return writePage(match, summary, times, (out / "report.html").string()); });
  return first;
}

/// Closes the logs, writes the results and prints what became of the match. Returns the first
/// error.
Result<void> finish(Match& match, const MatchTimes& times, bool interrupted,
                    const PlayOptions& options) {
  const std::filesystem::path out{options.out};
  const auto closed = guarded([&] { return match.close(); });
  const auto written = guarded([&] { return writeResults(match, times, interrupted, out); });
  if (interrupted) fmt::print(stderr, "simgt: interrupted at {}\n", clockText(match.time()));
  const Referee& referee = match.simulation().referee();
  fmt::print("{} red {} : {} blue, {:.1f} times real time\n", interrupted ? "Score" : "Final score",
             referee.score(TeamColor::red), referee.score(TeamColor::blue), times.realTimeFactor);
  printRemote(match);
  if (!closed || !written) return closed ? written : closed;
  fmt::print("Report: {}\n", (out / "report.html").string());
  fmt::print("Data:   {}, {}{}\n", (out / "match.json").string(), (out / "times.json").string(),
             options.logs ? ", logs beside them (*.mcap)" : "");
  return {};
}

}  // namespace

Result<int> play(PlayOptions options) {
  for (const std::string& robot : options.remote) {
    const auto end = std::min(robot.find('='), robot.size());
    options.match.remote[robot.substr(0, end)] = robot.substr(std::min(end + 1, robot.size()));
  }
  if (!options.keys.empty()) {
    auto keys = loadKeys(options.keys);
    if (!keys) return keys.error();
    options.match.keys = std::move(*keys);
  }
  const auto lock = OutputLock::ofFolder(options.out);
  if (!lock) return lock.error();
  if (options.logs) options.match.logs = options.out;
  options.match.images = 12;
  TerminalScreen screen;
  auto made = Session::make(options.match, screen);
  if (!made) return made.error();
  Session& session = **made;
  const EndSignals signals{[&session] { session.interrupt(); }};
  screen.watch(session);
  if (!options.foxglove.endpoint.empty())
    if (const auto done = session.serveFoxglove(options.foxglove); !done) return done.error();
  if (options.realTime || !options.match.remote.empty()) session.setPace({1, 0});

  fmt::print("{}, {} minutes, seed {}\n", options.match.scene,
             session.simulation().scene().game.minutes, options.match.seed);
  const auto begin = std::chrono::steady_clock::now();
  Console console{session};  // what its script has recorded goes on
  const Result<void> played = guarded([&]() -> Result<void> {
    if (!options.script.empty())
      if (auto done = console.call(options.script); !done && !signals.received()) return done;
    while (!signals.received() && !session.match().finished() && session.step()) {
    }
    return session.match().soundness();
  });
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  screen.end();
  Match& match = session.match();
  const MatchTimes times = timesOf(match, seconds.count(), options.match.threads);
  const bool interrupted = !match.finished() || !match.teamFailure();
  const auto done = finish(match, times, interrupted, options);
  if (!played && console.expectationFailed() && done) {
    fmt::print(stderr, "simgt: {}\n", played.error().text());
    return 1;
  }
  if (!played || !done) return played ? done.error() : played.error();
  const Findings warnings = printWarnings(session);
  const bool broken = options.match.check && printBroken(match);
  if (interrupted || signals.received() == SIGPIPE) return signals.status();
  return broken || warnings.fail(options.strict) ? 1 : 0;
}

}  // namespace gt
