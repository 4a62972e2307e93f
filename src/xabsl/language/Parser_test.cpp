#include "xabsl/language/Parser.h"

#include <gtest/gtest.h>

#include <map>
#include <string>

#include "xabsl/formats/Sources.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

using test::errorsIn;
using test::errorsInAction;
using test::errorsInDecision;
using test::errorsInMain;
using test::errorsInValue;

/// Reads files from memory, beginning with `main.xabsl`, which must be sound.
class Parsed {
 public:
  explicit Parsed(const std::map<std::string, std::string>& files, bool sound = true) {
    const FileReader read = [&](const std::string& path,
                                std::string& text) -> std::optional<std::string> {
      const auto found = files.find(path);
      if (found == files.end()) return "there is no such file";
      text = found->second;
      return std::nullopt;
    };
    Reporter reporter;
    readSources("main.xabsl", read, program, reporter);
    EXPECT_EQ(reporter.failed(), !sound) << test::errors(reporter.take());
  }
  explicit Parsed(const std::string& text)
      : Parsed(std::map<std::string, std::string>{{"main.xabsl", text}}) {}

  syntax::Program program;
};

/// `line:column-line:column`
std::string text(const syntax::Extent& extent) {
  const auto place = [](Location location) {
    return std::to_string(location.line) + ":" + std::to_string(location.column);
  };
  return place(extent.begin) + "-" + place(extent.end);
}

TEST(Parser, KeepsTheHeader) {
  const Parsed parsed(
      "/*** Title:\tPlayers\n * Platform: ERS-210  \n * Software-Environment: any*/\n"
      "agent a(\"The agent\", main);");
  EXPECT_EQ(parsed.program.header.title, "Players");
  EXPECT_EQ(parsed.program.header.platform, "ERS-210");
  EXPECT_EQ(parsed.program.header.softwareEnvironment, "any");
  EXPECT_EQ(parsed.program.agents.front().title, "The agent");
  EXPECT_EQ(Parsed("/*** nothing */").program.header.title, "");
}

TEST(Parser, KeepsDocumentationWithWhatFollows) {
  const syntax::Program program = std::move(
      Parsed("/** space */ namespace n(\"N\") {\n"
             "/** symbol */ float input x [0..1] \"mm\" (/** p */ float a \"s\" [1..2];);\n"
             "/** number */ const c = -1.50 \"kg\"; /** kinds */ enum e internal { a, b }; }\n"
             "/** option */ option o { /** par */ bool @p;\n"
             "/** state */ initial state s { decision { /** first */ if (@p) stay;\n"
             "else /** second */ if (!@p) stay; /** third */ else if (true) stay; else stay; }\n"
             "action { } } } /* no doc */ agent a(\"A\", o);")
          .program);
  EXPECT_EQ(program.namespaces.front().doc, "space");
  EXPECT_EQ(program.namespaces.front().kind, syntax::Namespace::Kind::symbols);
  const syntax::Symbol& symbol = program.symbols.front();
  EXPECT_EQ(symbol.doc, "symbol");
  EXPECT_EQ(symbol.range, "0..1");
  EXPECT_EQ(symbol.unit, "mm");
  EXPECT_EQ(symbol.space, 0);
  EXPECT_EQ(symbol.parameters.front().doc, "p");
  EXPECT_EQ(symbol.parameters.front().range, "1..2");
  EXPECT_EQ(symbol.parameters.front().unit, "s");
  EXPECT_EQ(program.constants.front().doc, "number");
  EXPECT_EQ(program.constants.front().digits, "1.50");
  EXPECT_EQ(program.constants.front().value, -1.5);
  EXPECT_EQ(program.constants.front().unit, "kg");
  EXPECT_EQ(program.enumerations.front().doc, "kinds");
  EXPECT_TRUE(program.enumerations.front().internal);
  const syntax::Option& option = program.options.front();
  EXPECT_EQ(option.doc, "option");
  EXPECT_EQ(option.space, -1);
  EXPECT_EQ(option.parameters.front().doc, "par");
  EXPECT_EQ(option.states.front().doc, "state");
  EXPECT_EQ(option.states.front().decision->arms[0].doc, "first");
  EXPECT_EQ(option.states.front().decision->arms[1].doc, "second");
  EXPECT_EQ(option.states.front().decision->arms[2].doc, "third");
  EXPECT_EQ(program.agents.front().doc, "");
}

