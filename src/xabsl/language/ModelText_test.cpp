#include "xabsl/language/ModelText.h"

#include <gtest/gtest.h>

#include <string>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

/// The condition of the first decision and the actions of the only state, written from the model.
std::string writtenAgain(const std::string& condition, const std::string& actions) {
  const Behavior behavior = test::compiled(
      "namespace symbols(\"Symbols\") { enum mode { off, on }; bool input b; bool input c; "
      "float input x; float input f(float p; float q;); enum mode input m; enum mode output o; "
      "float output y; float const limit = 5; }"
      "namespace behaviors(\"Behaviors\") { behavior go { float v; enum mode k; } }"
      "option main { float @p; initial state s { decision { if (" +
      condition + ") goto s; else stay; } action { " + actions + " } } } agent a(\"A\", main);");
  const Model& model = behavior.model();
  std::string text = expressionText(model, model.decisions[0].condition);
  for (const Action& action : model.actions) text += "; " + actionText(model, action);
  return text;
}

TEST(ModelText, KeepsExpressionsAndActions) {
  for (const std::string condition :
       {"b && (c || b) && !(b && c)", "x - (x - 1) - 2 < -x * 3 % 4", "(x < 1 ? 2 : x) > limit",
        "m == off || mode.on != m", "f(q = 1, p = -(-x)) >= state_time / 0.25", "!b && (b && c)",
        "f(p = 1, q = (x + 1) * @p) <= 1e+30", "action_done || option_time > 1000 || true"})
    EXPECT_EQ(writtenAgain(condition, "o = b ? on : off; y = x; go(k = m, v = @p); go();"),
              condition + "; o = b ? on : off; y = x; go(k = m, v = @p); go()");
}

/// The analyzer accepts only values of the symbol's type.
TEST(ModelText, KnowsTheTypesOfExpressions) {
  const Behavior behavior = test::compiled(
      "namespace n(\"N\") { enum mode { off, on }; bool input b; float input f(float p;); "
      "enum mode output o; bool output flag; float output y; float const limit = 5; }"
      "option main { float @p; enum mode @m; initial state s { action { o = b ? @m : off; o = o; "
      "y = 2; y = limit; y = -@p; y = f(p = 1) + y * state_time % option_time; y = b ? 1 : @p; "
      "flag = true; flag = b && !flag; flag = action_done || @p < 1; flag = @m != on; } } }"
      "agent a(\"A\", main);");
  const Model& model = behavior.model();
  EXPECT_EQ(model.actions.size(), 11u);
  for (const Action& action : model.actions)
    EXPECT_EQ(typeOf(model, action.operand), model.symbols[at(action.target)].type)
        << actionText(model, action);
}

}  // namespace
}  // namespace xabsl
