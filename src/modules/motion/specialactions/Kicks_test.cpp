#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "modules/motion/testing/MotionHarness.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// The kicks of the table; each is a motion.
std::vector<MotionNet::Motion> kicks() {
  MotionNet net = MotionHarness{}.net;
  KickTable table;
  EXPECT_TRUE(readConfig("config/kicks.cfg", table));
  net.take(table);
  std::vector<MotionNet::Motion> found;
  for (const auto& motion : net.motions)
    if (motion.isKick()) found.push_back(motion);
  EXPECT_EQ(found.size(), table.kicks.size());
  return found;
}

/// The joints while a kick is performed.
std::vector<JointAngles> performed(const std::string& name) {
  MotionHarness motion;
  motion.steps(150);
  motion.perform(name);
  motion.steps(2);
  std::vector<JointAngles> angles;
  while (motion.info.executed.type == MotionType::specialAction && angles.size() < 1000) {
    motion.request = {};
    motion.step();
    angles.push_back(motion.joints.angles);
  }
  return angles;
}

TEST(Kicks, ReachFarAndToAllSides) {
  std::vector<double> directions;
  double longest = 0;
  for (const auto& motion : kicks()) {
    directions.push_back(motion.kick.direction);
    longest = std::max(longest, motion.kick.length);
    EXPECT_LT(motion.kick.falls, 0.02) << motion.name;
    const Vector2d best{motion.kick.x, motion.kick.y};
    EXPECT_LT(motion.kick.spreadAt(best, 0).value_or(180), 20) << motion.name;
  }
  std::ranges::sort(directions);
  int sides = 1;
  for (std::size_t i = 1; i < directions.size(); ++i)
    sides += directions[i] - directions[i - 1] > 20;
  EXPECT_GE(sides, 5);
  EXPECT_GT(longest, 2000);
  EXPECT_GT(directions.back(), 120) << "behind the robot";
}

TEST(Kicks, HeadAndPawPlayTheBallAtLeastSixtyCentimeters) {
  const auto all = kicks();
  for (const std::string name : {"headKick", "pawLeft", "pawRight"}) {
    const auto kick = std::ranges::find(all, name, &MotionNet::Motion::name);
    ASSERT_NE(kick, all.end()) << name;
    EXPECT_GE(kick->kick.length, 600) << name;
  }
}

TEST(Kicks, LeftAndRightAreMirrored) {
  for (const std::string kick : {"hook", "paw", "swing"}) {
    const auto left = performed(kick + "Left"), right = performed(kick + "Right");
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i)
      for (const auto& [one, other] :
           {std::pair{Joint::legFR1, Joint::legFL1}, std::pair{Joint::legFL3, Joint::legFR3},
            std::pair{Joint::legHR2, Joint::legHL2}})
        ASSERT_NEAR(left[i][one], right[i][other], 1e-9) << kick << " in frame " << i;
  }
}

TEST(Kicks, LastShortlyAndEndInTheStand) {
  MotionHarness motion;
  motion.steps(150);
  for (const auto& played : kicks()) {
    const auto angles = performed(played.name);
    const int longest = played.name == "bicycleKick" ? 5200
                        : played.name == "headKick"  ? 2800
                                                     : 1850;
    EXPECT_LT(angles.size() * 8, longest) << played.name;  // those two rise from the ground
    EXPECT_NEAR(static_cast<double>(angles.size()) * 0.008, played.kick.seconds, 0.1)
        << played.name;
    for (std::size_t j = static_cast<std::size_t>(Joint::legFR1); j < 18; ++j)
      EXPECT_NEAR(angles.back().values[j], motion.joints.angles.values[j], 0.02);
  }
}

}  // namespace
}  // namespace gt
