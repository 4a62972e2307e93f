#include "modules/perception/specialists/BallSpotSpecialist.h"

#include <gtest/gtest.h>

#include <limits>
#include <optional>

#include "modules/perception/testing/DrawnField.h"

namespace gt {
namespace {

class BallSpotTest : public testing::Test {
 protected:
  static constexpr double radius = 43;
  ColorTable64 table_ = blackWhiteTable();
  Random random_{5};
  BallSpotSpecialist specialist_;
  BallPercept percept_;

  void look(const DrawnField& scene) {
    const Horizon horizon = horizonOf(scene.matrix);
    specialist_.find({scene.image, table_, scene.matrix, horizon}, radius, percept_);
  }
  /// A disk with two colors, above and below a border (of its radius); noisy as images of far balls
  /// are.
  void lookAt(const Vector3d& ball, const Vector3d& above, const Vector3d& below,
              double tilt = -0.2, const Vector3d& around = fieldGreen, double border = 0.2) {
    const Vector3d from{0, 0, 170};
    DrawnField scene{tilt};
    scene.draw(
        [&](const Vector3d& ray) {
          const Vector3d off = from + ray * (ball - from).dot(ray) - ball;
          if (off.norm() < radius) return off.z() > border * radius ? above : below;
          return off.norm() < 2 * radius && off.z() > 0 ? around : fieldAt(ray);
        },
        1, 6, random_);
    look(scene);
  }
};

const Vector3d robotGray{95, 128, 128};

TEST_F(BallSpotTest, IsFoundFarAwayWhereItIs) {
  int found = 0;
  constexpr int all = 30;
  for (int i = 0; i < all; ++i) {
    const Vector3d ball{random_.uniform(600, 2000), random_.uniform(-250, 250), radius};
    lookAt(ball, fieldWhite, fieldBlack);
    if (!percept_.seen) continue;
    ++found;
    const Vector3d to = ball - Vector3d{0, 0, 170};
    EXPECT_NEAR(percept_.angle.x(), azimuth(to), fromDegrees(1.5));
    EXPECT_NEAR(percept_.offset.norm() / ball.head<2>().norm(), 1, 0.3);
  }
  EXPECT_GE(found, 0.9 * all);
}

TEST_F(BallSpotTest, IsFoundBeforeAWall) {
  lookAt({1200, 100, radius}, fieldWhite, fieldBlack, -0.1, fieldWhite);
  EXPECT_TRUE(percept_.seen);
}

TEST_F(BallSpotTest, IsFoundWhereTheImageCutsItOff) {
  lookAt({400, 225, radius}, fieldWhite, fieldBlack, -0.4);
  EXPECT_TRUE(percept_.seen);
}

TEST_F(BallSpotTest, BlackAloneWhiteAloneAndGrayAreNone) {
  for (const Vector3d& color : {fieldBlack, fieldWhite, robotGray}) {
    lookAt({1000, 0, radius}, color, color);
    EXPECT_FALSE(percept_.seen) << color.x();
  }
  lookAt({1000, 0, radius}, robotGray, fieldBlack);
  EXPECT_FALSE(percept_.seen) << "gray is not white beside green";
  for (const double border : {0.6, -0.75}) {
    lookAt({1000, 0, radius}, fieldWhite, fieldBlack, -0.2, fieldGreen, border);
    EXPECT_FALSE(percept_.seen) << border;
  }
}

TEST_F(BallSpotTest, ARobotAroundItHidesIt) {
  lookAt({1000, 0, radius}, fieldWhite, fieldBlack, -0.2, robotGray);
  EXPECT_FALSE(percept_.seen);
}

TEST_F(BallSpotTest, IsNotSeenOnAFieldWithoutOne) {
  for (int i = 0; i < 10; ++i) {
    DrawnField scene{-0.1 * i, 0.05 * i};
    scene.draw(fieldAt, 1, 6, random_);
    look(scene);
    EXPECT_FALSE(percept_.seen) << i;
  }
}

TEST_F(BallSpotTest, IsNotSeenWithACameraMatrixThatOverflows) {
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

}  // namespace
}  // namespace gt
