#include "modules/modeling/selflocator/FieldEdges.h"

#include <gtest/gtest.h>

namespace gt {
namespace {

void expectClosest(const FieldEdges& edges, EdgeType type, Vector2d point, Vector2d closest) {
  EXPECT_LT((edges.closest(type, point) - closest).norm(), 1e-9) << point.transpose();
}

TEST(FieldEdges, LieWhereTheFieldHasThem) {
  const FieldDimensions f;
  const FieldEdges edges{f, TeamColor::red};
  expectClosest(edges, EdgeType::line, {30, 700}, {0, 700});
  expectClosest(edges, EdgeType::line, {-1570, 20}, {-f.xPenaltyArea, 20});
  expectClosest(edges, EdgeType::line, {1800, -490}, {1800, -f.yPenaltyArea});
  expectClosest(edges, EdgeType::line, {2110, 280}, {f.xGroundline, 280});
  expectClosest(edges, EdgeType::line, {100, 100}, Vector2d{100, 100}.normalized() * 150);
  expectClosest(edges, EdgeType::border, {500, 1400}, {500, f.ySideline});
  expectClosest(edges, EdgeType::border, {-2050, -800}, {-f.xGroundline, -800});
  expectClosest(edges, EdgeType::border, {1900, 1150}, {1950, 1200});
  expectClosest(edges, EdgeType::border, {2100, 10}, {f.xGroundline, f.yGoal});
  expectClosest(edges, EdgeType::yellowGoal, {-2390, 100}, {-f.xGoalBack, 100});
  expectClosest(edges, EdgeType::skyblueGoal, {2200, -310}, {2200, -f.yGoal});
}

TEST(FieldEdges, AreTurnedForTheOtherTeam) {
  const FieldDimensions field;
  const FieldEdges red{field, TeamColor::red}, blue{field, TeamColor::blue};
  for (double x = -2500; x < 2500; x += 190)
    for (double y = -1500; y < 1500; y += 170)
      for (const EdgeType type : {EdgeType::border, EdgeType::yellowGoal, EdgeType::skyblueGoal}) {
        const Vector2d p{x, y};
        EXPECT_NEAR((red.closest(type, p) - p).norm(), (blue.closest(type, -p) + p).norm(), 1e-9);
      }
}

}  // namespace
}  // namespace gt
