#include "representations/modeling/ObstaclesModel.h"

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

TEST(ObstaclesModel, NinetySectorsCoverAllDirections) {
  EXPECT_EQ(ObstaclesModel::numberOfSectors, 90);
  EXPECT_EQ(ObstaclesModel::sectorOf(-pi), 0);
  EXPECT_EQ(ObstaclesModel::sectorOf(pi), 0) << "the same direction";
  EXPECT_EQ(ObstaclesModel::sectorOf(std::nextafter(pi, 0)), 89);
  for (int i = 0; i < 90; ++i) {
    EXPECT_EQ(ObstaclesModel::sectorOf(ObstaclesModel::middleOf(i)), i);
    EXPECT_EQ(ObstaclesModel::sectorOf(ObstaclesModel::middleOf(i) + 2 * pi), i);
  }
}

TEST(ObstaclesModel, WithoutObstaclesAllIsFree) {
  const ObstaclesModel model;
  EXPECT_EQ(model.distance(17), ObstaclesModel::farAway);
  EXPECT_EQ(model.corridor(1, 300), ObstaclesModel::farAway);
  EXPECT_FALSE(model.nearest());
  EXPECT_EQ(model.freeDirection(0.5, 300, 1000), 0.5);
}

TEST(ObstaclesModel, FindsTheNearestInARange) {
  const auto model = with({{800, 0}, {0, 500}, {-300, 0}});
  EXPECT_EQ(*model.nearest(), Vector2d(-300, 0));
  EXPECT_EQ(*model.nearest({0, fromDegrees(100)}), Vector2d(800, 0));
  EXPECT_EQ(*model.nearest({fromDegrees(45), fromDegrees(100)}), Vector2d(0, 500));
  EXPECT_FALSE(model.nearest({fromDegrees(-90), fromDegrees(90)}));
}

// A corridor against its definition: the nearest obstacle ahead and within the width.
TEST(ObstaclesModel, MeasuresCorridors) {
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
    EXPECT_NEAR(model.corridor(angle, width, from), expected, 1e-9);
  }
}

TEST(ObstaclesModel, TurnsToTheNearestFreeDirection) {
  // A wall ahead from 30 degrees on the left to 60 degrees on the right.
  ObstaclesModel model;
  for (int degrees = -60; degrees <= 30; degrees += 2) {
    const Vector2d p = 500 * direction(fromDegrees(degrees));
    model.sectors[static_cast<std::size_t>(ObstaclesModel::sectorOf(p))] = {p, true, Time{}};
  }
  const auto free = model.freeDirection(0, 200, 800);
  ASSERT_TRUE(free);
  EXPECT_GT(*free, fromDegrees(30));
  EXPECT_LT(*free, fromDegrees(60));
  EXPECT_GE(model.corridor(*free, 200), 800);
  EXPECT_FALSE(model.freeDirection(0, 200, 800, fromDegrees(25)));
  EXPECT_EQ(model.freeDirection(0, 200, 400), 0) << "free so far";
}

TEST(ObstaclesModel, FindsTheFreePartOfTheGoal) {
  const Vector2d ball{150, 0}, left{1500, 300}, right{1500, -300};
  const auto all = ObstaclesModel{}.freeGoalPart(ball, left, right, 86);
  ASSERT_TRUE(all);
  EXPECT_NEAR(all->middle, 0, 1e-9);
  EXPECT_NEAR(all->width, 2 * std::atan2(300, 1350), 1e-9);

  // A keeper right of the middle leaves the left part.
  const auto model = with({{1300, 0}, {1300, -100}, {1300, -200}});
  const auto part = model.freeGoalPart(ball, left, right, 86);
  ASSERT_TRUE(part);
  EXPECT_GT(part->middle - part->width / 2, std::atan2(43, 1150) - 0.01);
  EXPECT_NEAR(part->middle + part->width / 2, std::atan2(300, 1350), 0.01);
  EXPECT_EQ(model.kickAngle(ball, left, right, 86, 800), part->middle);

  EXPECT_TRUE(with({{1480, 0}, {1700, 100}}).freeGoalPart(ball, left, right, 86)->width ==
              all->width)
      << "what stands on the line or behind it does not count";
  EXPECT_FALSE(with({{250, 0}}).freeGoalPart(ball, left, right, 500)) << "right before the ball";
  EXPECT_FALSE(ObstaclesModel{}.freeGoalPart(ball, right, left, 86)) << "from behind";
}

TEST(ObstaclesModel, KicksAroundObstaclesIfTheGoalIsBlocked) {
  const Vector2d ball{150, 0}, left{1500, 300}, right{1500, -300};
  const auto model = with({{450, -40}, {450, 0}, {450, 60}, {450, 100}});
  ASSERT_FALSE(model.freeGoalPart(ball, left, right, 400));
  const double angle = model.kickAngle(ball, left, right, 400, 800);
  EXPECT_GE(model.corridor(angle, 400, ball), 800);
  EXPECT_LT(angle, 0) << "the shorter way round";
}

}  // namespace
}  // namespace gt
