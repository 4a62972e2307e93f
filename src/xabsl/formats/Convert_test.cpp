#include "xabsl/formats/Convert.h"

#include <gtest/gtest.h>

#include <optional>
#include <random>
#include <string>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/formats/intermediate/IntermediateCode.h"
#include "xabsl/tests/RandomBehavior.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

std::string codeOf(const Compilation& compilation) {
  EXPECT_EQ(test::errors(compilation.diagnostics), "");
  if (!compilation.behavior) return "does not compile";
  const IntermediateCode code = writeIntermediateCode(compilation.behavior->model());
  return code.text ? *code.text : test::errors(code.diagnostics);
}

/// Converts files in memory; their root is `in`, the new one `out`.
VirtualFiles converted(const VirtualFiles& files, const std::string& in, Form form,
                       const std::string& out) {
  const Conversion conversion = convert(in, files, form, out);
  EXPECT_EQ(test::errors(conversion.diagnostics), "");
  return conversion.files ? *conversion.files : VirtualFiles();
}

std::string reportedBy(const std::string& text) {
  return test::errors(
      convert("main.xabsl", {{"main.xabsl", text}}, Form::xml21, "main.xml").diagnostics);
}

TEST(Convert, TheReportsBehaviorGoesRound) {
  const Conversion first =
      convert("src/xabsl/tests/data/report/agents.xml", Form::text31, "agents.xabsl");
  ASSERT_TRUE(first.files) << test::errors(first.diagnostics);
  const VirtualFiles xml = converted(*first.files, "agents.xabsl", Form::xml21, "agents.xml");
  const VirtualFiles text = converted(xml, "agents.xml", Form::text31, "agents.xabsl");
  EXPECT_EQ(*first.files, text);
  EXPECT_EQ(converted(text, "agents.xabsl", Form::xml21, "agents.xml"), xml);
  EXPECT_EQ(codeOf(compile("agents.xabsl", text)), codeOf(compile("agents.xml", xml)));
  // But for the hyphens of its names it is the same behavior, with all that is for people.
  const Model original = compile("src/xabsl/tests/data/report/agents.xml").behavior->model();
  const Model last = compile("agents.xabsl", text).behavior->model();
  ASSERT_EQ(original.decisions.size(), last.decisions.size());
  for (std::size_t i = 0; i < last.decisions.size(); ++i)
    EXPECT_EQ(original.decisions[i].doc, last.decisions[i].doc);
  EXPECT_EQ(original.title, last.title);
  EXPECT_EQ(original.symbols[1].unit, last.symbols[1].unit);
  EXPECT_EQ(original.behaviors[0].parameters[1].range, last.behaviors[0].parameters[1].range);
  EXPECT_NE(text.at("Options/move_around.xabsl").find("/* Overwrites what the options above"),
            std::string::npos);
}

TEST(Convert, TheSoccerBehaviorStaysTheSameAsText) {
  const Conversion conversion = convert("behavior/GT2003.xabsl", Form::text31, "GT2003.xabsl");
  ASSERT_TRUE(conversion.files) << test::errors(conversion.diagnostics);
  EXPECT_EQ(codeOf(compile("GT2003.xabsl", *conversion.files)),
            codeOf(compile("behavior/GT2003.xabsl")));
}

const std::string declarations = R"(
  namespace symbols("S") {
    enum mode { slow, fast };
    enum kind internal { one, two };
    float input x;
    bool input seen;
    float input sum (float a; float b;);
    enum mode input drive;
    enum mode output request;
    float output speed;
  }
  namespace behaviors("B") { behavior go { float v; } behavior say { bool loud; } }
  agent main("Main", main);
)";

TEST(Convert, TellsWhatCannotBeSaidIn21) {
  const std::string reported = reportedBy(declarations + R"(
    option other { initial state s { action { go(); } } }
    option main {
      initial state s capacity 2 {
        decision { if (seen && true) goto t; else if (drive != request) stay; else goto s; }
        action { go(); other(); }
      }
      state t { action { other(); request = fast; } }
      state u { action { request = drive; } }
      state v { action { go(v = speed); } }
    }
  )");
  for (const char* expected :
       {"main.xabsl:4:10: XABSL 2.1 cannot say this: an enumeration without a symbol",
        "an output symbol that is not enumerated", "a parameter that is not decimal",
        "a state in which robots cooperate", "'true' and 'false' in an expression",
        "an enumerated symbol that is not compared with an element",
        "a second option or basic behavior in a state",
        "an output symbol set after an option is called",
        "a state without option or basic behavior", "an output symbol that is read"})
    EXPECT_NE(reported.find(expected), std::string::npos) << expected << " in\n" << reported;
}

/// Writes a behavior at random, of what both forms can express.
class Generator {
 public:
  explicit Generator(unsigned seed) : random_(seed) {}

