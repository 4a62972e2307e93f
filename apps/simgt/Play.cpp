#include "Play.h"

#include <fmt/core.h>

#include <chrono>
#include <filesystem>

#include "TerminalScreen.h"
#include "match/report/Report.h"

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
  for (const ReportImage& kept : match.images())
    pictures.push_back(reportPicture(kept.title, kept.image, kept.drawings));
  const MatchSummary summary = match.summary();
  if (auto done = writeMatchJson((out / "match.json").string(), summary); !done) return done;
  if (auto done = writeTimesJson((out / "times.json").string(), times); !done) return done;
  return writeReport((out / "report.html").string(), summary, times, pictures);
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
  const std::filesystem::path out{options.out};
  std::error_code failed;
  std::filesystem::create_directories(out, failed);
  if (failed) return Error{.file = options.out, .what = failed.message()};
  if (options.logs) options.match.logs = options.out;
  options.match.images = 12;
  TerminalScreen screen;
  auto made = Session::make(options.match, screen);
  if (!made) return made.error();
  Session& session = **made;
  screen.watch(session);
  if (!options.foxglove.endpoint.empty())
    if (const auto done = session.serveFoxglove(options.foxglove); !done) return done.error();
  if (options.script.empty())
    for (SimulatedRobot* robot : session.match().robots()) robot->sendOracle(false);
  if (options.realTime || !options.match.remote.empty()) session.setPace({1, 0});

  fmt::print("{}, {} minutes, seed {}\n", options.match.scene,
             session.simulation().scene().game.minutes, options.match.seed);
  const auto begin = std::chrono::steady_clock::now();
  Console console{session};  // what its script has recorded goes on
  if (!options.script.empty()) {
    const auto done = console.call(options.script);
    screen.end();
    if (!done && !console.expectationFailed()) return done.error();
    if (!done) {
      fmt::print(stderr, "simgt: {}\n", done.error().text());
      return 1;
    }
  }
  while (!session.match().finished() && session.step()) {
  }
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  screen.end();
  Match& match = session.match();
  if (const auto done = match.teamFailure(); !done) return done.error();
  const MatchTimes times = timesOf(match, seconds.count(), options.match.threads);
  if (const auto done = match.close(); !done) return done.error();
  if (const auto done = writeResults(match, times, out); !done) return done.error();
  const Referee& referee = match.simulation().referee();
  fmt::print("Final score red {} : {} blue, {:.1f} times real time\n",
             referee.score(TeamColor::red), referee.score(TeamColor::blue), times.realTimeFactor);
  printRemote(match);
  fmt::print("Report: {}\n", (out / "report.html").string());
  fmt::print("Data:   {}, {}{}\n", (out / "match.json").string(), (out / "times.json").string(),
             options.logs ? ", logs beside them (*.mcap)" : "");
  return printWarnings(session).fail(options.strict) ? 1 : 0;
}

}  // namespace gt
