#include "xabsl/formats/Compile.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using test::errors;

TEST(Compile, FollowsIncludesRelativeToTheIncludingFileAndEachOnce) {
  const VirtualFiles files = {
      {"a/agents.xabsl",
       "include \"options\\main.xabsl\"; include \"symbols.xabsl\"; agent m(\"M\", main);"},
      {"a/symbols.xabsl", "namespace symbols(\"S\") { float input x; }"},
      {"a/options/main.xabsl",
       "include \"../symbols.xabsl\"; include \"../agents.xabsl\";"
       "option main { initial state s { decision { if (x > 0) stay; else stay; } action { } } }"}};
  const Compilation compilation = compile("a/agents.xabsl", files);
  EXPECT_EQ(errors(compilation.diagnostics), "");
  EXPECT_TRUE(compilation.diagnostics.empty());
  ASSERT_TRUE(compilation.behavior);
  EXPECT_EQ(compilation.behavior->model().files.size(), 3u);
}

TEST(Compile, TellsWhichIncludeIsMissing) {
  const Compilation compilation = compile("a.xabsl", {{"a.xabsl", "\n  include \"b/c.xabsl\";"}});
  EXPECT_EQ(errors(compilation.diagnostics),
            "a.xabsl:2:11: cannot include 'b/c.xabsl': there is no such file\n");
  EXPECT_FALSE(compilation.behavior);
}

TEST(Compile, TellsThatAFileIsMissing) {
  EXPECT_EQ(errors(compile("/nowhere/agents.xabsl").diagnostics),
            "/nowhere/agents.xabsl: cannot open the file\n");
  EXPECT_EQ(errors(compile("/").diagnostics), "/: cannot open the file\n");
  EXPECT_EQ(errors(compile("/dev/zero").diagnostics), "/dev/zero: cannot open the file\n");
}

TEST(Compile, ReadsFilesFromDisk) {
  const std::filesystem::path folder = testing::TempDir() + "/xabsl_compile";
  std::filesystem::create_directories(folder / "options");
  std::ofstream(folder / "agents.xabsl")
      << "include \"options/main.xabsl\";\nagent main(\"Main\", main);\n";
  std::ofstream(folder / "options/main.xabsl") << "option main { initial state s { action { } } }";
  const Compilation compilation = compile((folder / "agents.xabsl").string());
  EXPECT_EQ(errors(compilation.diagnostics), "");
  EXPECT_TRUE(compilation.behavior);
  std::filesystem::remove_all(folder);
}

TEST(Compile, RefusesFilesThatAreTooLarge) {
  const Compilation compilation =
      compile("a.xabsl", {{"a.xabsl", std::string((2u << 20) + 1, ' ')}});
  EXPECT_EQ(errors(compilation.diagnostics), "a.xabsl: the file is larger than 2 MiB\n");
}

TEST(Compile, WarnsOfFilesWithAnotherName) {
  const Compilation compilation =
      compile("a.xabsl", {{"a.xabsl",
                           "option main { initial state s { action { } } }\n"
                           "agent m(\"M\", main);"}});
  ASSERT_EQ(compilation.diagnostics.size(), 1u);
  EXPECT_EQ(toString(compilation.diagnostics[0]),
            "a.xabsl:1:8: warning: option 'main' stands in a file of another name, expected "
            "'main.xabsl'");
  EXPECT_TRUE(compilation.behavior);
}

}  // namespace
}  // namespace xabsl