  std::string behavior() {
    std::string text = R"(
      /*** Title: A & B <"c"> Platform */
      // a comment -- with hyphens
      namespace symbols("Symbols & <more>") {
        /** of "speed" & <mode>
            on two lines */
        enum mode { slow, mode.fast, stop };
        enum mode input drive;
        enum mode output request;
        enum mode output other;
        enum gear { first, second };
        enum gear input gear;
        float input x "mm";
        float input y;
        bool input seen;
        bool input near;
        float input sum (/** left */ float a [0..1] "m"; float b;);
        /* constants */
        float const limit = -2.5 "mm/s";
        const tiny = 0.001;
      }
      namespace behaviors("Behaviors") {
        behavior go { float v [0..100] "mm"; float w; }
        behavior wait { }
      }
      agent one("One", o0);
      /** the second "agent" */
      agent two("Two", o1);
    )";
    for (int i = 0; i < 4; ++i) text += option(i);
    return text;
  }

 private:
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(random_); }
  std::string pick(std::vector<std::string> choices) {
    return choices[static_cast<std::size_t>(below(static_cast<int>(choices.size())))];
  }

  std::string option(int index) {
    index_ = index;
    common_ = below(3) == 0;
    states_ = 1 + below(4);
    std::string text = pick({"", "/** an option */ ", "/* note */ "}) + "option o" +
                       std::to_string(index) + " { float @p [0..9] \"s\"; float @q; ";
    if (common_)
      text += "common decision { if (" + condition(2) + ") " + transition(false) +
              pick({"", " /** or */ else if (" + condition(1) + ") " + transition(false)}) + " }";
    if (below(3) == 0) text += "common action { other = " + pick({"slow", "mode.fast"}) + "; }";
    for (int i = 0; i < states_; ++i) text += state(i);
    return text + "}\n";
  }

  std::string state(int i) {
    std::string text = std::string(i == 0 ? " initial" : "") + pick({" ", " target "}) + "state s" +
                       std::to_string(i) + " {";
    if (below(5) > 0) text += " decision { " + std::string(common_ ? "else " : "") + tree(3) + " }";
    text += " action { " + pick({"", "request = slow; ", "request = stop; /* x */ "});
    // Options call only those behind them: no circles.
    if (index_ < 3 && below(2) == 0)
      text += "o" + std::to_string(index_ + 1 + below(3 - index_)) + "(q = " + number(3) + ");";
    else
      text += pick({"wait();", "go(w = " + number(2) + ", v = " + number(3) + ");"});
    return text + " } }\n";
  }

  std::string transition(bool maySay = true) {
    if (maySay && below(4) == 0) return "stay;";
    return "goto s" + std::to_string(below(states_)) + ";";
  }

  std::string tree(int depth) {
    if (depth == 0 || below(3) == 0) return transition();
    std::string text = pick({"", "/** why -- & <so> */ "}) + "if (" + condition(3) + ") { " +
                       tree(depth - 1) + " }";
    if (below(2) == 0) text += " else if (" + condition(2) + ") " + transition();
    return text + " else { " + tree(depth - 1) + " }";
  }

  std::string condition(int depth) {
    if (depth == 0)
      return pick(
          {"seen", "near", "drive == slow", "drive != stop", "gear == second", "action_done"});
    switch (below(4)) {
      case 0:
        return "(" + condition(depth - 1) + pick({" && ", " || "}) + condition(depth - 1) + ")";
      case 1:
        return "!(" + condition(depth - 1) + ")";
      case 2:
        return condition(depth - 1) + " && " + condition(depth - 1);
      default:
        return number(depth - 1) + pick({" < ", " <= ", " > ", " >= ", " == ", " != "}) +
               number(depth - 1);
    }
  }

  std::string number(int depth) {
    if (depth == 0)
      return pick({"x", "y", "12", "0.25", "-3", "1e2", "limit", "tiny", "@p", "@q", "state_time",
                   "option_time"});
    switch (below(4)) {
      case 0:
        return "(" + number(depth - 1) + pick({" + ", " - ", " * ", " / "}) + number(depth - 1) +
               ")";
      case 1:
        return "sum(b = " + number(depth - 1) + ", a = " + number(depth - 1) + ")";
      case 2:
        return "(" + condition(depth - 1) + " ? " + number(depth - 1) + " : " + number(depth - 1) +
               ")";
      default:
        return number(depth - 1);
    }
  }

  std::mt19937 random_;
  int index_ = 0;
  int states_ = 1;
  bool common_ = false;
};

