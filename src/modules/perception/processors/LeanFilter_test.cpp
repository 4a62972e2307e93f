#include "modules/perception/processors/LeanFilter.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>

#include "base/Random.h"
#include "base/Statistics.h"

namespace gt {
namespace {

constexpr double imageTime = 40;  // ms

/// A robot whose head pans, which sees a thing in each image, with a camera that leans otherwise
/// than it believes.
class Leaning : public testing::Test {
 protected:
  LeanFilter filter_;
  Random random_{1};
  BodyPosture truth_, giving_;
  double headRoll_ = 0, azimuth_ = 0;
  int images_ = 0;

  /// How far the camera matrix is off: rotations about x and y (rad), and the height (mm).
  Vector3d error() const {
    const BodyPosture believed = filter_.posture(giving_);
    const double roll = headRoll_ - filter_.headRoll();
    return {truth_.roll - believed.roll + roll * std::cos(azimuth_),
            believed.tilt - truth_.tilt + roll * std::sin(azimuth_),
            truth_.height - believed.height};
  }
  /// Goes on to an image, with this noise of what is seen (rad), and with an error of this size.
  void see(double noise, double mistake = 0) {
    azimuth_ = fromDegrees(80) * std::sin(0.05 * images_++);
    filter_.predict(imageTime, true);
    const double bearing = azimuth_ + fromDegrees(20) * random_.symmetric();
    SeenHeight seen{bearing, 0, random_.uniform(500, 3000), fromDegrees(0.3)};
    seen.tooHigh = seen.mended().dot(error()) + noise * random_.gaussian() + mistake;
    filter_.learn(std::array{seen}, azimuth_, giving_);
  }
};

TEST_F(Leaning, FindsHowTheRobotWasBuilt) {
  truth_ = {4, fromDegrees(3), fromDegrees(-3)};
  headRoll_ = fromDegrees(0.5);
  for (int i = 0; i < 1500; ++i) see(fromDegrees(0.3));
  EXPECT_NEAR(toDegrees(filter_.built().tilt), 3, 0.2);
  EXPECT_NEAR(toDegrees(filter_.built().roll), -3, 0.3);
  EXPECT_NEAR(toDegrees(filter_.headRoll()), 0.5, 0.3);
  EXPECT_NEAR(filter_.built().height, 4, 1.5);
}

TEST_F(Leaning, FollowsTheSwayingAndTellsHowWell) {
  constexpr double sway = fromDegrees(1);
  filter_.parameters.swayWalking = fromDegrees(0.3);  // It finds out that it is more.
  RunningStatistics squared, left;
  const double keep = std::exp(-imageTime / filter_.parameters.swayTime);
  const auto sways = [&] {
    for (double* angle : {&truth_.tilt, &truth_.roll})
      *angle = keep * *angle + std::sqrt(1 - keep * keep) * sway * random_.gaussian();
  };
  for (int i = 0; i < 4000; ++i) {
    sways();
    see(fromDegrees(0.3));
    sways();
    filter_.predict(imageTime, true);
    if (i < 500) continue;
    const Eigen::Vector2d off = error().head<2>();
    const Eigen::Matrix2d told = filter_.covariance(azimuth_, giving_).topLeftCorner<2, 2>();
    squared.add(off.dot(told.inverse() * off) / 2);
    left.add(off.norm() / std::sqrt(2));
  }
  EXPECT_LT(std::hypot(left.mean(), left.standardDeviation()), 0.95 * sway);
  EXPECT_NEAR(squared.mean(), 1, 0.3);
}

// The legs of this robot give half as much as the model says.
TEST_F(Leaning, FindsHowMuchTheLegsGive) {
  for (int i = 0; i < 2000; ++i) {
    giving_ = {-4 + 2 * random_.symmetric(), -0.02 + 0.02 * random_.symmetric(),
               0.02 * random_.symmetric()};
    truth_ = {giving_.height / 2, giving_.tilt / 2, giving_.roll / 2};
    see(fromDegrees(0.3));
  }
  EXPECT_NEAR(filter_.posture({0, 0, 0.02}).roll - filter_.posture({}).roll, 0.01, 0.002);
}

TEST_F(Leaning, IsMovedLittleByWhatIsSomethingElse) {
  truth_.tilt = fromDegrees(0.5);
  for (int i = 0; i < 500; ++i) see(fromDegrees(0.3));
  const double before = filter_.built().tilt;
  see(0, fromDegrees(10));
  EXPECT_NEAR(toDegrees(filter_.built().tilt - before), 0, 0.1);
}

TEST_F(Leaning, LearnsNothingWhenItShallNot) {
  filter_.parameters.learns = false;
  truth_ = {4, fromDegrees(3), 0};
  for (int i = 0; i < 100; ++i) see(0);
  EXPECT_EQ(filter_.posture({}).tilt, 0);
  EXPECT_EQ(filter_.posture({}).height, 0);
  EXPECT_GT(filter_.deviation().tilt, filter_.parameters.lean * 0.99) << "and says so";
}

TEST_F(Leaning, IsAsUnsureAfterABreakAsARobotThatSways) {
  for (int i = 0; i < 1000; ++i) see(fromDegrees(0.3));
  filter_.predict(1e9, false);
  const Matrix3d covariance = filter_.covariance(0, {});
  EXPECT_GT(covariance(1, 1), std::pow(filter_.parameters.swayStanding, 2));
  EXPECT_LT(covariance(1, 1), std::pow(fromDegrees(1), 2));
}

}  // namespace
}  // namespace gt
