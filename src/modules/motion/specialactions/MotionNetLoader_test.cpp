#include "modules/motion/specialactions/MotionNetLoader.h"

#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <sstream>

#include "base/File.h"
#include "modules/kinematics/LegKinematics.h"

namespace gt {
namespace {

/// The limits in the table of motions/README.md by their columns, from 0.
std::map<std::size_t, std::pair<int, int>> limitsInReadme() {
  std::map<std::size_t, std::pair<int, int>> limits;
  std::istringstream lines{*readFile("motions/README.md")};
  const std::regex row{R"(\| ([0-9, ]+) \| .* \| (-?\d+) … (-?\d+) \|)"};
  std::smatch match;
  for (std::string line; std::getline(lines, line);) {
    if (!std::regex_match(line, match, row)) continue;
    std::istringstream columns{match[1]};
    for (std::string column; std::getline(columns, column, ',');)
      limits[std::stoul(column) - 1] = {std::stoi(match[2]), std::stoi(match[3])};
  }
  return limits;
}

TEST(MotionNetLoader, TheReadmeHasTheLimitsOfAllColumns) {
  std::map<std::size_t, std::pair<int, int>> expected;
  for (const auto& joint : motionRules().joints)
    expected.emplace(expected.size(), std::pair{joint.low, joint.high});
  EXPECT_EQ(limitsInReadme(), expected);
}

/// As motions/README.md has it: the hind legs mirror the fore legs.
TEST(MotionNetLoader, GreaterAnglesTurnTheLegsAsTheReadmeSays) {
  const RobotDimensions robot;
  constexpr double turned = 0.3;
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    const double ahead = leg == Leg::foreRight || leg == Leg::foreLeft ? 1 : -1;
    const double outward = leg == Leg::foreLeft || leg == Leg::hindLeft ? 1 : -1;
    const Vector3d still = footPosition(robot, leg, {});
    EXPECT_GT(ahead * (footPosition(robot, leg, {turned, 0, 0}) - still).x(), 10);
    EXPECT_GT(outward * (footPosition(robot, leg, {0, turned, 0}) - still).y(), 10);
    EXPECT_GT(ahead * (footPosition(robot, leg, {0, 0, turned}) - still).x(), 10);
  }
}

}  // namespace
}  // namespace gt
