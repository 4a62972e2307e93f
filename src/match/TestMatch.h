#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <map>
#include <memory>
#include <string>

#include "base/File.h"
#include "match/Match.h"
#include "streams/Json.h"

namespace gt {

/// Longest time of a match in tests (ms). Sanitized programs are 10 to 50 times slower, so they
/// play only its beginning.
#if defined(__SANITIZE_THREAD__)
constexpr std::int64_t longestMatch = 800;
#elif defined(__SANITIZE_ADDRESS__)
constexpr std::int64_t longestMatch = 6000;
#else
constexpr std::int64_t longestMatch = std::numeric_limits<std::int64_t>::max();
#endif
constexpr bool wholeMatches = longestMatch > 60'000;

inline bool isOver(const Match& match) {
  return match.finished() || match.time() >= Time{longestMatch};
}

/// A person's command in the tests: begins play where the robots stand.
inline Result<void> whistle(Match& match, const std::string&) {
  match.simulation().referee().order(GameState::playing, match.simulation().world());
  return {};
}
/// Whether a match is over that was begun by `whistle`, for which no clock runs: after its minutes
/// from the start.
inline bool isPlayed(Match& match) {
  const double minutes = match.simulation().scene().game.minutes;
  return isOver(match) || match.time() >= Time{static_cast<std::int64_t>(minutes * 60'000)};
}

/// Plays matches into a folder of its own.
class MatchTest : public ::testing::Test {
 protected:
  void SetUp() override {
    folder =
        std::filesystem::temp_directory_path() / ("gt2003-match-" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
  }
  void TearDown() override { std::filesystem::remove_all(folder); }

  std::unique_ptr<Match> make(const std::string& name, std::uint64_t seed, std::size_t threads,
                              double minutes, const std::string& scene = "scenes/match.scene",
                              const std::string& profile = "") {
    MatchOptions options;
    options.scene = scene;
    options.profile = profile;
    options.seed = seed;
    options.threads = threads;
    options.minutes = minutes;
    options.logs = (folder / name).string();
    options.images = 4;
    std::filesystem::create_directories(options.logs);
    auto match = Match::make(options);
    EXPECT_TRUE(match) << match.error().text();
    return std::move(*match);
  }
  /// The content of all files of a match that begins at once, by name.
  std::map<std::string, std::string> play(const std::string& name, std::uint64_t seed,
                                          std::size_t threads, double minutes,
                                          const std::string& scene = "scenes/match.scene",
                                          const std::string& profile = "") {
    const auto match = make(name, seed, threads, minutes, scene, profile);
    EXPECT_TRUE(whistle(*match, ""));
    while (!isPlayed(*match)) match->step();
    EXPECT_TRUE(match->close());
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::directory_iterator{folder / name})
      files[entry.path().filename()] = *readFile(entry.path().string());
    files["match.json"] = jsonText(match->summary());
    return files;
  }

  std::filesystem::path folder;
};

/// Puts the ball.
inline Result<void> putBall(Match& match, const std::string& line) {
  match.simulation().world().placeBall(0, {std::stod(line), 100}, {300, 0});
  return {};
}

}  // namespace gt
