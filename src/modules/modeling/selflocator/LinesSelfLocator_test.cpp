#include "modules/modeling/selflocator/LinesSelfLocator.h"

#include <gtest/gtest.h>

#include "modules/modeling/selflocator/FusionSelfLocator.h"
#include "modules/modeling/testing/LocalizationTrial.h"
#include "modules/modeling/testing/Locators.h"
#include "support/TestAllocations.h"

namespace gt {
namespace {

template <typename Solution>
LocalizationTrial walk(std::uint64_t seed, bool flags) {
  SyntheticWorld world;
  world.flags = flags;
  world.turnsHeadAlways = true;
  world.walkingSpeed = 150;
  SyntheticRobot robot{seed, world};
  Solution locator;
  RobotPose estimate;
  Random random{seed};
  Debug debug{1024};
  const auto locate = [&](const SyntheticRobot& r) {
    if constexpr (std::is_same_v<Solution, LinesSelfLocator>)
      locator.update(r.lines, r.camera, r.odometry, r.field, r.player, estimate, random, debug);
    else
      locator.update(r.percept, r.lines, r.camera, r.odometry, r.field, r.player, estimate, random,
                     debug);
    return estimate;
  };
  follow(robot, 1000, locate);
  return follow(robot, 4000, locate);
}

TEST(LinesSelfLocator, FollowsAWalkingRobotWithoutBeacons) {
  std::vector<double> medians;
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    medians.push_back(quantile(walk<LinesSelfLocator>(seed, false).errors, 0.5));
  EXPECT_LT(quantile(medians, 0.5), 90);  // report 3.3.3.4
}

TEST(GT2003SelfLocator, IsMoreExactThanBeaconsAlone) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    errors.push_back(mean(walk<GT2003SelfLocator>(seed, true).errors));
  EXPECT_LT(mean(errors), 80);
}

TEST(Fusion2003SelfLocator, NeedsFewParticles) {
  std::vector<double> errors;
  for (std::uint64_t seed = 1; seed <= 4; ++seed)
    errors.push_back(mean(walk<Fusion2003SelfLocator>(seed, true).errors));
  EXPECT_LT(mean(errors), 90);
}

TEST(SelfLocators, AllocateNothing) {
  for (const LocatorKind& kind : locatorKinds()) {
    const auto locator = kind.make(1);
    SyntheticRobot robot{1};
    long sum = 0;
    for (int i = 0; i < 1000; ++i) {
      robot.step();
      const long before = allocations();
      (*locator)(seenBy(robot));
      if (i >= 500) sum += allocations() - before;
    }
    EXPECT_EQ(sum, 0) << kind.name;
  }
}

}  // namespace
}  // namespace gt
