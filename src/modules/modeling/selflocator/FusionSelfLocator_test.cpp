#include "modules/modeling/selflocator/FusionSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

/// The mean error in mm of a locator on walking robots.
double errorWith(const FusionSelfLocator::Parameters& parameters) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    SyntheticRobot robot{seed};
    FusionSelfLocator locator;
    locator.parameters = parameters;
    RobotPose estimate;
    Random random{seed};
    Debug debug{1024};
    const auto locate = [&](const SyntheticRobot& seen) {
      locator.update(seen.percept, seen.odometry, seen.field, seen.player, estimate, random, debug);
      return estimate;
    };
    follow(robot, 250, locate);
    const LocalizationTrial trial = follow(robot, 5000, locate);
    errors.insert(errors.end(), trial.errors.begin(), trial.errors.end());
  }
  return mean(errors);
}

TEST(FusionSelfLocator, KeepsFewParticlesWhereTheSingleLandmarkSelfLocatorIs) {
  FusionSelfLocator::Parameters few;
  few.localization.particles = 6;
  FusionSelfLocator::Parameters alone = few;
  alone.singleLandmark.progressiveness = 0;  // never valid
  EXPECT_LT(errorWith(few), 0.9 * errorWith(alone));
}

/// A single particle is where the candidates are put.
TEST(FusionSelfLocator, IsMoreExactThanTheSingleLandmarkSelfLocator) {
  FusionSelfLocator::Parameters frozen;
  frozen.localization.particles = 1;
  const double error = errorWith({});
  EXPECT_LT(error, 100);
  EXPECT_LT(error, 0.8 * errorWith(frozen));
}

}  // namespace
}  // namespace gt
