#include "gtlog/ReplayLog.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "match/Match.h"

namespace gt {
namespace {

using testing::HasSubstr;

/// Some seconds of a match, with all that its robots sensed in their logs.
class ReplayLog : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    folder() = std::filesystem::path{testing::TempDir()} / "replay_log";
    std::filesystem::create_directories(folder());
    MatchOptions options;
    options.logs = folder().string();
    options.inputs = true;
    options.seed = 3;
    auto match = Match::make(options);
    ASSERT_TRUE(match) << match.error().text();
    while ((*match)->time().ms < 2500) (*match)->step();
    ASSERT_TRUE((*match)->close());
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(folder()); }

  static std::string path(const std::string& name) { return (folder() / name).string(); }

 private:
  static std::filesystem::path& folder() {
    static std::filesystem::path path;
    return path;
  }
};

TEST_F(ReplayLog, ComputesTheSameBitForBit) {
  for (const char* robot : {"red1", "blue3"}) {
    const auto topics = replayLog({path(std::string{robot} + ".mcap")}, path("replayed.mcap"));
    ASSERT_TRUE(topics) << topics.error().text();
    EXPECT_GE(topics->size(), 10u);
    for (const ReplayedTopic& topic : *topics) {
      EXPECT_GT(topic.recorded, 50u) << topic.topic;
      EXPECT_EQ(topic.recorded, topic.replayed) << topic.topic;
      EXPECT_EQ(topic.different, 0u) << robot << topic.topic;
    }
  }
}

TEST_F(ReplayLog, SwitchesSolutions) {
  ReplayOptions options{path("red1.mcap")};
  options.solutions = {{"ImageProcessor", "disabled", "", 0}};
  const auto topics = replayLog(options, path("blind.mcap"));
  ASSERT_TRUE(topics) << topics.error().text();
  const auto differs = [&](const std::string& name) {
    for (const ReplayedTopic& topic : *topics)
      if (topic.topic == name) return topic.different > 0;
    ADD_FAILURE() << name;
    return false;
  };
  EXPECT_TRUE(differs("/LandmarksPercept"));
  EXPECT_FALSE(differs("/GameControlData"));
  options.solutions = {{"ImageProcessor", "NoSuchSolution", "", 0}};
  EXPECT_THAT(replayLog(options, path("blind.mcap")).error().text(), HasSubstr("NoSuchSolution"));
}

TEST_F(ReplayLog, TellsOfLogsWithoutInputs) {
  const auto again = replayLog({path("red1.mcap")}, path("replayed.mcap"));
  ASSERT_TRUE(again) << again.error().text();
  EXPECT_THAT(replayLog({path("replayed.mcap")}, path("twice.mcap")).error().text(),
              HasSubstr("does not hold what its robot sensed"));
  EXPECT_THAT(replayLog({path("red1.mcap")}, path("red1.mcap")).error().text(),
              HasSubstr("is the log that is read"));
}

}  // namespace
}  // namespace gt
