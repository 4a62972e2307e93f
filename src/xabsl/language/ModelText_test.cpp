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

}  // namespace
}  // namespace xabsl