TEST(Parser, KnowsWhereElementsBeginAndEnd) {
  const Parsed parsed(
      "namespace n(\"N\") {\n float input x;\n}\n"
      "option o {\n initial state s {\n  decision { if (x + 1 > 2) goto s; else stay; }\n"
      "  action { o(); }\n }\n}");
  const syntax::Program& program = parsed.program;
  EXPECT_EQ(text(program.namespaces.front().extent), "1:1-3:2");
  EXPECT_EQ(text(program.symbols.front().extent), "2:2-2:16");
  EXPECT_EQ(text(program.options.front().extent), "4:1-9:2");
  const syntax::State& state = program.options.front().states.front();
  EXPECT_EQ(text(state.extent), "5:2-8:3");
  EXPECT_EQ(text(state.actions.front().extent), "7:12-7:16");
  EXPECT_EQ(text(state.decision->extent), "6:14-6:47");
  EXPECT_EQ(text(state.decision->arms.front().decision->extent), "6:29-6:36");
  EXPECT_EQ(text(state.decision->arms.front().condition->extent), "6:18-6:27");
}

TEST(Parser, KeepsFilesWithIncludesAndComments) {
  const Parsed parsed(
      {{"main.xabsl", "// one\ninclude \"b.xabsl\"; /* two */ include \"a.xabsl\";"},
       {"a.xabsl", "/** three */ include \"main.xabsl\";"},
       {"b.xabsl", ""}});
  ASSERT_EQ(parsed.program.files.size(), 3u);
  const syntax::File& main = parsed.program.files.front();
  ASSERT_EQ(main.includes.size(), 2u);
  EXPECT_EQ(main.includes[0].path, "b.xabsl");
  EXPECT_EQ(main.includes[1].path, "a.xabsl");
  EXPECT_EQ(parsed.program.files[1].path, "b.xabsl");
  ASSERT_EQ(main.comments.size(), 2u);
  EXPECT_EQ(main.comments[0].kind, syntax::Comment::Kind::line);
  EXPECT_EQ(main.comments[0].text, "// one");
  EXPECT_EQ(main.comments[1].text, "/* two */");
  EXPECT_EQ(text(main.comments[1].extent), "2:20-2:29");
  EXPECT_EQ(parsed.program.files[2].comments.front().kind, syntax::Comment::Kind::documentation);
}

/// While one types, what is whole is known, and of what is open the name.
TEST(Parser, KeepsWhatIsOpen) {
  const auto namesOf = [](const std::string& text) {
    const Parsed parsed{{{"main.xabsl", text}}, false};
    std::string names;
    for (const syntax::Option& option : parsed.program.options) {
      names += std::string{option.name.text} + ":";
      for (const syntax::State& state : option.states) names += " " + std::string{state.name.text};
      names += "\n";
    }
    return names;
  };
  const std::string whole = "{ decision { stay; } action { } }\n";
  EXPECT_EQ(namesOf("option open {\n initial state wait " + whole), "open: wait\n");
  EXPECT_EQ(namesOf("option hold {\n initial state wait " + whole +
                    "state go { decision { if (\n } action { } }\nstate after " + whole + "}\n"),
            "hold: wait go after\n");
  EXPECT_EQ(namesOf("option typed {"), "typed:\n");
}

TEST(Parser, TakesWhatOtherCompilersTook) {
  test::compiled(
      "namespace n(\"N\") { float internal output old; input plain; float input f (a; bool b;);\n"
      "enum a.b { c, a.b.d }; enum a.b output a.b; float input x [px]; const k = 5.; };\n"
      "option main { common decision { { if (x > 1.) stay; else { { if (x > 2) { goto s; } } } } "
      "}\n"
      "initial target state s { decision { else { stay; } } action { } } }\n"
      "agent m(\"M\", main);");
  // Texts over several lines, in Latin-1; a '?:' in another one; functions without parentheses.
  const Behavior behavior = test::compiled(
      "/*** TITLE: T\xE4st */ namespace n(\"two\nlines\") { float input f [0\n..1] \"m\nm\" (a;);\n"
      "float output y; bool input b; } agent m(\"M\", main);\n"
      "option main { initial state s { action { y = b ? b ? 1 : f : 3; } } }");
  EXPECT_EQ(behavior.model().namespaces.front().title, "two\nlines");
  EXPECT_EQ(behavior.model().title, "T\xC3\xA4st");
}

TEST(Parser, KnowsThe30ThatHasNoCooperation) {
  const auto errorOf = [](const std::string& text) {
    return test::errors(
        compile("main.xabsl", {{"main.xabsl", "agent a(\"A\", main);\n" + text}}, Dialect::xabsl30)
            .diagnostics);
  };
  const std::string state =
      "namespace n(\"N\") { bool output conflict; float input capacity; }\n"
      "option main { initial state synchronized { action { ";
  EXPECT_EQ(errorOf(state + "conflict = capacity > 1; } } }"), "");
  EXPECT_EQ(errorOf("option main { initial state s capacity 2 { action { } } }"),
            "main.xabsl:2:31: 'capacity' is of XABSL 3.1, in 3.0 robots do not agree about "
            "states\n");
  EXPECT_EQ(errorOf("option main { initial state s { decision { if (conflict) stay; else stay; }\n"
                    "action { } } }"),
            "main.xabsl:2:48: 'conflict' is of XABSL 3.1 in option main\n");
}

