#include "base/Geometry.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

TEST(Geometry, NormalizesAngles) {
  EXPECT_DOUBLE_EQ(normalize(3 * pi), -pi);
  EXPECT_DOUBLE_EQ(normalize(pi), -pi);
  EXPECT_DOUBLE_EQ(normalize(-pi), -pi);
  Random random{1};
  for (int i = 0; i < 1000; ++i) {
    const double angle = random.uniform(-100, 100), same = normalize(angle);
    EXPECT_GE(same, -pi);
    EXPECT_LT(same, pi);
    EXPECT_NEAR(std::cos(angle), std::cos(same), 1e-9);
    EXPECT_NEAR(std::sin(angle), std::sin(same), 1e-9);
  }
}

TEST(Geometry, Pose2DIsAGroup) {
  Random random{2};
  for (int i = 0; i < 100; ++i) {
    const Pose2D a{random.uniform(-3, 3), random.uniform(-2000, 2000), random.uniform(-2000, 2000)};
    const Pose2D b{random.uniform(-3, 3), random.uniform(-2000, 2000), random.uniform(-2000, 2000)};
    const Pose2D back = a * b.relativeTo(a);
    EXPECT_NEAR(normalize(back.rotation - b.rotation), 0, 1e-9);
    EXPECT_NEAR((back.translation - b.translation).norm(), 0, 1e-6);
    EXPECT_NEAR((relative(a, b.translation) - b.relativeTo(a).translation).norm(), 0, 1e-6);
  }
}

TEST(Geometry, Pose3DInverts) {
  const Pose3D pose =
      Pose3D{}.translate(1, 2, 3).rotate(rotationZ(1)).rotate(rotationY(-0.5)).translate(4, 5, 6);
  const Vector3d point{7, 8, 9};
  EXPECT_NEAR((pose.inverse() * (pose * point) - point).norm(), 0, 1e-12);
}

TEST(Geometry, RotatesCounterclockwise) {
  EXPECT_NEAR((rotationZ(pi / 2) * Vector3d::UnitX() - Vector3d::UnitY()).norm(), 0, 1e-15);
  EXPECT_NEAR((rotationY(pi / 2) * Vector3d::UnitZ() - Vector3d::UnitX()).norm(), 0, 1e-15);
  EXPECT_NEAR((rotated({1, 0}, pi / 2) - Vector2d{0, 1}).norm(), 0, 1e-15);
}

}  // namespace
}  // namespace gt
