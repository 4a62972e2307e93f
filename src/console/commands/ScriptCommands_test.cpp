#include <fstream>

#include "console/TestSession.h"

namespace gt {
namespace {

using ScriptCommands = SessionTest;

TEST_F(ScriptCommands, ErrorsNameFileAndLine) {
  const std::string inner = file("inner.con"), outer = file("outer.con");
  std::ofstream{inner} << "# inner\necho in\nsr BallLocator nonsense\necho never\n";
  std::ofstream{outer} << "\xEF\xBB\xBF"
                          "echo out\r\n\r\ncall "
                       << inner;
  const auto done = console->call(outer);
  ASSERT_FALSE(done);
  EXPECT_EQ(done.error().file, inner);
  EXPECT_EQ(done.error().line, 3);
  EXPECT_EQ(screen.printed, (std::vector<std::string>{"out", "in"}));
  std::ofstream{outer} << "call " << outer << "\n";
  EXPECT_FALSE(console->call(outer)) << "a script that calls itself";
  EXPECT_FALSE(console->call(file("nothing.con")));
}

}  // namespace
}  // namespace gt
