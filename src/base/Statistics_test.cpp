#include "base/Statistics.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

TEST(RunningStatistics, AgreesWithTheClosedForms) {
  // 1 .. n has mean (n + 1) / 2 and variance (n^2 - 1) / 12.
  RunningStatistics numbers;
  constexpr int n = 1000;
  for (int i = 1; i <= n; ++i) numbers.add(i);
  EXPECT_EQ(numbers.count(), 1000u);
  EXPECT_DOUBLE_EQ(numbers.mean(), (n + 1) / 2.0);
  EXPECT_NEAR(numbers.variance(), (n * n - 1) / 12.0, 1e-9);
  EXPECT_EQ(numbers.low(), 1);
  EXPECT_EQ(numbers.high(), n);
}

TEST(RunningStatistics, KeepsSmallVariancesOfLargeNumbers) {
  RunningStatistics numbers;
  for (int i = 0; i < 1000; ++i) numbers.add(1e9 + (i % 2 == 0 ? 1 : -1));
  EXPECT_NEAR(numbers.variance(), 1, 1e-6);
}

TEST(RunningStatistics, OfTwoPartsAreThoseOfTheWhole) {
  Random random{1};
  RunningStatistics whole, parts[2], empty;
  for (int i = 0; i < 500; ++i) {
    const double x = 100 + 7 * random.gaussian();
    whole.add(x);
    parts[i < 100 ? 0 : 1].add(x);
  }
  parts[0].add(empty);
  empty.add(parts[0]);
  empty.add(parts[1]);
  EXPECT_EQ(empty.count(), whole.count());
  EXPECT_NEAR(empty.mean(), whole.mean(), 1e-10);
  EXPECT_NEAR(empty.variance(), whole.variance(), 1e-9);
  EXPECT_EQ(empty.low(), whole.low());
  EXPECT_EQ(empty.high(), whole.high());
}

TEST(RunningStatistics, OfNothingAreZero) {
  const RunningStatistics none;
  EXPECT_EQ(none.mean(), 0);
  EXPECT_EQ(none.variance(), 0);
}

TEST(Statistics, QuantilesAreLinearBetweenValues) {
  EXPECT_EQ(quantile({}, 0.5), 0);
  EXPECT_EQ(quantile({3}, 0.9), 3);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0.5), 2.5);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 0), 1);
  EXPECT_EQ(quantile({4, 1, 3, 2}, 1), 4);
  EXPECT_NEAR(quantile({10, 20, 30}, 0.95), 29, 1e-12);
  EXPECT_EQ(mean({1, 2, 6}), 3);
  EXPECT_EQ(mean({}), 0);
}

}  // namespace
}  // namespace gt
