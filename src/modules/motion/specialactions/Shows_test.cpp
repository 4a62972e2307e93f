#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/testing/MotionHarness.h"

namespace gt {
namespace {

std::vector<std::string> shows() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator{"motions/shows"})
    names.push_back(entry.path().stem().string());
  return names;
}

/// Performs a motion from the stand, holds what it holds for a second, and ends it.
template <typename Look>
void perform(const std::string& name, const Look& look) {
  MotionHarness motion;
  motion.steps(150);
  motion.perform(name);
  for (int i = 0; i < 1500; ++i) {
    const JointAngles before = motion.special.joints.angles;
    motion.step();
    if (motion.performs(name)) look(motion, before);
    if (i == 250) motion.request = {};
  }
  EXPECT_EQ(motion.info.executed.type, MotionType::stand) << name;
}

TEST(Shows, KeepTheLegsClearOfTheBody) {
  for (const std::string& name : shows())
    perform(name, [&](const MotionHarness& motion, const JointAngles&) {
      for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
        const JointAngles& angles = motion.special.joints.angles;
        if (motion.special.dontCare[legJoint(leg, 2)]) continue;
        ASSERT_GE(angles[legJoint(leg, 2)], leastElevator(leg, angles[legJoint(leg, 1)]) - 1e-9)
            << name;
      }
    });
}

}  // namespace
}  // namespace gt
