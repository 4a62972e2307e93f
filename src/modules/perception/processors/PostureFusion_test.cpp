#include "modules/perception/processors/PostureFusion.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "base/Statistics.h"

namespace gt {
namespace {

constexpr double gravity = 9810, imageTime = 40;

/// What a body feels that stands in a posture.
Vector3d felt(const BodyPosture& posture) {
  return bodyPose(posture).rotation.transpose() * Vector3d{0, 0, gravity};
}

TEST(PostureFusion, FindsBothAnglesByGravityWhereItsSensorsAreExact) {
  const BodyPosture legs{150, 0.15, 0.02}, real{150, 0.25, -0.06};
  PostureFusion fusion;
  fusion.parameters = {.lean = 1, .zero = 1, .disturbance = 0.05};
  fusion.update(legs, felt(real), imageTime, false);
  EXPECT_NEAR(fusion.tilt(), 0.1, 1e-3);
  EXPECT_NEAR(fusion.roll(), -0.08, 1e-3);
}

TEST(PostureFusion, WeighsLegsAndGravityByTheirVariances) {
  const BodyPosture legs{150, 0.15, 0}, real{150, 0.17, 0.01};
  PostureFusion fusion;
  fusion.parameters = {.lean = 0.01, .zero = 0.02 * gravity, .disturbance = 0.1, .memory = 1e6};
  fusion.update(legs, felt(real), imageTime, false);
  EXPECT_NEAR(fusion.tilt(), 0.02 * 1 / (1 + 4 + 100), 1e-6);
  double previous = fusion.tilt();
  for (int i = 0; i < 2000; ++i) {
    fusion.update(legs, felt(real), imageTime, false);
    EXPECT_GT(fusion.tilt(), previous) << "the longer it looks, the surer the mean is";
    previous = fusion.tilt();
  }
  EXPECT_NEAR(fusion.tilt(), 0.02 * 1 / (1 + 4), 1e-4);
  EXPECT_NEAR(fusion.roll(), 0.01 * 1 / (1 + 4), 1e-4);
}

/// The mean square error of tilt and roll, of many robots, by the filter or by the legs alone.
double squaredError(const PostureFusion::Parameters& parameters, double lean) {
  constexpr double zero = 200, sway = fromDegrees(1.5), steps = fromDegrees(10);
  Random random{3};
  RunningStatistics errors;
  for (int robot = 0; robot < 300; ++robot) {
    PostureFusion fusion;
    fusion.parameters = parameters;
    const double tilt = lean * random.gaussian(), roll = lean * random.gaussian();
    const Vector3d offset{zero * random.gaussian(), zero * random.gaussian(), 0};
    for (int i = 0; i < 1000; ++i) {
      // Legs feel nothing of how the body sways; acceleration feels each step much more.
      const double swayTilt = sway * random.gaussian(), swayRoll = sway * random.gaussian();
      const Vector3d shaken{gravity * steps * random.gaussian(),
                            gravity * steps * random.gaussian(), 0};
      const BodyPosture legs{150, 0.15, 0}, real{150, 0.15 + tilt + swayTilt, roll + swayRoll};
      fusion.update(legs, felt(real) + offset + shaken, imageTime, true);
      if (i < 500) continue;
      errors.add(std::pow(tilt + swayTilt - fusion.tilt(), 2));
      errors.add(std::pow(roll + swayRoll - fusion.roll(), 2));
    }
  }
  return errors.mean();
}

TEST(PostureFusion, IsNeverWorseThanLegsAlone) {
  const PostureFusion::Parameters legsOnly{.lean = 0, .swayShare = 0}, constant{.swayShare = 0};
  const double lean = constant.lean;
  EXPECT_LT(squaredError(constant, lean), squaredError(legsOnly, lean));
  EXPECT_LT(squaredError(constant, 2 * lean), squaredError(legsOnly, 2 * lean));
  EXPECT_LT(squaredError(constant, 0), 1.01 * squaredError(legsOnly, 0));
}

TEST(PostureFusion, FollowsTheSwayOnlyWhileTheRobotWalks) {
  const BodyPosture legs{150, 0.15, 0};
  PostureFusion fusion;
  fusion.parameters = {.lean = 0, .swayShare = 0.05};
  for (int i = 0; i < 100; ++i) fusion.update(legs, felt(legs), imageTime, true);
  EXPECT_NEAR(fusion.tilt(), 0, 1e-9);
  fusion.update(legs, felt({150, 0.35, 0.1}), imageTime, true);
  EXPECT_NEAR(fusion.tilt(), 0.05 * 0.2, 2e-4);
  EXPECT_NEAR(fusion.roll(), 0.05 * 0.1, 2e-4);
  fusion.update(legs, felt({150, 0.35, 0.1}), imageTime, false);
  EXPECT_EQ(fusion.tilt(), 0);
}

// After a fall no single image replaces all that was known.
TEST(PostureFusion, KeepsItsMeanOverABreak) {
  const BodyPosture legs{150, 0.15, 0};
  PostureFusion fusion;
  fusion.parameters.zero = 1;
  for (int i = 0; i < 1000; ++i) fusion.update(legs, felt({150, 0.16, 0}), imageTime, false);
  const double before = fusion.tilt();
  fusion.update(legs, felt({150, 0.6, 0}), 1e6, false);
  EXPECT_NEAR(fusion.tilt(), before, 0.2 * 0.45);
  fusion.update(legs, Vector3d::Zero(), imageTime, false);
  EXPECT_TRUE(std::isfinite(fusion.tilt())) << "no sensors";
}

TEST(PostureFusion, LearnsNothingWhileItIsPushedOrFalls) {
  const BodyPosture legs{150, 0.15, 0};
  PostureFusion fusion;
  for (int i = 0; i < 100; ++i) fusion.update(legs, felt({150, 0.17, 0}), imageTime, false);
  const double before = fusion.tilt();
  for (int i = 0; i < 100; ++i) fusion.update(legs, felt({150, -0.8, 0.3}), imageTime, true);
  EXPECT_EQ(fusion.tilt(), before);
}

}  // namespace
}  // namespace gt
