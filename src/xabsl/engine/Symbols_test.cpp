#include "xabsl/engine/Symbols.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

/// The surroundings as a class with members, and all ways to register them.
class Walker {
 public:
  double distance() const { return 42; }
  void walk(float x, int steps) { walked = x * static_cast<float>(steps); }
  float walked = 0;
};
double half(double value) {
  return value / 2;
}

TEST(Symbols, TakeVariablesMembersLambdasAndFunctions) {
  const std::string text = R"(namespace main("M") {
    float input distance; float input count; float input big; float input half(float value;);
    float output steps; bool output led;
    behavior walk { float x; float steps; }
  }
  option main { initial state s { action {
    walk(x = distance, steps = half(value = count)); steps = 1 / 0; led = big > 1; } } }
  agent main("Main", main);)";
  Walker robot;
  int count = 6;
  const float big = 2.5f;
  unsigned char steps = 0;
  bool led = false;
  Symbols symbols;
  symbols.input("distance", member(&robot, &Walker::distance));
  symbols.input("count", &count);
  symbols.input("big", &big);
  symbols.input("half", {"value"}, &half);
  symbols.output("steps", &steps);
  symbols.output("led", &led);
  symbols.behavior("walk", {"x", "steps"}, member(&robot, &Walker::walk));
  Engine::Creation creation = Engine::create(test::compiled(text), symbols);
  ASSERT_EQ(test::errors(creation.diagnostics), "");
  creation.engine->execute(0);
  EXPECT_EQ(robot.walked, 126);
  EXPECT_EQ(steps, 255);  // cut to what the variable can hold
  EXPECT_TRUE(led);
}

TEST(Symbols, TakeEnumerationsKnownAsData) {
  const std::string text = R"(namespace main("M") {
    enum action_id { kick, stand };
    enum action_id input last; enum action_id output next;
    behavior perform { enum action_id what; float speed; }
  }
  option main { initial state s { action {
    next = last == stand ? kick : stand; perform(what = kick, speed = 2); } } }
  agent main("Main", main);)";
  const std::vector<std::string> names = {"stand", "getUp", "kick"};
  int next = -1;
  int performed = -1;
  Symbols symbols;
  symbols.enumeration("action_id", names);
  symbols.inputIndex("last", "action_id", [] { return 0; });
  symbols.outputIndex("next", "action_id", [&](int index) { next = index; });
  symbols.behavior("perform", {{"what", "action_id"}, "speed"},
                   [&](int index, double) { performed = index; });
  Engine::Creation creation = Engine::create(test::compiled(text), symbols);
  ASSERT_EQ(test::errors(creation.diagnostics), "");
  creation.engine->execute(0);
  EXPECT_EQ(next, 2);
  EXPECT_EQ(performed, 2);
  EXPECT_EQ(creation.engine->symbol("last")->text, "stand");
  EXPECT_EQ(creation.engine->activations()[1].parameters[0].text, "kick");
}

TEST(Symbols, CutNumbersToTheRangeOfIntegers) {
  EXPECT_EQ(fromNumber<int>(1e300), std::numeric_limits<int>::max());
  EXPECT_EQ(fromNumber<int>(-1e300), std::numeric_limits<int>::min());
  EXPECT_EQ(fromNumber<int>(std::numeric_limits<double>::quiet_NaN()), 0);
  EXPECT_EQ(fromNumber<long>(-3.9), -3);
  EXPECT_EQ(fromNumber<unsigned>(-1), 0u);
}

}  // namespace
}  // namespace xabsl
