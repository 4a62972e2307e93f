#include "xabsl/language/Lowering.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "xabsl/tests/TestBehavior.h"

namespace xabsl {
namespace {

TEST(Lowering, WritesNumbersAsThePublicCompilersDo) {
  for (const auto& [number, text] :
       std::vector<std::pair<double, std::string>>{{0, "0"},
                                                   {-0.0, "0"},
                                                   {-3, "-3"},
                                                   {0.25, "0.25"},
                                                   {1e21, "1000000000000000000000"},
                                                   {1e30, "1.0e+30"},
                                                   {0.00001, "1.0e-05"}})
    EXPECT_EQ(decimalText(number), text);
}

TEST(Lowering, SortsByNamesWithoutRegardToCase) {
  struct Named {
    std::string name;
  };
  const std::vector<Named> names = {{"b"}, {"C"}, {"A"}, {"a"}};
  EXPECT_EQ(sortedByName(names), (std::vector<int>{2, 3, 0, 1}));
  EXPECT_EQ(sortedByName(names, [](const Named& one) { return one.name != "C"; }),
            (std::vector<int>{2, 3, 0}));
}

TEST(Lowering, JoinsConnectionsAndSigns) {
  const Behavior behavior = test::compiled(
      "namespace n(\"N\") { bool input b; bool input c; enum e { k }; enum e input m; float input "
      "x; }"
      "option main { initial state s { decision { if (b && (c && (b || c)) && m == k && - -3 < x)"
      " stay; else goto s; } action { } } } agent a(\"A\", main);");
  const Model& model = behavior.model();
  const int condition = model.decisions[0].condition;
  const std::vector<int> operands = flattened(model, condition);
  ASSERT_EQ(operands.size(), 5u);
  const auto at = [&](std::size_t i) {
    return model.expressions[static_cast<std::size_t>(operands[i])];
  };
  EXPECT_EQ(at(2).operation, Operator::logicalOr);
  EXPECT_EQ(signedNumber(model, model.expressions[static_cast<std::size_t>(at(4).a)]), 3);
}

}  // namespace
}  // namespace xabsl
