#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "base/ChildProgram.h"
#include "base/TemporaryFolder.h"
#include "match/Match.h"
#include "support/ProgramFolder.h"

namespace gt::testing {

/// A match in real time in which red3 consists of programs.
class RobotOfPrograms {
 public:
  /// The match listens for the programs in `folder`, or at an endpoint with keys.
  explicit RobotOfPrograms(const std::string& endpoint = "", const Keys* keys = nullptr) {
    setenv("XDG_STATE_HOME", folder.c_str(), 1);  // what a router keeps is gone with the test
    MatchOptions options;
    options.remote = {{"red3", endpoint}};
    options.sockets = folder;
    if (keys) options.keys = *keys;
    auto made = Match::make(options);
    EXPECT_TRUE(made) << made.error().text();
    match = std::move(*made);
  }
  ~RobotOfPrograms() { processes.clear(); }
  RobotOfPrograms(const RobotOfPrograms&) = delete;
  RobotOfPrograms& operator=(const RobotOfPrograms&) = delete;

  std::vector<std::string> command(const std::string& process, const std::string& sockets) const {
    const std::string who = "--robot=red3", team = "--team=red", role = "--role=striker1";
    return {programFolder() + "/gtrobot-" + process,
            who,
            team,
            role,
            "--sockets",
            sockets,
            "--logs",
            folder};
  }
  const RemoteRobot& robot() const { return *match->remoteRobots().front(); }
  /// Plays on for some ms.
  void play(std::int64_t ms) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::int64_t t = 8; t <= ms; t += 8) {
      match->step();
      std::this_thread::sleep_until(begin + std::chrono::milliseconds{t});
    }
  }
  /// Plays until something holds, at which it looks from time to time; false if it does not in a
  /// minute.
  template <typename Condition>
  bool playUntil(Condition condition, std::int64_t ms = 48) {
    constexpr std::int64_t patience = 60'000;
    for (std::int64_t time = 0; time < patience; time += ms) {
      if (condition()) return true;
      play(ms);
    }
    return condition();
  }
  /// The robot answers in time, as far as a busy machine lets it.
  bool joined() {
    const RemoteStatistics before = robot().statistics();
    play(400);
    const RemoteStatistics& now = robot().statistics();
    return now.frames > before.frames && now.pictures > before.pictures &&
           now.missedFrames - before.missedFrames < 25 &&
           now.missedPictures - before.missedPictures < 5;
  }
  std::vector<std::filesystem::path> logs() const {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator{folder})
      if (entry.path().extension() == ".mcap") files.push_back(entry.path());
    return files;
  }

  const TemporaryFolder temporary;
  const std::string folder = temporary.path().string();
  const std::string tools = "ipc://" + folder + "/red3.Tools";
  std::unique_ptr<Match> match;
  std::vector<std::unique_ptr<ChildProgram>> processes;
};

}  // namespace gt::testing
