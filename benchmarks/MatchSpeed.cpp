#include "MatchSpeed.h"

#include <chrono>
#include <filesystem>
#include <map>

#include "match/Match.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

/// What one match took.
struct Run {
  double realTimeFactor = 0;
  std::vector<PartTime> parts;
};

Result<Run> play(const MatchOptions& options) {
  auto match = Match::make(options);
  if (!match) return match.error();
  const auto begin = std::chrono::steady_clock::now();
  while (!(*match)->finished()) (*match)->step();
  if (auto done = (*match)->close(); !done) return done.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  return Run{static_cast<double>((*match)->time().ms) / 1000 / seconds.count(), (*match)->times()};
}

std::string figureOf(const std::string& part) {
  if (solutions().find(part)) return "speed.module." + part;
  static const std::map<std::string, std::string> simulator{{"world", "speed.world.step"},
                                                            {"sensors", "speed.sensors"},
                                                            {"camera", "speed.camera.match"}};
  return simulator.at(part);
}

void addParts(Figures& figures, const std::vector<Run>& runs) {
  for (std::size_t i = 0; i < runs.front().parts.size(); ++i) {
    std::vector<double> times;
    for (const Run& run : runs)
      times.push_back(run.parts[i].totalMs * 1000 / static_cast<double>(run.parts[i].count));
    figures.add(figureOf(runs.front().parts[i].part), "us", times);
  }
}

}  // namespace

Result<void> measureMatchSpeed(Figures& figures, const MatchSpeedOptions& options) {
  const auto logs = std::filesystem::temp_directory_path() / "gt2003-bench";
  std::filesystem::create_directories(logs);
  for (const bool logged : {false, true})
    for (const std::size_t threads : {1, 2}) {
      std::vector<Run> runs;
      for (int i = 1; i <= options.runs; ++i) {
        MatchOptions match;
        match.minutes = options.minutes;
        match.seed = static_cast<std::uint64_t>(i);
        match.threads = threads;
        if (logged) match.logs = logs.string();
        auto run = play(match);
        if (!run) return run.error();
        runs.push_back(std::move(*run));
      }
      std::vector<double> factors;
      for (const Run& run : runs) factors.push_back(run.realTimeFactor);
      figures.add(
          (logged ? "speed.match.logged.threads" : "speed.match.threads") + std::to_string(threads),
          "x", factors, threads == 2 ? Aim::atLeast(10) : Aim{});
      // With one thread no other work disturbs what is measured.
      if (threads == 1 && !logged) addParts(figures, runs);
    }
  std::filesystem::remove_all(logs);
  return {};
}

}  // namespace gt
