#include "base/Geometry.h"

#include <gtest/gtest.h>

#include "base/Random.h"

namespace gt {
namespace {

TEST(Geometry, NormalizesAngles) {
  EXPECT_DOUBLE_EQ(normalize(3 * pi), -pi);
  EXPECT_DOUBLE_EQ(normalize(pi), -pi);
  EXPECT_DOUBLE_EQ(normalize(-pi), -pi);
  EXPECT_TRUE(std::isnan(normalize(std::nan(""))));
  EXPECT_TRUE(std::isnan(normalize(INFINITY)));
  EXPECT_DOUBLE_EQ(normalize(1e300), std::remainder(1e300, 2 * pi));
  EXPECT_LT(normalize(std::nextafter(pi, 4)), -3);
  EXPECT_EQ(normalize(std::nextafter(pi, 3)), std::nextafter(pi, 3));
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

TEST(Geometry, PosesAreNormalizedHoweverTheyAreComputed) {
  EXPECT_DOUBLE_EQ((Pose2D{10, 0, 0}).rotation, 10) << "a speed in rad/s";
  EXPECT_DOUBLE_EQ((Pose2D{-pi, 0, 0}).inverse().rotation, -pi);
  EXPECT_DOUBLE_EQ((Pose2D{2, 0, 0} * Pose2D{2, 0, 0}).rotation, 4 - 2 * pi);
  EXPECT_DOUBLE_EQ((Pose2D{3, 0, 0}).rotate(1).rotation, 4 - 2 * pi);
}

// Report 2.1.4: poses can be rotated by angles and translated by vectors.
TEST(Geometry, PosesMoveAlongTheirOwnAxes) {
  const Pose2D moved = Pose2D{pi / 2, 100, 0}.translate({10, 20}).rotate(pi / 4);
  EXPECT_NEAR((moved.translation - Vector2d{80, 10}).norm(), 0, 1e-12);
  EXPECT_DOUBLE_EQ(moved.rotation, 3 * pi / 4);
  Random random{4};
  for (int i = 0; i < 100; ++i) {
    const Pose2D a{random.uniform(-9, 9), random.uniform(-9, 9), random.uniform(-9, 9)};
    const Vector2d by{random.uniform(-9, 9), random.uniform(-9, 9)};
    const double angle = random.uniform(-9, 9);
    Pose2D b = a;
    b.translate(by).rotate(angle);
    const Pose2D product = a * Pose2D{angle, by};
    EXPECT_NEAR((b.translation - product.translation).norm(), 0, 1e-12);
    EXPECT_NEAR(normalize(b.rotation - product.rotation), 0, 1e-12);
  }
}

TEST(Geometry, RotationsTellTheirAngles) {
  Random random{3};
  for (int i = 0; i < 1000; ++i) {
    const double x = random.uniform(-pi, pi), y = random.uniform(-1.57, 1.57),
                 z = random.uniform(-pi, pi);
    const Matrix3d rotation = rotationZ(z) * rotationY(y) * rotationX(x);
    EXPECT_NEAR(angleX(rotation), x, 1e-9);
    EXPECT_NEAR(angleY(rotation), y, 1e-9);
    EXPECT_NEAR(angleZ(rotation), z, 1e-9);
    EXPECT_NEAR((rotation * rotation.transpose() - Matrix3d::Identity()).norm(), 0, 1e-14);
  }
}

TEST(Geometry, AnglesMakeTheirRotationAgainAlsoWhereTheyAreAmbiguous) {
  for (const double y : {-pi / 2, pi / 2, pi / 2 - 1e-7})
    for (const double x : {-2.0, 0.0, 3.0}) {
      const Matrix3d rotation = rotationZ(1) * rotationY(y) * rotationX(x);
      const Matrix3d again =
          rotationZ(angleZ(rotation)) * rotationY(angleY(rotation)) * rotationX(angleX(rotation));
      EXPECT_NEAR((again - rotation).norm(), 0, 1e-7) << x << ' ' << y;
    }
}

// The operators of report 2.1.4 by their closed forms.
TEST(Geometry, VectorsHaveTheProductsOfTheReport) {
  const Vector3d a{1, 2, 3}, b{-2, 5, 7};
  EXPECT_DOUBLE_EQ(a.dot(b), 29);
  EXPECT_EQ(a.cross(b), Vector3d(-1, -13, 9));
  EXPECT_DOUBLE_EQ((Vector2d{3, 4}).norm(), 5);
  EXPECT_DOUBLE_EQ(angleOf({-1, 1}), 3 * pi / 4);
  EXPECT_NEAR((direction(2) - Vector2d{3 * std::cos(2), 3 * std::sin(2)}.normalized()).norm(), 0,
              1e-15);
  Matrix3d m;
  m << 1, 2, 3, 4, 5, 6, 7, 8, 10;
  EXPECT_EQ(m * a, Vector3d(14, 32, 53));
  EXPECT_EQ((m * m)(2, 0), 7 + 8 * 4 + 10 * 7);
  EXPECT_EQ((m + m)(1, 2), 12);
  const Vector2<int> pixel{3, -4};
  EXPECT_EQ(pixel.dot(Vector2<int>{2, 1}), 2);
  EXPECT_EQ(pixel.transpose() * pixel, 25);
  EXPECT_EQ((Matrix3x3<float>::Identity() * 2 * Vector3<float>{1, 2, 3}).z(), 6);
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
