#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

#include <gtest/gtest.h>

#include <limits>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

class BlackWhiteBallTest : public testing::Test {
 protected:
  static constexpr double radius = 43;
  ColorTable64 table_ = blackWhiteTable();
  Random random_{3};
  BlackWhiteBallSpecialist specialist_;
  BallPercept percept_;

  void look(const DrawnField& scene) {
    const Horizon horizon = horizonOf(scene.matrix);
    specialist_.find({scene.image, table_, scene.matrix, horizon}, radius, random_, percept_);
  }
  /// A ball of which what lies in some directions from its middle is fieldBlack.
  static Vector3d ballAt(const Vector3d& center, const Vector3d& from, const Vector3d& ray) {
    const Vector3d to = center - from;
    const double along = to.dot(ray);
    const double off = (to - ray * along).squaredNorm();
    if (along < 0 || off > radius * radius) return fieldAt(ray);
    const Vector3d normal =
        (from + ray * (along - std::sqrt(radius * radius - off)) - center).normalized();
    for (const Vector3d& patch : {Vector3d{-0.8, 0.5, 0.3},
                                  {-0.8, -0.6, 0.1},
                                  {-0.3, 0.1, 0.95},
                                  {-0.7, 0.1, -0.7},
                                  {0, 0.95, -0.3},
                                  {0, -0.9, 0.4}})
      if (normal.dot(patch.normalized()) > 0.88) return fieldBlack;
    return fieldWhite;
  }
};

TEST_F(BlackWhiteBallTest, IsFoundWhereItIs) {
  int found = 0;
  for (int i = 0; i < 30; ++i) {
    const Vector3d ball{random_.uniform(250, 900), random_.uniform(-80, 80), radius};
    DrawnField scene{-0.25};
    scene.draw([&](const Vector3d& ray) { return ballAt(ball, {0, 0, 170}, ray); }, 1, 2, random_);
    look(scene);
    const Vector3d to = ball - scene.matrix.pose.translation;
    if (!percept_.seen) continue;
    ++found;
    EXPECT_NEAR(percept_.angle.x(), azimuth(to), fromDegrees(1.2));
    EXPECT_NEAR(percept_.angle.y(), elevation(to), fromDegrees(1.2));
    EXPECT_NEAR(percept_.distanceByProjection / to.norm(), 1, 0.12);
  }
  EXPECT_GE(found, 26);
}

TEST_F(BlackWhiteBallTest, IsNotSeenOnAFieldWithoutOne) {
  for (int i = 0; i < 10; ++i) {
    DrawnField scene{-0.1 * i, 0.05 * i};
    scene.draw(fieldAt, 1, 3, random_);
    look(scene);
    EXPECT_FALSE(percept_.seen) << i;
  }
}

TEST_F(BlackWhiteBallTest, IsNotSeenWithACameraMatrixThatOverflows) {
  DrawnField scene{-0.25};
  scene.draw(fieldAt, 1, 2, random_);
  for (const double height : {1e308, -1e308, std::numeric_limits<double>::quiet_NaN()}) {
    scene.matrix.pose.translation.z() = height;
    look(scene);
    scene.matrix.pose.rotation(2, 2) = height;
    look(scene);
    EXPECT_FALSE(percept_.seen) << height;
  }
}

// The report wants a tenth of it black.
TEST_F(BlackWhiteBallTest, AWhiteBallWithABlackDotIsNone) {
  for (int i = 0; i < 30; ++i) {
    const Vector3d ball{random_.uniform(300, 600), 0, radius}, from{0, 0, 170};
    DrawnField scene{-0.25};
    scene.draw(
        [&](const Vector3d& ray) {
          const double along = (ball - from).dot(ray), off = (ball - from - ray * along).norm();
          return off > radius ? fieldAt(ray) : off < 0.22 * radius ? fieldBlack : fieldWhite;
        },
        1, 2, random_);
    look(scene);
    EXPECT_FALSE(percept_.seen) << i;
  }
}

}  // namespace
}  // namespace gt
