#include "modules/perception/specialists/BallSpecialist.h"

#include <gtest/gtest.h>

#include "modules/perception/testing/DrawnLandmarks.h"

namespace gt {
namespace {

using BallSpecialistTest = DrawnLandmarks;

TEST_F(BallSpecialistTest, FindsTheBall) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    random_ = Random{seed};
    for (int i = 0; i < 15; ++i) {
      ball_ = Vector3d{random_.uniform(250, 1500), random_.uniform(-100, 100), field_.ballRadius};
      const Vector3d to = *ball_ - camera();
      look(azimuth(to) + random_.uniform(-0.25, 0.25), elevation(to) + random_.uniform(-0.15, 0.15),
           random_.uniform(-0.3, 0.3));
      ASSERT_TRUE(percepts_.ball.seen) << "seed " << seed << " ball " << ball_->transpose();
      EXPECT_NEAR(percepts_.ball.angle.x(), azimuth(to), fromDegrees(0.3));
      EXPECT_NEAR(percepts_.ball.angle.y(), elevation(to), fromDegrees(0.3));
      EXPECT_NEAR(percepts_.ball.distanceByProjection / to.norm(), 1, 0.03);
      EXPECT_NEAR(percepts_.ball.distanceBySize / to.norm(), 1, 0.08);
      EXPECT_NEAR((percepts_.ball.offset - ball_->head<2>()).norm() / to.norm(), 0, 0.03);
    }
  }
}

TEST_F(BallSpecialistTest, FindsABallCutByTheBorder) {
  random_ = Random{4};
  ball_ = Vector3d{500, 0, field_.ballRadius};
  const Vector3d to = *ball_ - camera();
  look(azimuth(to) + image_.info.openingAngleX() / 2, elevation(to), 0);
  ASSERT_TRUE(percepts_.ball.seen);
  EXPECT_NEAR(percepts_.ball.angle.x(), azimuth(to), fromDegrees(1.5));
  EXPECT_NEAR(percepts_.ball.distanceByProjection / to.norm(), 1, 0.05);
}

TEST_F(BallSpecialistTest, FindsABallThatFillsTheImage) {
  random_ = Random{5};
  ball_ = Vector3d{150, 10, field_.ballRadius};
  field_.ballRadius = 130;  // So near that nothing else is seen.
  ball_->z() = 100;
  const Vector3d to = *ball_ - camera();
  look(azimuth(to), elevation(to), 0);
  ASSERT_TRUE(percepts_.ball.seen);
  EXPECT_EQ(percepts_.ball.distanceBySize, 0);
}

TEST_F(BallSpecialistTest, UsesTheSizeWhereTheCameraCannotBeTrusted) {
  random_ = Random{6};
  ball_ = Vector3d{700, 0, field_.ballRadius};
  look(0, -0.15, 0);
  CameraMatrix tilted = matrix_;
  tilted.valid = false;
  tilted.pose.rotation = matrix_.pose.rotation * rotationY(-0.1);
  percepts_.lookWith(processor_, image_, tilted, colors_, field_);
  ASSERT_TRUE(percepts_.ball.seen);
  EXPECT_NEAR(percepts_.ball.offset.x(), 700, 60);
}

}  // namespace
}  // namespace gt
