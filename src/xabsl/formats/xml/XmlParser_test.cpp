#include "xabsl/formats/xml/XmlParser.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/formats/Convert.h"
#include "xabsl/tests/TestBehavior.h"

/// XABSL 2.1 in XML: the report's own examples, in the folder `tests/data`, and what may be wrong
/// with them.
namespace xabsl {
namespace {

const std::filesystem::path folder = "src/xabsl/tests/data";

std::string contents(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

VirtualFiles reportFiles() {
  VirtualFiles files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder / "report"))
    if (entry.is_regular_file())
      files[entry.path().lexically_relative(folder / "report").generic_string()] =
          contents(entry.path());
  return files;
}

enum class Pet { dog, cat, guineaPig };
enum class Gait { slow, fast, veryFast };
enum class HeadMode { searchForBall, lookAtBall };

/// What the report's examples expect of their surroundings.
class ReportTest : public testing::Test {
 protected:
  ReportTest() {
    symbols.enumeration<Pet>("type-of-recognized-pet", {"dog", "cat", "guinea-pig"});
    symbols.enumeration<Gait>("op-mode", {"slow", "fast", "very-fast"});
    symbols.enumeration<HeadMode>("head-control-mode", {"search-for-ball", "look-at-ball"});
    symbols.input("something-wrong", &wrong);
    symbols.input("foo", &foo);
    symbols.input("abs", {"value"}, [](double value) { return std::abs(value); });
    symbols.input("type-of-recognized-pet", &pet);
    symbols.input("ball.time-since-last-seen", &timeSinceSeen);
    symbols.input("ball.distance", &distance);
    symbols.output("op-mode", [this](Gait value) {
      mode = value;
      ++modeChanges;
    });
    symbols.output("head-control-mode", &headMode);
    symbols.behavior("move-to", {"x", "y"}, [this](double x, double y) {
      targetX = x;
      targetY = y;
      modeWhileExecuted = mode;
    });
    symbols.behavior("wait", [] {});
    symbols.behavior("go-to-ball", [] {});
    const Compilation compilation = compile((folder / "report/agents.xml").generic_string());
    EXPECT_EQ(test::errors(compilation.diagnostics), "");
    Engine::Creation creation = Engine::create(*compilation.behavior, symbols);
    EXPECT_EQ(test::errors(creation.diagnostics), "");
    engine.emplace(std::move(*creation.engine));
  }

  std::string stateAt(std::int64_t time) {
    engine->execute(time);
    return engine->activations().front().state;
  }