/// All that is reported for a file, without warnings about the names of files.
std::string reported(const std::string& text) {
  std::string all;
  for (const Diagnostic& diagnostic : compile("main.xabsl", {{"main.xabsl", text}}).diagnostics)
    if (diagnostic.message.find("file of another name") == std::string::npos)
      all += toString(diagnostic) + "\n";
  return all;
}

TEST(Parser, ReportsAMissingSemicolonAtTheEndOfItsLine) {
  EXPECT_EQ(reported("agent a(\"A\", main)\noption main { initial state s { action { } } }"),
            "main.xabsl:1:19: expected ';', found the end of the line\n");
  EXPECT_EQ(reported("agent a(\"A\", main);\noption main { initial state s {\n"
                     "action { main() // again\n} } }"),
            "main.xabsl:3:16: expected ';', found the end of the line\n");
  EXPECT_EQ(reported("agent a(\"A\", main) option main { initial state s { action { } } }"),
            "main.xabsl:1:20: expected ';', found 'option'\n");
}

TEST(Parser, WarnsAboutWhatOtherCompilersRefuse) {
  const std::string refused = "; other XABSL compilers refuse this\n";
  EXPECT_EQ(reported("agent a(\"A\", main);\nnamespace n(\"N\") { enum e { a, b }\n"
                     "float const k = 1e3; enum e input i \"mm\"; float input x \"mm\" [0..1]; }\n"
                     "namespace m(\"M\") { float output y; enum e output z; }\n"
                     "option main { common decision { if (x < k) stay; }\n"
                     "initial state s { action { y = 1.5E3; z = i; } } }"),
            "main.xabsl:2:35: warning: an enumeration without ';' behind it" + refused +
                "main.xabsl:3:17: warning: a number with an exponent" + refused +
                "main.xabsl:3:37: warning: the unit of an enumerated symbol" + refused +
                "main.xabsl:3:62: warning: a range behind the unit" + refused +
                "main.xabsl:4:11: warning: a second namespace in this file" + refused +
                "main.xabsl:5:44: warning: 'stay' in a common decision" + refused +
                "main.xabsl:6:32: warning: a number with an exponent" + refused);
}

TEST(Parser, TellsWhatWasExpected) {
  EXPECT_EQ(errorsIn("42"),
            "main.xabsl:1:1: expected 'include', 'option', 'agent' or 'namespace', found "
            "'42'\n");
  EXPECT_EQ(errorsIn("include main;"),
            "main.xabsl:1:9: expected the path of a file in quotes, found 'main'\n");
  EXPECT_EQ(errorsIn("agent a(main);"),
            "main.xabsl:1:9: expected the title of the agent in quotes, found 'main'\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { float x; }"),
            "main.xabsl:1:29: expected 'input', 'output' or 'internal', found 'x'\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { enum e { a, }; }"),
            "main.xabsl:1:35: expected the name of an element, found '}'\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { bool const b = 1; }"),
            "main.xabsl:1:28: constants are of type float\n");
  EXPECT_EQ(errorsIn("namespace main(\"M\") { float output o(float x;); }"),
            "main.xabsl:1:37: only input symbols have parameters\n");
  EXPECT_EQ(errorsIn("option main { float x; }"),
            "main.xabsl:1:21: expected the name of a parameter, as in '@speed', found 'x'\n");
  EXPECT_EQ(errorsIn("option main { }"),
            "main.xabsl:1:15: expected a parameter, 'common' or a state, found '}'\n");
  EXPECT_EQ(errorsIn("option main { state s { decision { stay; } } }"),
            "main.xabsl:1:44: expected 'action', found '}'\n");
  EXPECT_EQ(errorsIn("option main"), "main.xabsl:1:12: expected '{', found the end of the file\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen) stay;"),
            "3:1: expected 'else', since each decision has an end ('else stay;'), found '}'\n");
  EXPECT_EQ(errorsInDecision("if ball.seen stay;"), "2:4: expected '(', found 'ball.seen'\n");
  EXPECT_EQ(errorsInDecision("go s;"), "2:1: expected 'if', 'goto', 'stay' or '{', found 'go'\n");
  EXPECT_EQ(errorsInAction("input = 1;"),
            "2:1: expected an action (an assignment, an option or a basic behavior) or '}', "
            "found the keyword 'input'\n");
  EXPECT_EQ(errorsInAction("speed;"), "2:6: expected '=' or '(', found ';'\n");
  EXPECT_EQ(errorsInAction("sub(1);"),
            "2:5: expected the name of a parameter, as in 'speed = 100', found '1'\n");
  EXPECT_EQ(errorsInAction("sub(v = 1 b = true);"), "2:11: expected ',' or ')', found 'b'\n");
  EXPECT_EQ(errorsInValue("1 +"), "2:12: expected an expression, found ';'\n");
  EXPECT_EQ(errorsInValue("1 < 2 < 3"), "2:15: comparisons cannot be chained, use '&&'\n");
  EXPECT_EQ(errorsInValue("true ? 1 : true ? 2 : 3"),
            "2:25: a '?:' inside another one needs parentheses\n");
}

