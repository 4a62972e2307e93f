#include "modules/behavior/tactics/FreeSpace.h"

#include <gtest/gtest.h>

#include <initializer_list>

#include "base/Random.h"

namespace gt {
namespace {

ObstaclesModel with(std::initializer_list<Vector2d> obstacles) {
  ObstaclesModel model;
  for (const Vector2d& p : obstacles)
    model.sectors[static_cast<std::size_t>(ObstaclesModel::sectorOf(p))] = {p, true, Time{}};
  return model;
}

TEST(FreeSpace, WithoutObstaclesAllIsFree) {
  const ObstaclesModel model;
  EXPECT_EQ(corridor(model, 1, 300), ObstaclesModel::farAway);
  EXPECT_EQ(freeDirection(model, 0.5, 300, 1000), 0.5);
}

// A corridor against its definition: the nearest obstacle ahead and within the width.
TEST(FreeSpace, MeasuresCorridors) {
  Random random{3};
  for (int i = 0; i < 200; ++i) {
    ObstaclesModel model;
    for (int n = 0; n < 12; ++n) {
      const Vector2d p = random.uniform(100, 1900) * direction(random.uniform(-pi, pi));
      model.sectors[static_cast<std::size_t>(ObstaclesModel::sectorOf(p))] = {p, true, Time{}};
    }
    const double angle = random.uniform(-pi, pi), width = random.uniform(50, 500);
    const Vector2d from{random.uniform(-200, 200), random.uniform(-200, 200)};
    double expected = ObstaclesModel::farAway;
    for (const auto& sector : model.sectors) {
      const Vector2d p = rotated(sector.representative - from, -angle);
      if (sector.obstacle && p.x() > 0 && std::abs(p.y()) < width / 2)
        expected = std::min(expected, p.x());
    }
    EXPECT_NEAR(corridor(model, angle, width, from), expected, 1e-9);
  }
}

TEST(FreeSpace, TurnsToTheNearestFreeDirection) {
  // A wall ahead from 30 degrees on the left to 60 degrees on the right.
  ObstaclesModel model;
  for (int degrees = -60; degrees <= 30; degrees += 2) {
    const Vector2d p = 500 * direction(fromDegrees(degrees));
    model.sectors[static_cast<std::size_t>(ObstaclesModel::sectorOf(p))] = {p, true, Time{}};
  }
  const auto free = freeDirection(model, 0, 200, 800);
  ASSERT_TRUE(free);
  EXPECT_GT(*free, fromDegrees(30));
  EXPECT_LT(*free, fromDegrees(60));
  EXPECT_GE(corridor(model, *free, 200), 800);
  EXPECT_FALSE(freeDirection(model, 0, 200, 800, fromDegrees(25)));
  EXPECT_EQ(freeDirection(model, 0, 200, 400), 0) << "free so far";
}

TEST(FreeSpace, FindsTheNearestObstacleInARange) {
  const ObstaclesModel model = with({{700, 0}, {0, 300}, {-200, 0}});
  EXPECT_NEAR(nearestObstacle(model, 0, fromDegrees(30)), 700, 1e-9);
  EXPECT_NEAR(nearestObstacle(model, 0, fromDegrees(100)), 300, 1e-9);
  EXPECT_NEAR(nearestObstacle(model, pi, fromDegrees(10)), 200, 1e-9);
  EXPECT_EQ(nearestObstacle(model, -pi / 2, fromDegrees(30)), ObstaclesModel::farAway);
}

}  // namespace
}  // namespace gt
