#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "base/File.h"
#include "console/Console.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

/// Keeps what was printed, in the place of a terminal.
class TextScreen : public Screen {
 public:
  void print(std::string_view line) override { text += std::string{line} + "\n"; }
  void clear() override { text.clear(); }

  std::string text;
};

std::vector<std::string> scripts() {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator{"tests/console"})
    if (entry.path().extension() == ".con") names.push_back(entry.path().stem().string());
  std::sort(names.begin(), names.end());
  return names;
}

Result<void> runScript(const std::string& scene, const std::string& script, TextScreen& screen) {
  MatchOptions options;
  options.scene = scene;
  auto session = Session::make(options, screen);
  if (!session) return session.error();
  Console console{**session};
  auto done = console.call(script);
  (*session)->setPace({});
  return done;
}

class Script : public testing::TestWithParam<std::string> {};

TEST_P(Script, Runs) {
  TextScreen screen;
  const auto done =
      runScript("scenes/one-robot.scene", "tests/console/" + GetParam() + ".con", screen);
  EXPECT_TRUE(done) << done.error().text() << "\n" << screen.text;
}

INSTANTIATE_TEST_SUITE_P(OfCommand, Script, testing::ValuesIn(scripts()),
                         [](const auto& i) { return i.param; });

TEST(Scripts, ThereIsOneForEachCommand) {
  std::set<std::string> names;
  for (const std::string& script : scripts()) names.insert(script);
  for (const Command& command : Console::commands()) {
    const bool word = std::isalpha(static_cast<unsigned char>(command.name[0]));
    EXPECT_TRUE(names.contains(word ? std::string{command.name} : "help")) << command.name;
  }
}

TEST(Scripts, LeadRobotsThroughAGame) {
  for (const auto& [scene, script] : {std::pair{"no-opponents", "by-buttons"},
                                      {"match", "match-by-buttons"},
                                      {"match", "cheers"},
                                      {"no-opponents", "leave-field"},
                                      {"one-robot", "crouch"}}) {
    TextScreen screen;
    const auto done = runScript("scenes/" + std::string{scene} + ".scene",
                                "tests/console/game/" + std::string{script} + ".con", screen);
    EXPECT_TRUE(done) << script << ": " << done.error().text() << "\n" << screen.text;
  }
}

TEST(Scripts, OfTheReportTellIfTheirRobotDoesNotAnswer) {
  for (const char* script : {"record-log", "remote-control"}) {
    TextScreen screen;
    const auto done = runScript("scenes/empty.scene", script, screen);
    EXPECT_NE(screen.text.find("172.21.3.201 does not answer"), std::string::npos) << screen.text;
    if (!done) {
      EXPECT_NE(done.error().text().find("does not answer"), std::string::npos);
    }
  }
}

TEST(Scripts, TheReportsLogIsReplayedAsPrinted) {
  // The log that the report replays is recorded first, as the report says.
  TextScreen screen;
  const auto recorded =
      runScript("scenes/one-robot.scene", "tests/console/reports-log/record.con", screen);
  ASSERT_TRUE(recorded) << recorded.error().text();
  const auto replayed =
      runScript("scenes/empty.scene", "tests/console/reports-log/replay.con", screen);
  EXPECT_TRUE(replayed) << replayed.error().text() << "\n" << screen.text;
  EXPECT_GT(fs::file_size("out/logs/LOG1.png"), 1000u);
}

}  // namespace
}  // namespace gt
