#include "MatchSpeed.h"

#include <array>
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

/// A way to play.
struct MatchKind {
  const char* figure;
  const char* scene;
  std::size_t threads;
  bool logged;
  Aim aim;
};

const std::array<MatchKind, 6> kinds{
    {{"speed.match.threads1", "scenes/match.scene", 1, false, {}},
     {"speed.match.threads2", "scenes/match.scene", 2, false, Aim::atLeast(40)},
     {"speed.match.logged.threads1", "scenes/match.scene", 1, true, {}},
     {"speed.match.logged.threads2", "scenes/match.scene", 2, true, {}},
     {"speed.match.dynamic.threads1", "scenes/dynamic.scene", 1, false, {}},
     {"speed.match.dynamic.threads2", "scenes/dynamic.scene", 2, false, Aim::atLeast(10)}}};

}  // namespace

Result<void> measureMatchSpeed(Figures& figures, const MatchSpeedOptions& options) {
  const auto logs = std::filesystem::temp_directory_path() / "gt2003-bench";
  std::filesystem::create_directories(logs);
  for (const MatchKind& kind : kinds) {
    std::vector<Run> runs;
    std::vector<double> factors;
    for (int i = 1; i <= options.runs; ++i) {
      MatchOptions match;
      match.scene = kind.scene;
      match.minutes = options.minutes;
      match.seed = static_cast<std::uint64_t>(i);
      match.threads = kind.threads;
      if (kind.logged) match.logs = logs.string();
      auto run = play(match);
      if (!run) return run.error();
      factors.push_back(run->realTimeFactor);
      runs.push_back(std::move(*run));
    }
    figures.add(kind.figure, "x", factors, kind.aim);
    // With one thread no other work disturbs what is measured.
    if (&kind == kinds.data()) addParts(figures, runs);
  }
  std::filesystem::remove_all(logs);
  return {};
}

}  // namespace gt
