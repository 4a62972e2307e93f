#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "modules/motion/testing/MotionHarness.h"

namespace gt {
namespace {

/// The frames of a motion's first line of angles.
int firstFrames(const MotionNet& net, const std::string& name) {
  const auto first = std::ranges::find_if(net.nodes, [&](const MotionNet::Node& node) {
    return node.kind == MotionNodeKind::data && node.motion == net.find(name);
  });
  return first == net.nodes.end() ? 0 : first->frames;
}

/// The greatest speeds with which a motion moves the joints when it begins from the stand (rad/s).
/// The first line of what gets up does not count: it begins with the joints of a robot that lies.
std::array<double, enumCount<Joint>> speedsOf(const std::string& name) {
  std::array<double, enumCount<Joint>> fastest{};
  MotionHarness motion;
  motion.steps(150);
  motion.perform(name);
  const bool getsUp = name.starts_with("getup");
  int uncounted = getsUp ? firstFrames(motion.net, name) : 0;
  for (int i = 0; i < 1500; ++i) {
    const JointAngles before = motion.joints.angles;
    motion.step();
    if (i == 250 || (getsUp && motion.performs(name))) motion.request = {};
    if (!motion.performs(name) || --uncounted >= 0) continue;
    for (std::size_t j = 0; j < fastest.size(); ++j) {
      if (motion.special.dontCare.values[j]) continue;
      const double speed = (motion.joints.angles.values[j] - before.values[j]) / 0.008;
      fastest[j] = std::max(fastest[j], std::abs(speed));
    }
  }
  EXPECT_EQ(motion.info.executed.type, MotionType::stand) << name;
  return fastest;
}

// Motors can do more (docs/motion.md), but what asks for more wears real ones out.
TEST(Motions, AskForNoMoreSpeedThanSonyRecommends) {
  int checked = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator{"motions"}) {
    if (entry.path().extension() != ".mof") continue;
    const std::string name = entry.path().stem().string();
    const auto fastest = speedsOf(name);
    for (std::size_t j = 0; j < fastest.size(); ++j)
      EXPECT_LE(fastest[j], 1.001 * limitsOf(static_cast<Joint>(j)).speed)
          << name << ": " << enumName(static_cast<Joint>(j));
    ++checked;
  }
  EXPECT_GT(checked, 20);
}

}  // namespace
}  // namespace gt
