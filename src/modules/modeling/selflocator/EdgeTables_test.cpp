#include "modules/modeling/selflocator/EdgeTables.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/modeling/selflocator/FieldEdges.h"

namespace gt {
namespace {

const FieldDimensions standardField;

TEST(EdgeTables, KnowTheClosestEdgeOfEachCell) {
  const EdgeTables tables{standardField, TeamColor::blue};
  const FieldEdges edges{standardField, TeamColor::blue};
  EXPECT_EQ(tables.resolution(), 25);
  Random random{1};
  int far = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vector2d place{2500 * random.symmetric(), 1500 * random.symmetric()};
    for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
      const auto type = static_cast<EdgeType>(t);
      const EdgeTables::Point found =
          tables.closest(type, static_cast<float>(place.x()), static_cast<float>(place.y()));
      const double distance = (Vector2d{found.x, found.y} - place).norm();
      const double least = (edges.closest(type, place) - place).norm();
      EXPECT_NEAR(distance, least, 35);  // where two edges or arcs are near
      far += std::abs(distance - least) > 1;
    }
  }
  EXPECT_LT(far, 400);  // of 8000: the nearest edge is nearly always a straight one
  // Wherever a point is, there is an answer.
  EXPECT_NEAR(tables.closest(EdgeType::border, 9000, 900).x, standardField.xGroundline, 1);
}

TEST(EdgeTables, AreOfBoundedSizeOnAnyField) {
  FieldDimensions huge;
  huge.xGroundline = huge.xGoalBack = 1e5;
  EXPECT_GT(EdgeTables(huge, TeamColor::red).resolution(), 300);
}

/// From a drawn pose an edge of that type is seen where the point was measured.
TEST(EdgeTables, DrawPosesThatSeeWhatWasSeen) {
  const EdgeTables tables{standardField, TeamColor::red};
  const FieldEdges edges{standardField, TeamColor::red};
  Random random{2};
  int drawn = 0;
  for (int i = 0; i < 2000; ++i) {
    const auto type = static_cast<EdgeType>(random.index(4));
    const Vector2d seen = random.uniform(200, 2500) * direction(1.5 * random.symmetric());
    if (tables.posesCount(type, seen) == 0) continue;
    ++drawn;
    const Pose2D pose = tables.drawPose(type, seen, random);
    const Vector2d place = pose * seen;
    EXPECT_LT((edges.closest(type, place) - place).norm(), 51) << place.transpose();
    EXPECT_LE(std::abs(pose.translation.x()), standardField.xGroundline);
  }
  EXPECT_GT(drawn, 1900);
}

}  // namespace
}  // namespace gt
