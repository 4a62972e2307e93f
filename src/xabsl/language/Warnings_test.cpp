#include "xabsl/language/Warnings.h"

#include <gtest/gtest.h>

#include <string>

#include "xabsl/formats/Compile.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

/// The warnings of a sound file, without those about how files are divided.
std::string warningsIn(const std::string& text) {
  const Compilation compilation = compile("main.xabsl", {{"main.xabsl", text}});
  EXPECT_EQ(test::errors(compilation.diagnostics), "");
  std::string all;
  for (const Diagnostic& diagnostic : compilation.diagnostics)
    if (diagnostic.message.find("file of another name") == std::string::npos &&
        diagnostic.message.find("a second namespace") == std::string::npos &&
        diagnostic.message.find("expected one kind only") == std::string::npos)
      all += toString(diagnostic) + "\n";
  return all;
}

const std::string agent = "\nagent a(\"A\", main);";

TEST(Warnings, AreSilentAboutWhatIsMeant) {
  EXPECT_EQ(
      warningsIn("namespace main(\"M\") { bool input x; float input f (float a;); }\n"
                 "option main { initial state s { decision { if (x) goto t; else stay; }\n"
                 "action { sub(v = f(a = 1)); } } state t { decision { goto s; } action { } } }\n"
                 "option sub { float @v; initial state s { action { } } }" +
                 agent),
      "");
}

TEST(Warnings, NameStatesThatAreNeverEntered) {
  EXPECT_EQ(warningsIn("option main { initial state s { action { } }\n"
                       "state t { decision { goto u; } action { } }\n"
                       "state u { action { } } }" +
                       agent),
            "main.xabsl:2:7: warning: state 't' of option 'main' is never entered\n"
            "main.xabsl:3:7: warning: state 'u' of option 'main' is never entered\n");
  EXPECT_EQ(warningsIn("namespace main(\"M\") { bool input x; }\n"
                       "option main { common decision { if (x) goto t; }\n"
                       "initial state s { action { } } state t { action { } } }" +
                       agent),
            "");
}

TEST(Warnings, NameStatesThatCanOnlyOscillate) {
  EXPECT_EQ(warningsIn("namespace main(\"M\") { bool input x; }\n"
                       "option main { initial state s { decision { if (x) goto t; else stay; }\n"
                       "action { } } state t { decision { goto u; } action { } }\n"
                       "state u { decision { if (x) goto t; else goto t; } action { } } }" +
                       agent),
            "main.xabsl:3:20: warning: states of option 'main' can only oscillate: t -> u -> t\n");
}

TEST(Warnings, NameParametersThatAreNotSetOnce) {
  EXPECT_EQ(
      warningsIn("namespace main(\"M\") { enum e { p, q }; float input f (enum e a;);\n"
                 "float output r; behavior walk { bool b; } }\n"
                 "option main { common action { r = f(); } initial state s {\n"
                 "decision { if (r > 0) goto t; else goto u; } action { sub(w = 1); } }\n"
                 "state t { action { walk(b = true); } }\n"
                 "state u { decision { if (r > 0) goto v; else goto w; } action { walk(); } }\n"
                 "state v { action { walk(); } } state w { action { sub(); } } }\n"
                 "option sub { float @v; float @w; initial state s { action { } } }" +
                 agent),
      "main.xabsl:1:62: warning: parameter 'a' of input symbol 'f' is never set, it is 'p'\n"
      "main.xabsl:6:65: warning: parameter 'b' of basic behavior 'walk' is not set, it is "
      "false, as in 1 other call\n"
      "main.xabsl:7:51: warning: parameter 'w' of option 'sub' is not set, it is 0\n"
      "main.xabsl:8:20: warning: parameter 'v' of option 'sub' is never set, it is 0\n");
}

TEST(Warnings, NameWhatIsNeverUsed) {
  EXPECT_EQ(warningsIn("namespace main(\"M\") { bool input x; float output y;\n"
                       "bool internal z; behavior walk { } }\n"
                       "namespace more(\"M\") { bool input a; bool input b; bool output c;\n"
                       "bool output d; bool output e; bool output f; bool output g;\n"
                       "bool output h; bool output i; }\n"
                       "option main { initial state s { action { } } }\n"
                       "option sub { initial state s { action { z = true; } } }\n"
                       "option other { initial state s { action { } } }" +
                       agent),
            "main.xabsl:1:34: warning: input symbol 'x' is never used\n"
            "main.xabsl:1:50: warning: output symbol 'y' is never used\n"
            "main.xabsl:2:27: warning: basic behavior 'walk' is never used\n"
            "main.xabsl:3:34: warning: input symbols 'a' and 'b' are never used\n"
            "main.xabsl:3:63: warning: output symbols 'c', 'd', 'e', 'f', 'g' and 2 others are "
            "never used\n"
            "main.xabsl:7:8: warning: options 'sub' and 'other' are not reached by any agent\n");
}

TEST(Warnings, NameNamesThatOtherEnginesCannotRead) {
  const auto warning = [](std::size_t letters) {
    const std::string name(letters, 'n');
    const Compilation compilation =
        compile(name + ".xabsl", {{name + ".xabsl", "agent a(\"A\", " + name + "); option " + name +
                                                        " { initial state s { action { } } }"}});
    return compilation.diagnostics.empty() ? "" : compilation.diagnostics.front().message;
  };
  EXPECT_EQ(warning(99), "");
  EXPECT_EQ(warning(100),
            "option 'nnnnnnnnnnnnnnnnnnnn'... has 100 letters; other engines read at "
            "most 99");
}

TEST(Warnings, NameWhatIsExecutedTwiceInACycle) {
  const std::string child = "option child { initial state s { action { } } }";
  EXPECT_EQ(warningsIn("option main {\ninitial state s { action { child(); child(); } } }" + child +
                       agent),
            "main.xabsl:2:37: warning: option 'child' is executed twice in a cycle; some engines "
            "refuse such a behavior\n");
  EXPECT_EQ(warningsIn("namespace main(\"M\") { bool input x; behavior walk { } }\n"
                       "option main { common action { walk(); }\n"
                       "initial state s { decision { if (x) goto t; else stay; } action { } }\n"
                       "state t { action { walk(); } } }" +
                       agent),
            "main.xabsl:4:20: warning: basic behavior 'walk' is executed twice in a cycle; some "
            "engines refuse such a behavior\n");
  EXPECT_EQ(warningsIn("namespace main(\"M\") { bool input x; }\n"
                       "option main { initial state s { decision { if (x) goto t; else stay; }\n"
                       "action { child(); } } state t { action { child(); } } }" +
                       child + agent),
            "");
}

TEST(Warnings, ListEverythingUnusedWhereItIsDeclared) {
  const Behavior behavior = test::compiled(
      "namespace main(\"M\") { bool input x;\nfloat output y; behavior walk { } }\n"
      "option main { initial state s { action { y = 1; } } }\n"
      "option sub { initial state s { action { } } }" +
      agent);
  std::string all;
  for (const Diagnostic& diagnostic : everythingUnused(behavior.model()))
    all += toString(diagnostic) + "\n";
  EXPECT_EQ(all,
            "main.xabsl:4:8: warning: option 'sub' is not reached by any agent\n"
            "main.xabsl:1:34: warning: input symbol 'x' is never used\n"
            "main.xabsl:2:26: warning: basic behavior 'walk' is never used\n");
}

}  // namespace
}  // namespace xabsl
