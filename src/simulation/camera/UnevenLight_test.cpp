#include "simulation/camera/UnevenLight.h"

#include <gtest/gtest.h>

#include "simulation/camera/TestWorld.h"

namespace gt {
namespace {

TEST(UnevenLight, IsAsOnAverageOverTheField) {
  double sum = 0, low = 1, high = -1;
  int n = 0;
  for (double x = -2100; x <= 2100; x += 50)
    for (double y = -1350; y <= 1350; y += 50, ++n) {
      const double light = UnevenLight::at({x, y});
      sum += light;
      low = std::min(low, light);
      high = std::max(high, light);
    }
  EXPECT_NEAR(sum / n, 0, 0.15);
  EXPECT_GE(low, -1);
  EXPECT_LT(low, -0.9);
  EXPECT_LE(high, 1);
  EXPECT_GT(high, 0.9);
}

TEST(UnevenLight, IsInterpolatedWhereTheGroundIsSeen) {
  for (const int width : {176, 320, 40}) {
    CameraView view = viewFrom({500, -200, 180}, 1, -0.4);
    view.info.width = width;
    view.info.centerX = width / 2.0;
    UnevenLight light;
    light.set(view, 0.5);
    std::vector<std::int16_t> row(static_cast<std::size_t>(width + 16));
    for (const int y : {60, 77, 143}) {
      light.row(y, row.data());
      for (const int x : {0, 17, width - 1}) {
        const Vector3d ray = view.last.rotation * view.info.ray(x, y);
        const Vector2d seen = (view.last.translation - 180 / ray.z() * ray).head<2>();
        EXPECT_NEAR(row[static_cast<std::size_t>(x)] / 16384.0, 1 + 0.5 * UnevenLight::at(seen),
                    0.06)
            << x << " " << y;
      }
    }
  }
}

TEST(UnevenLight, ReachesWhatIsSeenAboveTheHorizon) {
  UnevenLight light;
  light.set(viewFrom({0, 0, 200}, 0, 0.3), 0.5);
  std::vector<std::int16_t> row(176);
  light.row(5, row.data());
  EXPECT_NEAR(row[88] / 16384.0, 1 + 0.5 * UnevenLight::at({3000, 0}), 0.02);
}

}  // namespace
}  // namespace gt