TEST(Parser, TellsWhatBeginnersMeant) {
  EXPECT_EQ(errorsInDecision("if (how = fast) stay; else stay;"),
            "2:9: expected ')', found '='; did you mean '=='?\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen & ball.seen) stay; elseif (true) stay;"),
            "2:15: unexpected character '&'; did you mean '&&'?\n"
            "2:34: expected 'else', since each decision has an end ('else stay;'), found "
            "'elseif'; did you mean 'else if'?\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen and true) stay; else stay;"),
            "2:15: expected ')', found 'and'; did you mean '&&'?\n");
  EXPECT_EQ(errorsInDecision("if (ball.seen) stay; els stay;"),
            "2:22: expected 'else', since each decision has an end ('else stay;'), found "
            "'els'; did you mean 'else'?\n");
  EXPECT_EQ(errorsInDecision("goto sub;"),
            "2:6: unknown state 'sub' in option main; options are called by actions\n");
  EXPECT_EQ(errorsInAction("speed = 1,5;"),
            "2:10: expected ';', found ','; numbers are written with a point\n");
  EXPECT_EQ(errorsInAction("head = \"fast\";"),
            "2:8: expected an expression, found a string; elements of enumerations stand "
            "without quotes\n");
  EXPECT_EQ(errorsInAction("s();"),
            "2:1: unknown option or basic behavior 's' in option main; a state is entered by a "
            "decision\n");
  EXPECT_EQ(errorsInMain("option main { float @v; initial state s { action { speed = v; } } }"),
            "1:60: unknown input symbol 'v' in option main; did you mean '@v'?\n");
  EXPECT_EQ(errorsInMain("option main { initial state s { action { } decision { stay; } } }"),
            "1:44: the decision of a state stands before its action\n");
}

TEST(Parser, ReadsCooperation) {
  const Behavior behavior = test::compiled(
      "option main { initial state s capacity 2 { decision { if (conflict) goto t; else stay; }\n"
      "action { } } state t synchronized { action { } } state u synchronized 3 { action { } } }\n"
      "agent a(\"A\", main);");
  const std::vector<State>& states = behavior.model().states;
  EXPECT_EQ(states[0].cooperation.kind, Cooperation::Kind::capacity);
  EXPECT_EQ(states[0].cooperation.agents, 2);
  EXPECT_EQ(states[1].cooperation.kind, Cooperation::Kind::synchronized);
  EXPECT_EQ(states[1].cooperation.agents, 0);
  EXPECT_EQ(states[2].cooperation.agents, 3);
  EXPECT_EQ(errorsInMain("option main { initial state s capacity { action { } } }"),
            "1:40: expected the number of agents, found '{'\n");
  EXPECT_EQ(errorsInMain("option main { initial state s capacity 1.5 { action { } } }"),
            "1:40: the number of agents is a whole number up to 1000\n");
}

TEST(Parser, FindsSeveralSyntaxErrorsInOneRun) {
  EXPECT_EQ(errorsInMain("namespace main(\"M\") {\n float x;\n float input y;\n bool z;\n}\n"
                         "option main {\n initial state s { action { speed = ; led = 1 1; } }\n"
                         " state t { decision { goto; } action { } }\n state u { action { } } }\n"
                         "agent a(main);\nagent b(\"B\", main);\n"),
            "2:8: expected 'input', 'output' or 'internal', found 'x'\n"
            "4:7: expected 'input', 'output' or 'internal', found 'z'\n"
            "7:37: expected an expression, found ';'\n"
            "7:47: expected ';', found '1'\n"
            "8:27: expected the name of a state, found ';'\n"
            "10:9: expected the title of the agent in quotes, found 'main'\n");
}

}  // namespace
}  // namespace xabsl