  bool wrong = false;
  double foo = 20;
  Pet pet = Pet::dog;
  double timeSinceSeen = 0;
  double distance = 2000;
  Gait mode = Gait::slow;
  int modeChanges = 0;
  Gait modeWhileExecuted = Gait::slow;
  HeadMode headMode = HeadMode::searchForBall;
  double targetX = 0;
  double targetY = 0;
  Symbols symbols;
  std::optional<Engine> engine;
};

TEST_F(ReportTest, GoalieMakesTheTransitionsOfTheReport) {
  ASSERT_TRUE(engine->selectAgent("goalie"));
  EXPECT_EQ(stateAt(0), "stay-in-goal");
  EXPECT_EQ(headMode, HeadMode::lookAtBall);
  distance = 899;
  EXPECT_EQ(stateAt(1), "get-to-ball");
  EXPECT_EQ(headMode, HeadMode::searchForBall);
  distance = 900;
  EXPECT_EQ(stateAt(2), "get-to-ball") << "900 is not greater than 900";
  distance = 150;
  EXPECT_EQ(stateAt(3), "get-to-ball") << "150 is not less than 150";
  distance = 149;
  EXPECT_EQ(stateAt(4), "clear-ball");
  EXPECT_EQ(stateAt(5), "get-to-ball");
  distance = 901;
  EXPECT_EQ(stateAt(6), "return-to-goal");
  distance = 100;
  EXPECT_EQ(stateAt(7), "stay-in-goal");
  timeSinceSeen = 2000;
  EXPECT_EQ(stateAt(8), "get-to-ball");
  EXPECT_EQ(stateAt(9), "return-to-goal") << "the ball was not seen for 2 s";
}

TEST_F(ReportTest, OutputSymbolsAreAppliedAfterTheWholeGraph) {
  EXPECT_EQ(stateAt(0), "first-state");
  EXPECT_EQ(targetX, 42);
  EXPECT_EQ(targetY, 0) << "a parameter that is not set is zero";
  EXPECT_EQ(mode, Gait::fast);
  foo = 13;
  modeChanges = 0;
  EXPECT_EQ(stateAt(10), "second-state");
  EXPECT_DOUBLE_EQ(targetY, 314) << "the parameter of the option, 3.14 * 100";
  EXPECT_EQ(modeWhileExecuted, Gait::fast) << "not yet applied";
  EXPECT_EQ(mode, Gait::veryFast) << "the option further down overwrites";
  EXPECT_EQ(modeChanges, 1);
  EXPECT_EQ(stateAt(109), "second-state");
  EXPECT_EQ(stateAt(110), "second-state") << "the target state is reached in this cycle";
  EXPECT_EQ(stateAt(111), "first-state");
}

TEST_F(ReportTest, EachKindOfExpressionIsEvaluated) {
  ASSERT_TRUE(engine->selectAgent("test-behavior"));
  foo = 27;
  EXPECT_EQ(stateAt(0), "numbers");
  EXPECT_EQ(stateAt(500), "numbers");
  EXPECT_EQ(targetX, 27 % 10 + (9 - 1) / 2);
  EXPECT_EQ(targetY, 500) << "the time of the option's execution";
  foo = -3;
  stateAt(600);
  EXPECT_EQ(targetY, 3) << "abs()";
  pet = Pet::cat;
  EXPECT_EQ(stateAt(700), "cat-seen");
  pet = Pet::guineaPig;
  EXPECT_EQ(stateAt(800), "numbers");
  EXPECT_EQ(stateAt(1800), "numbers");
  EXPECT_EQ(stateAt(1801), "cat-seen");
  wrong = true;
  foo = 1;
  distance = -1.5;
  EXPECT_EQ(stateAt(1802), "numbers");
}

TEST(XmlParser, KeepsWhatIsForPeople) {
  const Compilation compilation = compile((folder / "report/agents.xml").generic_string());
  ASSERT_TRUE(compilation.behavior);
  const Model& model = compilation.behavior->model();
  EXPECT_EQ(model.dialect, Dialect::xabsl21);
  EXPECT_EQ(model.title, "My XABSL behavior application");
  EXPECT_EQ(model.platform, "My robot/agent platform.");
  EXPECT_EQ(model.softwareEnvironment, "My software platform");
  EXPECT_EQ(model.agents[1].title, "Test");
  EXPECT_EQ(model.agents[1].doc, "A test environment for the option bla");
  EXPECT_EQ(model.namespaces[0].title, "My Symbols");
  EXPECT_EQ(model.behaviors[0].parameters[0].name, "x");
  EXPECT_EQ(model.behaviors[0].parameters[0].range, "-1000..1000");
  EXPECT_EQ(model.behaviors[0].parameters[0].unit, "mm");
  EXPECT_EQ(model.constants[0].digits, "3.14");
  EXPECT_EQ(model.constants[0].unit, "rad");
  EXPECT_EQ(model.files.size(), 8u);
}

TEST(XmlParser, TellsEachFaultAtItsPlace) {
  std::ifstream table(folder / "faults.txt");
  std::string line, file, from, to;
  int faults = 0;
  while (std::getline(table, line)) {
    const std::string rest = line.size() > 2 ? line.substr(2) : "";
    if (line.substr(0, 5) == "file ") file = line.substr(5);
    if (line.substr(0, 1) == "-") from = rest;
    if (line.substr(0, 1) == "+") to = rest;
    if (line.substr(0, 1) != "!") continue;
    ++faults;
    VirtualFiles files = reportFiles();
    std::string& text = files.at(file);
    const std::size_t place = text.find(from);
    ASSERT_NE(place, std::string::npos) << from;
    text.replace(place, from.size(), to);
    const std::string reported = test::errors(compile("agents.xml", files).diagnostics);
    if (rest == "valid")
      EXPECT_EQ(reported, "") << to;
    else
      EXPECT_NE(reported.find(rest), std::string::npos)
          << "instead of " << rest << "\nreported " << reported;
  }
  EXPECT_GT(faults, 60);
}

TEST(XmlParser, TellsFaultsInTheXmlOf31) {
  const VirtualFiles text = {
      {"a.xabsl",
       "namespace n(\"N\") { enum e { p, q }; enum e input m; float input x; bool output o; }\n"
       "namespace b(\"B\") { behavior go { float v; enum e w; } }\n"
       "option main { initial state s capacity 2 { decision { if (m == p) goto s; else stay; }\n"
       "action { o = x < 1 || conflict; go(v = x, w = q); } } } agent a(\"A\", main);"}};
  const VirtualFiles xml = *convert("a.xabsl", text, Form::xml31, "a.xml").files;
  const std::string main = "Options/main.xml", symbols = "Symbols/n.xml";
  const std::vector<std::tuple<std::string, std::string, std::string, std::string>> faults = {
      {main, "<conflict/>", "<conflicts/>", "element 'conflicts': This element is not expected"},
      {main, "capacity=\"2\"", "capacity=\"two\"", "'two' is not accepted by the pattern"},
      {main, "capacity=\"2\"", "capacity=\"2.5\"", "the number of agents is a whole number"},
      {main, "ref=\"e.p\"", "ref=\"e.r\"", "unknown element 'e.r' of an enumeration"},
      {main, "ref=\"o\"", "ref=\"x\"", "'x' is no boolean-output-symbol, but of the kind"},
      {main, "ref=\"x\"", "ref=\"y\"", "unknown decimal-input-symbol 'y'"},
      {main, "ref=\"go.v\"", "ref=\"go.u\"", "basic behavior 'go' has no parameter 'u'"},
      {main, "<decision-tree>", "<else/><decision-tree>", "element 'else'"},
      {main, "<else>", "<else><decimal-value value=\"1\"/>", "element 'decimal-value'"},
      {main, "  &n;\n", "", "unknown boolean-output-symbol 'o'"},
      {main, "&n;", "&m;", "entity 'm' is not declared in symbol-and-basic-behavior-files.dtd"},
      {main, "xabsl.de", "xabsl.com", "element 'option' is not of the namespace"},
      {symbols, "enumeration=\"e\"", "", "attribute 'enumeration' is required but missing"},
      {symbols, "enumeration=\"e\"", "enumeration=\"f\"", "unknown enumeration 'f'"},
      {symbols, "http://www.xabsl.de", "http://www.ki.informatik.hu-berlin.de/XABSL2.1",
       "this file is of another version of XABSL than 'a.xml'"},
      {"a.xml", "<title>", "<title>A & B", "'&' begins the name of an entity"},
      {"symbol-and-basic-behavior-files.dtd", "Symbols/n.xml", "../n.xml", "it lies outside of"},
  };
  for (const auto& [file, before, after, expected] : faults) {
    VirtualFiles files = xml;
    const std::size_t place = files.at(file).find(before);
    ASSERT_NE(place, std::string::npos) << before;
    files.at(file).replace(place, before.size(), after);
    EXPECT_NE(test::errors(compile("a.xml", files).diagnostics).find(expected), std::string::npos)
        << expected << " in\n"
        << test::errors(compile("a.xml", files).diagnostics);
  }
}

}  // namespace
}  // namespace xabsl
