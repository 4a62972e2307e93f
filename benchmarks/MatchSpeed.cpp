#include "MatchSpeed.h"

#include <fmt/core.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <utility>

#include "base/File.h"
#include "framework/Requests.h"
#include "match/Match.h"
#include "robot/Solutions.h"

namespace gt {
namespace {

/// What one match took.
struct Run {
  double realTimeFactor = 0;
  double seconds = 0;  ///< Simulated.
  std::vector<PartTime> parts;
};

/// Has the robots ask the oracle instead of their cameras, which take no images.
Result<void> blindfold(Match& match) {
  for (std::size_t i = 0; i < match.robots().size(); ++i) {
    match.simulation().takeImages(i, false);
    Robot& robot = match.robots()[i]->robot();
    for (const auto& [task, solution] : {std::pair{"ImageProcessor", "disabled"},
                                         {"SelfLocator", "Oracled"},
                                         {"BallLocator", "Oracled"}})
      if (auto done = robot.request(SolutionRequest{task, solution}); !done) return done;
  }
  return {};
}

Result<Run> play(MatchOptions options, bool oracled) {
  if (oracled) options.truth = {"red", "blue"};
  auto match = Match::make(options);
  if (!match) return match.error();
  if (oracled)
    if (auto done = blindfold(**match); !done) return done.error();
  const auto begin = std::chrono::steady_clock::now();
  while (!(*match)->finished()) (*match)->step();
  if (auto done = (*match)->close(); !done) return done.error();
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - begin;
  const double simulated = static_cast<double>((*match)->time().ms) / 1000;
  return Run{simulated / seconds.count(), simulated, (*match)->times()};
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
    std::vector<double> times, shares;
    for (const Run& run : runs) {
      times.push_back(run.parts[i].totalMs * 1000 / static_cast<double>(run.parts[i].count));
      shares.push_back(run.parts[i].totalMs / run.seconds);
    }
    const std::string figure = figureOf(runs.front().parts[i].part);
    figures.add(figure, "us", times);
    figures.add(figure + ".second", "ms", shares);
  }
}

/// A way to play.
struct MatchKind {
  const char* figure;
  const char* scene;
  std::size_t threads;
  bool logged;
  bool oracled;
  Aim aim;
};

constexpr const char *kinematic = "scenes/match.scene", *dynamic = "scenes/dynamic.scene";
const std::array<MatchKind, 8> kinds{
    {{"speed.match.threads1", kinematic, 1, false, false, {}},
     {"speed.match.threads2", kinematic, 2, false, false, Aim::atLeast(40)},
     {"speed.match.oracled.threads1", kinematic, 1, false, true, {}},
     {"speed.match.oracled.threads2", kinematic, 2, false, true, Aim::atLeast(150)},
     {"speed.match.logged.threads1", kinematic, 1, true, false, {}},
     {"speed.match.logged.threads2", kinematic, 2, true, false, {}},
     {"speed.match.dynamic.threads1", dynamic, 1, false, false, {}},
     {"speed.match.dynamic.threads2", dynamic, 2, false, false, Aim::atLeast(10)}}};

/// Plays as many matches of a kind as are asked for, each on a seed of its own.
Result<std::vector<Run>> playAll(MatchOptions match, int runs, bool oracled) {
  std::vector<Run> played;
  for (int i = 1; i <= runs; ++i) {
    match.seed = static_cast<std::uint64_t>(i);
    auto run = play(match, oracled);
    if (!run) return run.error();
    played.push_back(std::move(*run));
  }
  return played;
}

std::vector<double> factorsOf(const std::vector<Run>& runs) {
  std::vector<double> factors;
  for (const Run& run : runs) factors.push_back(run.realTimeFactor);
  return factors;
}

/// A scene of so many robots, all of which have programs.
std::string sceneOf(std::size_t robots, const DataRoot& root) {
  const auto here = std::filesystem::absolute(root.path(".")).string();
  std::string entries;
  for (std::size_t i = 0; i < robots; ++i) {
    constexpr std::array<const char*, 4> roles{"striker2", "striker1", "goalie", "defender"};
    entries += fmt::format(
        "<robot name=\"r{0}\" team=\"{1}\" role=\"{2}\" x=\"{3}\" y=\"{4}\" "
        "model=\"{5}/models/ers210.xml\" layout=\"{5}/layouts/cmd.layout\"/>",
        i, i % 2 == 0 ? "red" : "blue", roles[i / 2 % 4], -1800 + 700 * static_cast<int>(i % 6),
        -900 + 550 * static_cast<int>(i / 6), here);
  }
  return fmt::format(
      "<scene field=\"{0}/models/field2003.xml\" config=\"{0}/config\"><game referee=\"false\"/>"
      "<robots>{1}</robots>"
      "<balls><ball x=\"0\" y=\"0\" model=\"{0}/models/ball.xml\"/></balls></scene>",
      here, entries);
}

Result<void> measureGrowth(Figures& figures, const MatchSpeedOptions& options) {
  const auto file = std::filesystem::temp_directory_path() / "gt2003-bench.scene";
  for (const std::size_t robots : {1, 2, 4, 8, 16, 22}) {
    if (auto done = writeFile(file.string(), sceneOf(robots, options.root)); !done) return done;
    MatchOptions match{options.root};
    match.scene = file.string();
    match.minutes = options.minutes / 2;
    auto runs = playAll(match, options.runs, false);
    if (!runs) return runs.error();
    figures.add("speed.match.robots" + std::to_string(robots), "x", factorsOf(*runs));
  }
  std::filesystem::remove(file);
  return {};
}

/// How many times as long as in `benign` a match takes in `padova`; in turn, as machines are now
/// faster, now slower.
Result<void> measureProfiles(Figures& figures, const MatchSpeedOptions& options) {
  MatchOptions match{options.root};
  match.minutes = options.minutes;
  std::vector<double> costs;
  for (int i = 1; i <= options.runs; ++i) {
    match.seed = static_cast<std::uint64_t>(i);
    std::map<std::string, double> factors;
    for (const char* profile : {"benign", "padova"}) {
      match.profile = profile;
      const auto run = play(match, false);
      if (!run) return run.error();
      factors[profile] = run->realTimeFactor;
    }
    costs.push_back(factors["benign"] / factors["padova"]);
  }
  figures.add("speed.match.padova.cost", "x", costs, Aim::atMost(1.25));
  return {};
}

}  // namespace

Result<void> measureMatchSpeed(Figures& figures, const MatchSpeedOptions& options) {
  const auto logs = std::filesystem::temp_directory_path() / "gt2003-bench";
  std::filesystem::create_directories(logs);
  for (const MatchKind& kind : kinds) {
    MatchOptions match{options.root};
    match.scene = options.root.path(kind.scene);
    match.minutes = options.minutes;
    match.threads = kind.threads;
    if (kind.logged) match.logs = logs.string();
    auto runs = playAll(match, options.runs, kind.oracled);
    if (!runs) return runs.error();
    figures.add(kind.figure, "x", factorsOf(*runs), kind.aim);
    // With one thread no other work disturbs what is measured.
    if (&kind == kinds.data()) addParts(figures, *runs);
  }
  std::filesystem::remove_all(logs);
  if (auto done = measureProfiles(figures, options); !done) return done;
  return measureGrowth(figures, options);
}

}  // namespace gt
