#include "RobotPrograms.h"

#include <fmt/core.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "base/ChildProgram.h"
#include "base/TemporaryFolder.h"
#include "match/Match.h"

namespace gt {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr std::array processes{"cognition", "motion", "debug"};
constexpr std::array<std::pair<const char*, const char*>, 4> team{
    {{"red1", "goalie"}, {"red2", "defender"}, {"red3", "striker1"}, {"red4", "striker2"}}};

std::string programOf(const std::string& process) {
  std::error_code failed;
  return (fs::read_symlink("/proc/self/exe", failed).parent_path() / ("gtrobot-" + process))
      .string();
}

/// Plays on for some ms; returns how many times faster than real time, which is at most 1.
double play(Match& match, std::int64_t ms) {
  const auto begin = Clock::now();
  const Time end = match.time() + ms;
  for (std::int64_t t = 8; match.time() < end; t += 8) {
    match.step();
    std::this_thread::sleep_until(begin + std::chrono::milliseconds{t});
  }
  const std::chrono::duration<double, std::milli> took = Clock::now() - begin;
  return static_cast<double>(ms) / took.count();
}

bool allThere(const Match& match) {
  return std::ranges::all_of(match.remoteRobots(), [](const RemoteRobot* robot) {
    return robot->statistics().pictures > 25;
  });
}

double percent(std::int64_t part, std::int64_t whole) {
  return 100 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace

Result<void> measureRobotPrograms(Figures& figures, const DataRoot& root) {
  for (const char* process : processes)
    if (const std::string program = programOf(process); !fs::exists(program)) {
      fmt::print("speed.programs: not measured, there is no {}\n", program);
      return {};
    }
  const TemporaryFolder folder;
  MatchOptions options{root};
  options.sockets = folder.path().string();
  for (const auto& [robot, role] : team) options.remote[robot];
  auto match = Match::make(options);
  if (!match) return match.error();
  std::vector<std::unique_ptr<ChildProgram>> programs;
  for (const auto& [robot, role] : team)
    for (const char* process : processes)
      programs.push_back(std::make_unique<ChildProgram>(std::vector<std::string>{
          programOf(process), "--robot", robot, "--team", "red", "--role", role, "--sockets",
          options.sockets, "--crashes", options.sockets, "--root", root.path(".")}));
  for (int seconds = 0; !allThere(**match); ++seconds) {
    if (seconds == 30)
      return Error{.field = "speed.programs", .what = "the robots do not join the match"};
    play(**match, 1000);
  }
  std::vector<RemoteStatistics> before;
  for (const RemoteRobot* robot : (*match)->remoteRobots()) before.push_back(robot->statistics());
  std::vector<double> factors, frames, pictures;
  for (int run = 0; run < 5; ++run) factors.push_back(play(**match, 4000));
  for (std::size_t i = 0; i < before.size(); ++i) {
    const RemoteStatistics& now = (*match)->remoteRobots()[i]->statistics();
    frames.push_back(
        percent(now.missedFrames - before[i].missedFrames, now.frames - before[i].frames));
    pictures.push_back(
        percent(now.missedPictures - before[i].missedPictures, now.pictures - before[i].pictures));
  }
  figures.add("speed.programs.realTimeFactor", "x", factors, Aim::atLeast(0.99));
  figures.add("speed.programs.missedFrames", "%", frames, Aim::atMost(5));
  figures.add("speed.programs.missedPictures", "%", pictures, Aim::atMost(5));
  return {};
}

}  // namespace gt
