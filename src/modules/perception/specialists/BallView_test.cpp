#include "modules/perception/specialists/BallView.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnImage.h"

namespace gt {
namespace {

constexpr double radius = 43;

class BallViewTest : public testing::Test {
 protected:
  CameraMatrix matrix_ = cameraAt({60, 10, 180}, 0, -0.3, 0);
  const Image image_;
  const ColorTable64 colors_;
  const Horizon horizon_;
  CameraImage picture_{image_, colors_, matrix_, horizon_};
  BallPercept percept_;

  Vector3d axisTo(const Vector3d& ball) const {
    return (ball - matrix_.pose.translation).normalized();
  }
  double angleOfBall(const Vector3d& ball) const {
    return std::asin(radius / (ball - matrix_.pose.translation).norm());
  }
};

TEST_F(BallViewTest, DescribesABallOnTheGroundBySizeAndByProjection) {
  const Vector3d ball{700, -60, radius};
  ASSERT_TRUE(describeBall(picture_, axisTo(ball), angleOfBall(ball), radius, percept_));
  const double distance = (ball - matrix_.pose.translation).norm();
  EXPECT_NEAR(percept_.distanceBySize, distance, 1e-6);
  EXPECT_NEAR(percept_.distanceByProjection, distance, 1e-6);
  EXPECT_NEAR((percept_.offset - ball.head<2>()).norm(), 0, 1e-6);
  EXPECT_TRUE(isOnGround(picture_, percept_, axisTo(ball), radius));
}

TEST_F(BallViewTest, TheSizeDecidesWhereTheCameraCannotBeTrusted) {
  const Vector3d ball{700, -60, radius};
  matrix_.valid = false;
  const double smaller = std::asin(radius / 900);
  ASSERT_TRUE(describeBall(picture_, axisTo(ball), smaller, radius, percept_));
  EXPECT_NEAR((percept_.offset - matrix_.pose.translation.head<2>()).norm(),
              900 * axisTo(ball).head<2>().norm(), 1e-6);
  EXPECT_TRUE(isOnGround(picture_, percept_, Vector3d::UnitX(), radius)) << "nobody can say";
}

TEST_F(BallViewTest, RefusesWhatIsNoBallOnAField) {
  const Vector3d ball{700, 0, radius};
  EXPECT_FALSE(describeBall(picture_, axisTo(ball), 1e-4, radius, percept_)) << "too small";
  percept_ = {};
  EXPECT_FALSE(describeBall(picture_, Vector3d{1, 0, 0.1}.normalized(), 0, radius, percept_))
      << "above the horizon, of unknown size";
  const Vector3d flying{700, 0, 400};
  percept_ = {};
  ASSERT_TRUE(describeBall(picture_, axisTo(flying), angleOfBall(flying), radius, percept_));
  EXPECT_FALSE(isOnGround(picture_, percept_, axisTo(flying), radius));
}

}  // namespace
}  // namespace gt
