#include "xabsl/language/OptionGraph.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using testing::HasSubstr;

/// The errors in a file that begins with these lines, and declares the agent behind them.
std::string errorsOfGraph(const std::string& text) {
  return test::errorsIn(text + "\nagent main(\"Main\", main);");
}

TEST(OptionGraph, RefusesOptionsThatCallOneAnother) {
  EXPECT_EQ(errorsOfGraph("option main { initial state s { action { a(); } } }\n"
                          "option a { initial state s { action { b(); } } }\n"
                          "option b { common action { a(); } initial state s { action { } } }"),
            "main.xabsl:2:39: options call one another in a cycle: a -> b -> a\n");
  EXPECT_EQ(errorsOfGraph("option main { initial state s { action { main(); } } }"),
            "main.xabsl:1:42: options call one another in a cycle: main -> main\n");
}

TEST(OptionGraph, RefusesOptionsThatMultiplyWithoutBound) {
  std::string text = "option o0 { initial state s { action { } } }\n";
  for (int i = 1; i < 40; ++i) {
    const std::string callee = "o" + std::to_string(i - 1) + "(); ";
    text += "option o" + std::to_string(i) + " { initial state s { action { " + callee + callee +
            "} } }\n";
  }
  EXPECT_THAT(errorsOfGraph("option main { initial state s { action { } } }\n" + text),
              HasSubstr("may execute more than 100000 options and behaviors in a cycle"));
}

TEST(OptionGraph, RefusesPathsOfOptionsThatAreTooLong) {
  std::string text =
      "option main { initial state s { action { } } }\n"
      "option o0 { initial state s { action { } } }\n";
  for (int i = 1; i < 300; ++i)
    text += "option o" + std::to_string(i) + " { initial state s { action { o" +
            std::to_string(i - 1) + "(); } } }\n";
  EXPECT_THAT(errorsOfGraph(text), HasSubstr("the path of options from o200 is longer than 200"));
}

}  // namespace
}  // namespace xabsl
