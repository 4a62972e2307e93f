#include "modules/perception/specialists/BlackWhiteBallSpecialist.h"

#include <gtest/gtest.h>

#include <array>
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

// How large it is at its place says whether it is the ball.
TEST_F(BlackWhiteBallTest, HasTheSizeOfABallOnTheGround) {
  for (const double x : {300., 400.}) {
    const Vector3d ball{x, 20, radius};
    DrawnField scene{-0.25};
    scene.draw([&](const Vector3d& ray) { return ballAt(ball, {0, 0, 170}, ray); }, 1, 0, random_);
    const Horizon horizon = horizonOf(scene.matrix);
    for (const double size : {0.3, 1., 2.5}) {
      scene.matrix.valid = true;
      const CameraImage picture{scene.image, table_, scene.matrix, horizon};
      specialist_.find(picture, size * radius, random_, percept_);
      EXPECT_EQ(percept_.seen, size == 1) << x << " " << size;
      scene.matrix.valid = false;
      specialist_.find(picture, size * radius, random_, percept_);
      EXPECT_TRUE(percept_.seen) << "nothing says how large it should be there";
      EXPECT_NEAR((percept_.centerInImage - picture.pointOf(ball - Vector3d{0, 0, 170})).norm(), 0,
                  1.5);
      EXPECT_NEAR(percept_.distanceBySize / size / (ball - Vector3d{0, 0, 170}).norm(), 1, 0.1);
    }
  }
}

TEST_F(BlackWhiteBallTest, IsFoundWhereTheImageCutsItOff) {
  for (const double y : {-180., 180.}) {
    const Vector3d ball{360, y, radius};
    DrawnField scene{-0.25};
    scene.draw([&](const Vector3d& ray) { return ballAt(ball, {0, 0, 170}, ray); }, 1, 0, random_);
    look(scene);
    ASSERT_TRUE(percept_.seen) << y;
    EXPECT_NEAR(percept_.angle.x(), std::atan2(y, 360), fromDegrees(1.5));
  }
}

/// A ball on green ground that ends at the horizon, without noise.
class BallOnGreen : public BlackWhiteBallTest {
 protected:
  DrawnField scene_{-0.25};
  const Vector3d ball_{400, 30, radius};
  Vector2d center_ = Vector2d::Zero();
  double pixels_ = 0;  ///< Its radius.

  void lookAt(const Vector3d& ball, const Vector3d& color) {
    const Vector3d to = ball - scene_.matrix.pose.translation;
    scene_.draw(
        [&](const Vector3d& ray) {
          return (to - ray * to.dot(ray)).norm() < radius ? color
                 : ray.z() < 0                            ? fieldGreen
                                                          : fieldWhite;
        },
        1, 0, random_);
    center_ = pointIn(scene_.matrix, to);
    pixels_ = scene_.matrix.info.focalX * std::tan(std::asin(radius / to.norm()));
    look(scene_);
  }
};

TEST_F(BallOnGreen, ItsEdgesLieOnItsCircleAndPointInwards) {
  for (const Vector3d& color : {fieldWhite, fieldBlack}) {
    lookAt({400, 30, radius}, color);
    int left = 0, right = 0;
    for (const auto& edge : specialist_.edges()) {
      if (!edge.onBall) continue;
      const Vector2d inward = center_ - edge.point;
      EXPECT_NEAR(inward.norm(), pixels_, 1.5);
      EXPECT_GT(edge.inward.dot(inward.normalized()), 0.97);
      EXPECT_NEAR(edge.inward.norm(), 1, 1e-9);
      ++(inward.x() > 0 ? left : right);
    }
    // Five rows or more for each radius, but not at the top and the bottom.
    EXPECT_GE(left, 6);
    EXPECT_GE(right, 6);
  }
}

TEST_F(BallOnGreen, ItsEdgesHaveContrast) {
  lookAt(ball_, {fieldGreen[0] + 22, 128, 128});
  EXPECT_EQ(specialist_.edges().size(), 0u);
  lookAt(ball_, {fieldGreen[0] + 32, 128, 128});
  EXPECT_GT(specialist_.edges().size(), 8u);
  lookAt(ball_, {fieldGreen[0] - 32, 128, 128});
  EXPECT_GT(specialist_.edges().size(), 8u);
}

TEST_F(BallOnGreen, OtherColorsAreNoBall) {
  const Vector3d orange{150, 70, 200};
  lookAt(ball_, orange);
  table_ = Palette{{{ColorClass::orange, {150, 70, 200, 0}}, {ColorClass::green, {77, 113, 82, 0}}},
                   fieldGreen}
               .table(30);
  look(scene_);
  EXPECT_GT(specialist_.edges().size(), 8u);
  for (const auto& edge : specialist_.edges()) EXPECT_FALSE(edge.onBall);
}

TEST_F(BallOnGreen, IsBlackAndWhite) {
  for (const Vector3d& color : {fieldWhite, fieldBlack, Vector3d{110, 128, 128}}) {
    lookAt({400, 0, radius}, color);
    EXPECT_FALSE(percept_.seen) << color[0];
  }
}

// Stripes all over the image: a ball at the horizon reaches so many pixels above it.
TEST_F(BallOnGreen, EdgesAreLookedForBelowTheHorizon) {
  for (const double roll : {-0.2, 0., 0.2}) {
    scene_ = DrawnField{-0.1, roll};
    scene_.draw([](const Vector3d&) { return fieldGreen; }, 1, 0, random_);
    for (int y = 0; y < scene_.image.info.height; ++y)
      for (int x = 0; x < scene_.image.info.width; ++x)
        if (x / 22 % 2 == 0) scene_.image.at(x, y) = {230, 128, 128, 0};
    look(scene_);
    const Horizon horizon = horizonOf(scene_.matrix);
    std::array<int, 8> highest{};
    highest.fill(scene_.image.info.height);
    for (const auto& edge : specialist_.edges()) {
      EXPECT_GE(horizon.fromImage(edge.point).y(), -7);
      const auto stripe = static_cast<std::size_t>(edge.point.x() / 22 + 0.5);
      EXPECT_NEAR(edge.point.x(), 22. * static_cast<double>(stripe), 1);
      highest.at(stripe) = std::min(highest.at(stripe), static_cast<int>(edge.point.y()));
    }
    for (std::size_t i = 1; i < 8; ++i)
      EXPECT_NEAR(horizon.fromImage({22. * static_cast<double>(i), highest[i] + 0.5}).y(), -6, 2)
          << roll << " " << i;
  }
}

}  // namespace
}  // namespace gt
