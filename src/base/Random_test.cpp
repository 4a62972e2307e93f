#include "base/Random.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(Random, SameSeedSameNumbers) {
  Random a{7}, b{7}, c{8};
  EXPECT_EQ(a(), b());
  EXPECT_NE(b(), c());
  a();
  EXPECT_EQ(a.fork("ball")(), b.fork("ball")());
  EXPECT_NE(a.fork("ball")(), a.fork("goal")());
}

TEST(Random, HasTheMomentsOfItsDistributions) {
  Random random{3};
  const int n = 200000;
  double sum = 0, squares = 0, uniform = 0;
  for (int i = 0; i < n; ++i) {
    const double g = random.gaussian();
    sum += g;
    squares += g * g;
    uniform += random.uniform(2, 4);
  }
  EXPECT_NEAR(sum / n, 0, 0.01);
  EXPECT_NEAR(squares / n, 1, 0.02);
  EXPECT_NEAR(uniform / n, 3, 0.01);
}

TEST(Random, IndexStaysBelowItsBound) {
  Random random{4};
  int seen[3] = {};
  for (int i = 0; i < 3000; ++i) ++seen[random.index(3)];
  for (const int count : seen) EXPECT_NEAR(count, 1000, 150);
}

}  // namespace
}  // namespace gt
