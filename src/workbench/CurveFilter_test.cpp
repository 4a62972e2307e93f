#include "workbench/CurveFilter.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(CurveFilter, DerivesByTime) {
  CurveFilter filter{CurveFilterKind::derivative};
  EXPECT_FALSE(filter.take(1, 5));
  EXPECT_DOUBLE_EQ(*filter.take(1.5, 6), 2);
  EXPECT_DOUBLE_EQ(*filter.take(3.5, 0), -3);
  EXPECT_FALSE(filter.take(3.5, 1)) << "no time has passed";
  EXPECT_DOUBLE_EQ(*filter.take(4, 2), 2);
}

TEST(CurveFilter, AveragesOverTime) {
  CurveFilter filter{CurveFilterKind::mean1s};
  EXPECT_DOUBLE_EQ(*filter.take(0, 3), 3);
  EXPECT_DOUBLE_EQ(*filter.take(0.5, 9), 6);
  EXPECT_DOUBLE_EQ(*filter.take(1.25, 3), 6) << "the first point is more than a second ago";
  CurveFilter none;
  EXPECT_DOUBLE_EQ(*none.take(0, 7), 7);
}

}  // namespace
}  // namespace gt
