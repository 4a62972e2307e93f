#include "xabsl/formats/intermediate/SymbolsHeader.h"

#include <gtest/gtest.h>

#include <string>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

TEST(SymbolsHeader, MakesNamesOfCppThatDoNotMeet) {
  const Behavior named = test::compiled(
      "namespace s(\"S\") { enum do_it output { switch_, a.b, a_b, x2 }; enum inputs output { k };"
      "enum do_it output do_it; float input ball.seen_x [0..1] \"mm\"; float input ball.seen.x;"
      "/** how\n * it is\\ */ float input new(float new \"deg\"; bool class;); }"
      "namespace b(\"B\") { behavior go_to { enum do_it what; bool execute; } }"
      "option o { initial state s { action { } } } agent a(\"A\", o);");
  const std::string header = writeSymbolsHeader(
      named.model(), {"robot", {{"inputs", "our::Inputs"}}, {}, {"our/Inputs.h"}});
  for (const std::string expected :
       {"#include \"our/Inputs.h\"", "namespace robot {",
        "enum class DoIt { switch_, aB, aB_2, x2 };", "using Inputs_ = our::Inputs;",
        "  /// In [0..1] mm\n  virtual double ballSeenX() const = 0;",
        "virtual double ballSeenX_2() const = 0;",
        "  /// how\n  /// it is\n  /// `new`: In deg\n  virtual double new_(double new_, bool "
        "class_) "
        "const = 0;",
        "virtual void setDoIt(DoIt value) = 0;",
        "class GoTo {\n public:\n  DoIt what{};\n  bool execute_2{};",
        "xabsl::parameter(\"execute\", &GoTo::execute_2)",
        "struct BasicBehaviors {\n  GoTo& goTo;\n};", "{DoIt::aB_2, \"a_b\"}",
        "symbols.input(\"new\", {\"new\", \"class\"}, "
        "[&inputs](double p0, bool p1) { return inputs.new_(p0, p1); });"})
    EXPECT_NE(header.find(expected), std::string::npos) << expected << "\n" << header;
}

TEST(SymbolsHeader, WritesNamesInCapitalsAsOthersAndReservesNone) {
  const Behavior named = test::compiled(
      "namespace s(\"S\") { enum MODE output { LEFT, GO_RIGHT, X2, _default_, default }; "
      "enum MODE output MODE; }"
      "option o { initial state s { action { } } } agent a(\"A\", o);");
  const std::string header = writeSymbolsHeader(named.model(), {});
  EXPECT_NE(header.find("enum class Mode { left, goRight, x2, default_, default_2 };"),
            std::string::npos)
      << header;
  EXPECT_EQ(header.find("__"), std::string::npos) << header;
}

}  // namespace
}  // namespace xabsl
