#include "xabsl/language/Diagnostic.h"

#include <gtest/gtest.h>

#include <string>

#include "xabsl/formats/Compile.h"

namespace xabsl {
namespace {

TEST(Diagnostic, ShowsTheLineWithACaret) {
  const Compilation compilation =
      compile("main.xabsl", {{"main.xabsl", "option main {\n\tinitial ställe s { } }"}});
  ASSERT_GE(compilation.diagnostics.size(), 2u);
  EXPECT_EQ(toStringWithSource(compilation.diagnostics[1]),
            "main.xabsl:2:12: unexpected character with code 195\n"
            " 2 | \tinitial ställe s { } }\n"
            "   | \t          ^");
}

TEST(Diagnostic, SaysWhereAndHowBad) {
  const Diagnostic error{Diagnostic::Severity::error, "a.xabsl", 3, 7, "unknown state"};
  const Diagnostic warning{Diagnostic::Severity::warning, "a.xabsl", 0, 0, "never used"};
  EXPECT_EQ(toString(error), "a.xabsl:3:7: unknown state");
  EXPECT_EQ(toString(warning), "a.xabsl: warning: never used");
  EXPECT_TRUE(fails({warning, error}));
  EXPECT_FALSE(fails({warning}));
  EXPECT_TRUE(fails({warning}, true));
  EXPECT_FALSE(fails({}, true));
}

TEST(Diagnostic, CutsLongQuotes) {
  EXPECT_EQ(inQuotes("short"), "'short'");
  EXPECT_EQ(inQuotes(std::string(81, 'x')), "'" + std::string(80, 'x') + "...'");
}

}  // namespace
}  // namespace xabsl
