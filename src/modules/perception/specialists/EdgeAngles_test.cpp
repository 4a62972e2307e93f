#include "modules/perception/specialists/EdgeAngles.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

TEST(EdgeAngles, AveragesWhatMetTheSameEdge) {
  EdgeAngles edge;
  for (const double angle : {0.10, 0.11, 0.12, 0.01}) edge.add(angle, false);
  const auto merged = edge.merge(1, 0.03, 0.5);
  EXPECT_FALSE(merged.onBorder);
  EXPECT_NEAR(merged.angle, 0.11, 1e-12);
  EXPECT_NEAR(edge.merge(-1, 0.03, 0.2).angle, 0.01, 1e-12);
}

TEST(EdgeAngles, DoesNotTrustARaggedEdge) {
  EdgeAngles edge;
  for (const double angle : {0.3, 0.2, 0.1, 0.0}) edge.add(angle, false);
  EXPECT_TRUE(edge.merge(1, 0.03, 0.5).onBorder);
  EXPECT_FALSE(edge.merge(1, 0.03, 0.2).onBorder);
}

TEST(EdgeAngles, ScansToTheBorderCountIfFewMetAStraightEdge) {
  EdgeAngles edge;
  for (const bool onBorder : {false, false, true}) edge.add(onBorder ? 0.4 : 0.1, onBorder);
  EXPECT_FALSE(edge.merge(1, 0.03, 0.5).onBorder);
  EXPECT_NEAR(edge.merge(1, 0.03, 0.5).angle, 0.1, 1e-12);
  for (int i = 0; i < 2; ++i) edge.add(0.3, true);
  EXPECT_TRUE(edge.merge(1, 0.03, 0.5).onBorder);
  EXPECT_EQ(edge.merge(1, 0.03, 0.5).angle, 0.4);
}

TEST(EdgeAngles, TheOutermostScanDecidesOfAnEdgeThatIsNotStraight) {
  EdgeAngles edge;
  for (const bool onBorder : {false, false, true}) edge.add(onBorder ? 0.05 : 0.1, onBorder);
  EXPECT_FALSE(edge.merge(1, 0.03, 0).onBorder);
  edge.add(0.4, true);
  EXPECT_TRUE(edge.merge(1, 0.03, 0).onBorder);
  EXPECT_EQ(edge.merge(1, 0.03, 0).angle, 0.4);
  edge.clear();
  EXPECT_TRUE(edge.empty());
  EXPECT_TRUE(edge.merge(1, 0.03, 0.5).onBorder);
}

}  // namespace
}  // namespace gt