/// What a behavior does with inputs at random.
std::string run(const VirtualFiles& files, const std::string& root) {
  double x = 0, y = 0;
  bool seen = false, near = false;
  int drive = 0, gear = 0, request = 0, other = 0;
  std::string log;
  Symbols symbols;
  symbols.enumeration("mode", {"slow", "fast", "stop"});
  symbols.enumeration("gear", {"first", "second"});
  symbols.input("x", &x);
  symbols.input("y", &y);
  symbols.input("seen", &seen);
  symbols.input("near", &near);
  symbols.inputIndex("drive", "mode", [&] { return drive; });
  symbols.inputIndex("gear", "gear", [&] { return gear; });
  symbols.input("sum", {"a", "b"}, [](double a, double b) { return a + 2 * b; });
  symbols.outputIndex("request", "mode", [&](int value) { request = value; });
  symbols.outputIndex("other", "mode", [&](int value) { other = value; });
  symbols.behavior("go", {"v", "w"}, [&](double v, double w) {
    log += "go " + std::to_string(v) + " " + std::to_string(w) + "\n";
  });
  symbols.behavior("wait", [&] { log += "wait\n"; });
  Engine::Creation creation = Engine::create(*compile(root, files).behavior, symbols);
  EXPECT_EQ(test::errors(creation.diagnostics), "");
  std::mt19937 random(7);
  for (int cycle = 0; cycle < 50; ++cycle) {
    x = static_cast<double>(random() % 20) - 10;
    y = static_cast<double>(random() % 300);
    seen = random() % 2 == 0;
    near = random() % 3 == 0;
    drive = static_cast<int>(random() % 3);
    gear = static_cast<int>(random() % 2);
    creation.engine->execute(cycle * 20);
    log += toString(creation.engine->activations()) + std::to_string(request) +
           std::to_string(other) + "\n";
  }
  return log;
}

TEST(Convert, BehaviorsAtRandomGoRound) {
  for (unsigned seed = 1; seed <= 25 && !HasFailure(); ++seed) {
    const VirtualFiles text = {{"a.xabsl", Generator(seed).behavior()}};
    const VirtualFiles xml = converted(text, "a.xabsl", Form::xml21, "a.xml");
    const VirtualFiles back = converted(xml, "a.xml", Form::text31, "a.xabsl");
    const std::string code = codeOf(compile("a.xabsl", text));
    EXPECT_EQ(codeOf(compile("a.xml", xml)), code) << text.at("a.xabsl");
    EXPECT_EQ(codeOf(compile("a.xabsl", back)), code);
    EXPECT_EQ(run(xml, "a.xml"), run(text, "a.xabsl"));
    EXPECT_EQ(converted(back, "a.xabsl", Form::text31, "a.xabsl"), back);
    EXPECT_EQ(converted(xml, "a.xml", Form::xml21, "a.xml"),
              converted(back, "a.xabsl", Form::xml21, "a.xml"));
  }
}

TEST(Convert, AllThatCanBeSaidGoesThroughTheXmlOf31) {
  for (unsigned seed = 1; seed <= 25 && !HasFailure(); ++seed) {
    const std::string source = test::RandomBehavior(seed).write();
    const VirtualFiles text = {{"a.xabsl", source}};
    const std::string code = codeOf(compile("a.xabsl", text));
    const VirtualFiles xml = converted(text, "a.xabsl", Form::xml31, "a.xml");
    EXPECT_EQ(codeOf(compile("a.xml", xml)), code) << source;
    const VirtualFiles back = converted(xml, "a.xml", Form::text31, "a.xabsl");
    EXPECT_EQ(codeOf(compile("a.xabsl", back)), code);
    EXPECT_EQ(codeOf(compile("b.xabsl", converted(text, "a.xabsl", Form::text31, "b.xabsl"))),
              code);
    EXPECT_EQ(converted(back, "a.xabsl", Form::xml31, "a.xml"), xml);
    EXPECT_EQ(converted(xml, "a.xml", Form::xml31, "a.xml"), xml);
    EXPECT_EQ(codeOf(readIntermediateCode("a.dat", code)), code);
  }
}

TEST(Convert, KeepsNamesApartThatAreTheSameElsewhere) {
  const VirtualFiles text = {
      {"a.xabsl",
       "namespace options(\"O\") { enum e { x, k }; float input x; float output x; const k = 2;\n"
       "bool output k; enum e input mode; enum e output mode; }\n"
       "namespace behaviors(\"B\") { behavior go { float x; } }\n"
       "option go { float @x; initial state x { action { go behavior(x = @x); } } }\n"
       "option behaviors { initial state s { decision { if (mode() == x) goto s; else stay; }\n"
       "action { x = x() + 1; mode = x; go option(x = 1); } } }\n"
       "agent go(\"A\", behaviors);"}};
  const std::string code = codeOf(compile("a.xabsl", text));
  const VirtualFiles xml = converted(text, "a.xabsl", Form::xml31, "a.xml");
  EXPECT_EQ(codeOf(compile("a.xml", xml)), code);
  EXPECT_EQ(codeOf(compile("a.xabsl", converted(xml, "a.xml", Form::text31, "a.xabsl"))), code);
  const Conversion taken = convert("a.xabsl", text, Form::xml31, "options.xml");
  EXPECT_FALSE(taken.files);
}

TEST(Convert, TheSoccerBehaviorGoesThroughTheXmlOf31) {
  const Conversion xml = convert("behavior/GT2003.xabsl", Form::xml31, "GT2003.xml");
  ASSERT_TRUE(xml.files) << test::errors(xml.diagnostics);
  const std::string code = codeOf(compile("behavior/GT2003.xabsl"));
  EXPECT_EQ(codeOf(compile("GT2003.xml", *xml.files)), code);
  const VirtualFiles text = converted(*xml.files, "GT2003.xml", Form::text31, "GT2003.xabsl");
  EXPECT_EQ(codeOf(compile("GT2003.xabsl", text)), code);
}

}  // namespace
}  // namespace xabsl
