#include "xabsl/tools/documentation/Usage.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

TEST(Usage, FindsWhatIsUsedDirectlyAndThroughSubsequentOptions) {
  const Behavior behavior = test::compiled(
      "namespace s(\"S\") { float input x; float input y; float output o; float const c = 1; "
      "enum e output { k, l }; enum e output m; float input f(float p; float q;); }"
      "option low { initial state s { decision { if (f(q = y) > c) stay; else stay; } action { m = "
      "l; } } }"
      "option top { common decision { if (x > 0) goto t; } initial state s { decision { else stay; "
      "} "
      "action { low(); } } state t { decision { else goto s; } action { o = x; low(); } } }"
      "agent a(\"A\", top);");
  using documentation::Place;
  using documentation::Thing;
  using Kind = Thing::Kind;
  const documentation::Usage usage(behavior.model());
  const int x = 0, y = 1, o = 2, m = 3, f = 4, low = 0, top = 1;
  EXPECT_EQ(usage.direct(top).at({Kind::read, x}), (std::vector<int>{-1, 2}));
  EXPECT_EQ(usage.direct(top).at({Kind::option, low}), (std::vector<int>{1, 2}));
  EXPECT_EQ(usage.direct(top).count({Kind::read, y}), 0u);
  EXPECT_EQ(usage.all(low), (std::set<Thing>{{Kind::read, y},
                                             {Kind::read, f},
                                             {Kind::written, m},
                                             {Kind::constant, 0},
                                             {Kind::element, 0, 1}}));
  for (const Thing& thing : usage.all(low)) EXPECT_EQ(usage.all(top).count(thing), 1u);
  EXPECT_EQ(usage.places({Kind::written, o}), (std::vector<Place>{{top, 2}}));
  EXPECT_EQ(usage.places({Kind::element, 0, 0}), std::vector<Place>{});
}

}  // namespace
}  // namespace xabsl
