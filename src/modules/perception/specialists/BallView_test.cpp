#include "modules/perception/specialists/BallView.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnImage.h"

namespace gt {
namespace {

constexpr double radius = 43;

class BallViewTest : public testing::Test {
 protected:
  CameraMatrix matrix_ = cameraAt({60, 10, 180}, 0, -0.3, 0);
  const Image image_{};
  const ColorTable64 colors_{};
  const Horizon horizon_{};
  CameraImage picture_{image_, colors_, matrix_, horizon_};
  BallPercept percept_;

  Vector3d axisTo(const Vector3d& ball) const {
    return (ball - matrix_.pose.translation).normalized();
  }
  /// As a ball is seen, to a third of a pixel.
  BallCone coneOf(const Vector3d& ball) const {
    return coneOf(ball, (ball - matrix_.pose.translation).norm());
  }
  /// The same of a ball that looks as if it were that far away.
  BallCone coneOf(const Vector3d& ball, double distance) const {
    return {axisTo(ball), std::asin(radius / distance), fromDegrees(0.1)};
  }
};

TEST_F(BallViewTest, DescribesABallOnTheGroundBySizeAndByProjection) {
  const Vector3d ball{700, -60, radius};
  ASSERT_TRUE(describeBall(picture_, coneOf(ball), radius, percept_));
  const double distance = (ball - matrix_.pose.translation).norm();
  EXPECT_NEAR(percept_.distanceBySize, distance, 1e-6);
  EXPECT_NEAR(percept_.distanceByProjection, distance, 1e-6);
  EXPECT_NEAR((percept_.offset - ball.head<2>()).norm(), 0, 1e-6);
  EXPECT_TRUE(isOnGround(picture_, percept_, axisTo(ball), radius));
}

TEST_F(BallViewTest, TheSizeDecidesWhereTheCameraCannotBeTrusted) {
  const Vector3d ball{700, -60, radius};
  matrix_.valid = false;
  ASSERT_TRUE(describeBall(picture_, coneOf(ball, 900), radius, percept_));
  EXPECT_NEAR((percept_.offset - matrix_.pose.translation.head<2>()).norm(),
              900 * axisTo(ball).head<2>().norm(), 1e-6);
  EXPECT_TRUE(isOnGround(picture_, percept_, Vector3d::UnitX(), radius)) << "nobody can say";
}

TEST_F(BallViewTest, TheDistanceIsTheMeanOfBothByHowExactTheyAre) {
  const Vector3d ball{700, -60, radius};
  const double projected = (ball - matrix_.pose.translation).norm(), seen = 0.9 * projected;
  // How much of the way from the distance by projection to that by size.
  const auto shareOfSize = [&](double error) {
    BallCone cone = coneOf(ball, seen);
    cone.error = error;
    percept_ = {};
    EXPECT_TRUE(describeBall(picture_, cone, radius, percept_));
    EXPECT_NEAR(percept_.distanceBySize, seen, 1e-6);
    EXPECT_NEAR(percept_.distanceByProjection, projected, 1e-6);
    const Vector2d camera = matrix_.pose.translation.head<2>();
    const double distance =
        (percept_.offset - camera).norm() / std::hypot(axisTo(ball).x(), axisTo(ball).y());
    return (projected - distance) / (projected - seen);
  };
  // Tilt and height are wrong by as much as 11 % of the distance there, as this error of the size.
  EXPECT_NEAR(shareOfSize(0.114 * radius / projected), 0.5, 0.05);
  EXPECT_GT(shareOfSize(0.03 * radius / projected), 0.9);
  EXPECT_LT(shareOfSize(0.5 * radius / projected), 0.1) << "only a small part of it was seen";
}

// A ball behind a robot's leg looks as if it were far away, whatever its circle says.
TEST_F(BallViewTest, AHiddenBallIsWhereItIsProjected) {
  const Vector3d ball{700, -60, radius};
  const double projected = (ball - matrix_.pose.translation).norm();
  const auto errorOf = [&](double factor) {
    percept_ = {};
    EXPECT_TRUE(describeBall(picture_, coneOf(ball, factor * projected), radius, percept_));
    return (percept_.offset - ball.head<2>()).norm() / projected;
  };
  EXPECT_LT(errorOf(2.5), 0.35) << "too small by far; 1.3 by both exactnesses alone";
  EXPECT_GT(errorOf(1.2), 0.15) << "as the camera's tilt may explain";
  EXPECT_GT(errorOf(0.7), 0.25) << "nothing makes it larger";
}

// The axis says where it lies, if the camera's tilt is right. The size does not depend on that.
TEST_F(BallViewTest, TheElevationIsThatOfABallOnTheGround) {
  const Vector3d ball{700, 0, radius};
  const Vector3d seen{600, 0, radius};
  BallCone cone = coneOf(seen, (ball - matrix_.pose.translation).norm());
  cone.error = 1e-6;
  ASSERT_TRUE(describeBall(picture_, cone, radius, percept_));
  EXPECT_NEAR(percept_.angle.y(), elevation(ball - matrix_.pose.translation), 1e-4);
  EXPECT_NEAR(percept_.offset.x(), 700, 0.1);
}

TEST_F(BallViewTest, RefusesWhatIsNoBallOnAField) {
  const Vector3d ball{700, 0, radius};
  EXPECT_FALSE(describeBall(picture_, {axisTo(ball), 1e-4, 1e-3}, radius, percept_)) << "too small";
  percept_ = {};
  EXPECT_FALSE(describeBall(picture_, {Vector3d{1, 0, 0.1}.normalized()}, radius, percept_))
      << "above the horizon, of unknown size";
  const Vector3d flying{700, 0, 400};
  percept_ = {};
  ASSERT_TRUE(describeBall(picture_, coneOf(flying), radius, percept_));
  EXPECT_FALSE(isOnGround(picture_, percept_, axisTo(flying), radius));
}

// From a camera 180 mm above the ground even a far ball is seen below the horizon.
TEST_F(BallViewTest, ABallOnTheGroundIsBelowTheHorizon) {
  for (const auto& [degrees, is] : {std::pair{0.7, true}, {1.3, false}}) {
    const Vector3d axis{1, 0, std::tan(fromDegrees(degrees))};
    EXPECT_EQ(isOnGround(picture_, {}, axis.normalized(), radius), is) << degrees;
  }
}

}  // namespace
}  // namespace gt
