#include "modules/behavior/tactics/PlayValues.h"

#include <gtest/gtest.h>

#include <limits>

namespace gt {
namespace {

const Vector2d corner{2000, 1000};

/// 3 x 2 points: worths that are linear in x, places that are linear in y.
PlayValues values() {
  PlayValues made;
  made.columns = 3;
  made.rows = 2;
  made.nearer = 100;
  for (const double x : {-1., 0., 1.})
    for (const double y : {0., 1.}) {
      made.ours.push_back(0.5 * x + 0.3);
      made.theirs.push_back(0.5 * x - 0.3);
      made.ahead.emplace_back(1000, 100 + 200 * y);
      made.behind.emplace_back(-1000 + 500 * x, -100);
    }
  return made;
}

TEST(PlayValues, AreLinearBetweenThePointsOfTheGrid) {
  EXPECT_NEAR(values().worth({0, 0}, 1e4, corner), 0.3, 1e-9);
  EXPECT_NEAR(values().worth({1500, 300}, 1e4, corner), 0.675, 1e-9);
  EXPECT_NEAR(values().worth({-500, -700}, -1e4, corner), -0.425, 1e-9);
  EXPECT_NEAR(values().worth({9000, 9000}, 1e4, corner), 0.8, 1e-9) << "as at the border";
  const double none = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NEAR(values().worth({none, none}, 1e4, corner), -0.2, 1e-9) << "as at the own border";
}

TEST(PlayValues, DependOnWhoIsNearer) {
  EXPECT_NEAR(values().worth({0, 0}, 0, corner), 0, 1e-9);
  EXPECT_NEAR(values().worth({0, 0}, 100, corner), 0.6 / (1 + std::exp(-1)) - 0.3, 1e-9);
}

TEST(PlayValues, MirrorPlaces) {
  EXPECT_NEAR((values().placeAhead({0, 500}, corner) - Vector2d{1000, 200}).norm(), 0, 1e-9);
  EXPECT_NEAR((values().placeAhead({0, -500}, corner) - Vector2d{1000, -200}).norm(), 0, 1e-9);
  EXPECT_NEAR((values().placeBehind({1000, -1}, corner) - Vector2d{-750, 100}).norm(), 0, 1e-9);
}

TEST(PlayValues, ThatDoNotFitTheirGridAreWorthNothing) {
  PlayValues wrong = values();
  wrong.columns = 1000;
  EXPECT_EQ(wrong.worth({500, 300}, 100, corner), 0);
  EXPECT_EQ(wrong.placeAhead({500, 300}, corner), Vector2d::Zero());
}

TEST(PlayValues, MustFitTheirGrid) {
  EXPECT_TRUE(PlayValues{}.check());
  EXPECT_TRUE(values().check());
  PlayValues wrong = values();
  wrong.behind.pop_back();
  ASSERT_FALSE(wrong.check());
  EXPECT_EQ(wrong.check().error().field, "behind");
  wrong = values();
  wrong.rows = 1;
  ASSERT_FALSE(wrong.check());
  EXPECT_EQ(wrong.check().error().field, "columns");
}

}  // namespace
}  // namespace gt
