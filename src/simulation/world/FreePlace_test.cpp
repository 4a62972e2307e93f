#include "simulation/world/FreePlace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "base/Random.h"

namespace gt {
namespace {

TEST(FreePlace, IsTheOneThatWasAskedForIfThatIsFree) {
  const Vector2d asked{0.1, -1 / 3.};
  EXPECT_EQ(nearestFree(asked, [](const Vector2d&) { return true; }), asked);
  EXPECT_EQ(nearestFree(asked, [](const Vector2d&) { return false; }), asked) << "there is none";
}

TEST(FreePlace, IsTheNearestOneBesideDiscs) {
  Random random{3};
  for (int n = 0; n < 50; ++n) {
    std::array<Vector2d, 4> discs;
    for (Vector2d& disc : discs) disc = 150 * Vector2d{random.symmetric(), random.symmetric()};
    const auto isFree = [&](const Vector2d& place) {
      return std::ranges::all_of(discs,
                                 [&](const Vector2d& d) { return (d - place).norm() > 120; });
    };
    const Vector2d found = nearestFree({0, 0}, isFree);
    ASSERT_TRUE(isFree(found));
    double nearest = std::numeric_limits<double>::max();
    for (double x = -400; x <= 400; x += 4)
      for (double y = -400; y <= 400; y += 4)
        if (isFree({x, y})) nearest = std::min(nearest, std::hypot(x, y));
    EXPECT_LT(found.norm(), 1.05 * nearest + 6) << n;
    EXPECT_GT(found.norm(), nearest - 6) << n;
  }
}

}  // namespace
}  // namespace gt
