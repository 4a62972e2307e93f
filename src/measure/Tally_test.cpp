#include "measure/Tally.h"

#include <gmock/gmock.h>

namespace gt {
namespace {

TEST(Tally, ASummaryHidesNoOutlier) {
  Tally tally;
  for (int i = 0; i < 99; ++i) tally.measure("place", "mm", i % 2 == 0 ? 1 : -1);
  tally.measure("place", "mm", -1001);
  const Tally::Errors& errors = tally.errors["place"];
  EXPECT_NEAR(errors.bias(), -10, 1e-9);
  const auto [mean, median, p95, worst] = summaryOf(errors.sizes());
  EXPECT_STREQ(mean.name, "mean");
  EXPECT_NEAR(mean.value, 11, 1e-9);
  EXPECT_STREQ(median.name, "median");
  EXPECT_EQ(median.value, 1);
  EXPECT_STREQ(p95.name, "p95");
  EXPECT_EQ(p95.value, 1);
  EXPECT_STREQ(worst.name, "worst");
  EXPECT_EQ(worst.value, 1001);
}

}  // namespace
}  // namespace gt
