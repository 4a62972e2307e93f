#include "xabsl/engine/VirtualSymbols.h"

#include <gtest/gtest.h>

#include <string>

#include "xabsl/engine/Engine.h"
#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

TEST(VirtualSymbols, RunABehaviorThatHasNoSurroundings) {
  const Behavior behavior = test::compiled(
      "namespace n(\"N\") { enum mode { slow, fast }; enum mode input m; float input x;"
      " float input f(float a;); float output y; behavior walk { enum mode k; } }"
      "option main { initial state s { action { y = f(a = x); walk(k = m); } } }"
      "agent a(\"A\", main);");
  VirtualSymbols world(behavior.model(),
                       [](int, const double* arguments) { return 2 * *arguments; });
  Engine::Creation creation = Engine::create(behavior, world.symbols());
  ASSERT_EQ(test::errors(creation.diagnostics), "");
  world.value(behavior.model().findInput("x")) = 21;
  world.value(behavior.model().findInput("m")) = 1;
  creation.engine->execute(0);
  EXPECT_EQ(world.value(behavior.model().findOutput("y")), 42);
  EXPECT_EQ(creation.engine->activations()[1].parameters[0].text, "fast");
}

}  // namespace
}  // namespace xabsl
