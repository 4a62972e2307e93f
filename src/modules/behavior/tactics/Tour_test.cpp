#include "modules/behavior/tactics/Tour.h"

#include <gtest/gtest.h>

#include "modules/behavior/testing/ImaginedWorld.h"

namespace gt {
namespace {

TEST(TourTest, VisitsAllPlacesOnTheShortestWay) {
  const std::vector<Vector2d> tour =
      shortestTour({0, 0}, {{-1000, 1000}, {1000, 1000}, {1000, 0}, {0, 1000}});
  const std::vector<Vector2d> expected{{1000, 0}, {1000, 1000}, {0, 1000}, {-1000, 1000}};
  EXPECT_EQ(tour, expected);
}

TEST(TourTest, KeepsTheOrderWhileItIsAskedFor) {
  ImaginedWorld world;
  world.targets.points = {{1000, 0}, {-1000, 0}};
  world.self.pose = {0, 300, 0};
  world.frame.time = {10000};
  Tour tour;
  EXPECT_EQ(tour.at(0, world.state()).translation, Vector2d(1000, 0));
  EXPECT_EQ(tour.size(), 2u);
  world.self.pose = {0, -800, 0};
  world.frame.time = {14900};
  EXPECT_EQ(tour.at(0, world.state()).translation, Vector2d(1000, 0));
  EXPECT_EQ(tour.at(1, world.state()).translation, Vector2d(-1000, 0));
  EXPECT_EQ(tour.at(2, world.state()).translation, Vector2d(-800, 0)) << "there is no third one";
  world.frame.time = {20000};
  EXPECT_EQ(tour.at(0, world.state()).translation, Vector2d(-1000, 0)) << "planned anew";
}

TEST(TourTest, LooksAtTheNearestBorderThatIsNotTooNear) {
  const FieldDimensions field;
  EXPECT_DOUBLE_EQ(towardsBorder({0, 700}, field), pi / 2);
  EXPECT_DOUBLE_EQ(towardsBorder({0, -700}, field), -pi / 2);
  EXPECT_DOUBLE_EQ(towardsBorder({1300, 100}, field), 0);
  EXPECT_DOUBLE_EQ(towardsBorder({-1300, -1200}, field), -pi);
  EXPECT_DOUBLE_EQ(towardsBorder({1000, 1200}, field), 0) << "the side wall is too near";
}

}  // namespace
}  // namespace gt
