#include "console/Console.h"

#include <filesystem>
#include <fstream>

#include "console/TestSession.h"

namespace gt {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;

using ConsoleTest = SessionTest;

TEST(Words, KeepQuotesTogether) {
  EXPECT_EQ(*splitWords("  mr  walk 1 \"a b\" \t c"), (Words{"mr", "walk", "1", "a b", "c"}));
  EXPECT_TRUE(splitWords("")->empty());
  EXPECT_FALSE(splitWords("echo \"open"));
  EXPECT_EQ(*splitWords(R"(sl AIBO1 c:\\logs\\hallo)"), (Words{"sl", "AIBO1", R"(c:\logs\hallo)"}));
  EXPECT_EQ(splitWords("echo  what it \t is  ")->rest, "what it \t is");
}

TEST_F(ConsoleTest, LinesOfVeryManyWordsAreRefused) {
  std::string line;
  for (int i = 0; i < 200'000; ++i) line += " not";
  for (const std::string command : {"until", "sc", "echo", "nothing"})
    expectError(command + line, command, "has more than 1000 words");
  EXPECT_THAT(console->completions("until" + line + " "), ::testing::IsEmpty());
}

TEST_F(ConsoleTest, EveryCommandHasHelp) {
  for (const Command& command : Console::commands()) {
    EXPECT_FALSE(command.help.empty());
    screen.printed.clear();
    expectFine("help " + std::string{command.name});
    EXPECT_GE(screen.printed.size(), 2u) << command.name;
    EXPECT_FALSE(command.topic.empty()) << command.name;
    for (const std::string& line : screen.printed) EXPECT_LE(line.size(), 100u) << line;
  }
  const auto overview = answers("help");
  EXPECT_LT(overview.size(), 40u);
  EXPECT_THAT(overview, Contains(HasSubstr("xbb")));
  EXPECT_THAT(answers("help motion"), Contains(HasSubstr("hmr TILT PAN ROLL MOUTH")));
  EXPECT_THAT(answers("help motion"), testing::Not(Contains(HasSubstr("xbb"))));
  EXPECT_GT(answers("help all").size(), 100u);
  expectError("help nonsense", "nonsense", "no such command or topic");
  expectError("nonsense", "nonsense", "no such command");
  expectError("hlep", "hlep", "did you mean 'help'?");
  expectError("picture fild a.png", "fild", "did you mean 'field'?");
  expectError("robot rad4", "rad4", "did you mean 'red4'?");
  expectFine("# a comment");
  expectFine("");
}

TEST_F(ConsoleTest, RobotCommandsNeedARobot) {
  const std::string root = std::filesystem::current_path().string();
  std::ofstream{file("empty.scene")} << "<scene field='" << root
                                     << "/models/field2003.xml' config='" << root
                                     << "/config'><game referee='false'/></scene>";
  expectFine("scene " + file("empty.scene"));
  for (const char* line : {"dk ImageProcessor/horizon on", "mr stand", "hcm none", "log start"})
    expectError(line, "robot", "there is none");
}

TEST_F(ConsoleTest, QuestionsAreNotDoneAgain) {
  expectFine("xos head-control-mode ?");
  expectFine("sr SelfLocator ?");
  expectFine("robot ?");
  EXPECT_TRUE(session->match().history().empty());
  expectFine("robot red1");
  EXPECT_EQ(session->match().history().size(), 1u);
}

}  // namespace
}  // namespace gt
