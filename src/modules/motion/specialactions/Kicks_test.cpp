#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"
#include "modules/kinematics/LegKinematics.h"
#include "modules/motion/MotionHarness.h"

namespace gt {
namespace {

constexpr double ballRadius = 43;
constexpr double frameTime = 0.008;  // s

/// A part of the body that can kick.
struct Sphere {
  Vector3d center;
  double radius;
};

/// What can kick, relative to where the robot stood: both fore feet and shins, and the muzzle.
std::vector<Sphere> kickers(const MotionHarness& motion) {
  const auto& angles = motion.joints.angles;
  const auto body = bodyPose(bodyPosture(motion.robot, angles));
  const HeadAngles head{angles[Joint::headTilt], angles[Joint::headPan], angles[Joint::headRoll]};
  std::vector<Sphere> spheres{{cameraInBody(motion.robot, head).translation, 12}};
  for (const auto leg : {Leg::foreRight, Leg::foreLeft}) {
    const auto knee = kneePosition(motion.robot, leg, legOf(angles, leg));
    const auto foot = footPosition(motion.robot, leg, legOf(angles, leg));
    spheres.push_back({foot, motion.robot.footRadius});
    for (const double share : {0.25, 0.5, 0.75})
      spheres.push_back({foot + share * (knee - foot), 12.3});
  }
  for (auto& sphere : spheres) {
    const Vector3d inRobot = body * sphere.center;
    const Vector2d onField = motion.odometry.pose * Vector2d{inRobot.head<2>()};
    sphere.center = {onField.x(), onField.y(), inRobot.z()};
  }
  return spheres;
}

/// A ball without friction or bounce: what touches it passes on its speed along the normal.
struct Ball {
  Vector2d position;
  Vector2d speed = Vector2d::Zero();

  void touch(const Sphere& before, const Sphere& now) {
    const Vector3d toBall = Vector3d{position.x(), position.y(), ballRadius} - now.center;
    const double depth = ballRadius + now.radius - toBall.norm();
    const Vector2d flat = toBall.head<2>();
    if (depth <= 0 || flat.norm() < 0.3 * toBall.norm()) return;
    const Vector2d normal = flat.normalized();
    const Vector2d ofSphere = (now.center - before.center).head<2>() / frameTime;
    const double into = (speed - ofSphere).dot(normal);
    if (into < 0) speed -= into * normal;
    position += depth * normal;
  }
};

/// The speed with which a ball leaves that lies somewhere while the robot kicks.
Vector2d kick(std::string_view action, const Vector2d& place) {
  MotionHarness motion;
  motion.steps(150);
  motion.perform(action);
  motion.steps(2);
  Ball ball{place};
  auto before = kickers(motion);
  for (int frame = 0; motion.performs(action) && frame < 1000; ++frame) {
    motion.request = {};
    motion.step();
    const auto now = kickers(motion);
    ball.position += ball.speed * frameTime;
    for (int round = 0; round < 3; ++round)
      for (std::size_t i = 0; i < now.size(); ++i) ball.touch(before[i], now[i]);
    before = now;
  }
  return ball.speed;
}

std::vector<MotionNet::Motion> kicks() {
  std::vector<MotionNet::Motion> found;
  for (const auto& motion : MotionHarness{}.net.motions)
    if (motion.isKick()) found.push_back(motion);
  return found;
}

/// The kicks that were designed in the kinematic fidelity.
std::vector<MotionNet::Motion> kinematicKicks() {
  const std::set<std::string_view> names{"chestKick",    "unswBashOptimized", "armKickLeft",
                                         "armKickRight", "headLeft",          "headRight"};
  auto found = kicks();
  std::erase_if(found, [&](const auto& motion) { return !names.contains(motion.name); });
  return found;
}

constexpr double leastSpeed = 250;  // mm/s

TEST(Kicks, PlayTheBallWhereTheirFilesSay) {
  EXPECT_EQ(kinematicKicks().size(), 6u);
  for (const auto& motion : kinematicKicks())
    for (const auto& reach : motion.kick.reach)
      for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
        for (const double across : {0.0, 0.25, 0.5, 0.75, 1.0}) {
          const Vector2d ball{std::lerp(reach.nearest, reach.farthest, share),
                              std::lerp(reach.rightmost, reach.leftmost, across)};
          const Vector2d speed = kick(motion.name, ball);
          const std::string where =
              motion.name + " at " + std::to_string(ball.x()) + " " + std::to_string(ball.y());
          EXPECT_GT(speed.norm(), leastSpeed) << where;
          EXPECT_LT(std::abs(normalize(angleOf(speed) - fromDegrees(motion.kick.direction))),
                    fromDegrees(reach.spread))
              << where << ": " << toDegrees(angleOf(speed));
        }
}

TEST(Kicks, PlayTheBallBestInTheirDirection) {
  for (const auto& motion : kinematicKicks()) {
    const Vector2d speed = kick(motion.name, {motion.kick.x, motion.kick.y});
    EXPECT_GT(speed.norm(), leastSpeed) << motion.name;
    EXPECT_NEAR(toDegrees(angleOf(speed)), motion.kick.direction, 15) << motion.name;
    EXPECT_TRUE(motion.kick.spreadAt({motion.kick.x, motion.kick.y}, 0)) << motion.name;
  }
}

TEST(Kicks, LeftAndRightAreMirrored) {
  const Vector2d left = kick("armKickLeft", {140, 10});
  const Vector2d right = kick("armKickRight", {140, -10});
  EXPECT_NEAR(left.x(), right.x(), 1e-6);
  EXPECT_NEAR(left.y(), -right.y(), 1e-6);
}

/// The lunge is reported as odometry: it is what the hind feet, which stand, do.
TEST(Kicks, TheLungeIsTheHindFeetsMotion) {
  MotionHarness motion;
  motion.steps(150);
  motion.perform("chestKick");
  double byOdometry = 0, byFeet = 0;
  double before = 0;
  for (int i = 0; i < 400; ++i) {
    motion.step();
    const double x = footPositions(motion.robot, motion.joints.angles)[3].x();
    if (motion.special.odometryStep.translation.x() > 0) byFeet += before - x;
    before = x;
    byOdometry += motion.special.odometryStep.translation.x();
    if (motion.performs("chestKick")) motion.request = {};
  }
  EXPECT_GT(byOdometry, 60);
  EXPECT_NEAR(byOdometry, byFeet, 0.05 * byFeet);
}

TEST(Kicks, LastShortlyAndEndInTheStand) {
  for (const auto& played : kicks()) {
    MotionHarness motion;
    motion.steps(150);
    const auto stand = motion.joints.angles;
    motion.perform(played.name);
    motion.steps(2);
    int frames = 0;
    while (motion.info.executed.type == MotionType::specialAction && frames < 1000) {
      motion.request = {};
      motion.step();
      ++frames;
    }
    EXPECT_LT(frames * 8, 1700) << played.name;
    for (std::size_t j = static_cast<std::size_t>(Joint::legFR1); j < 18; ++j)
      EXPECT_NEAR(motion.joints.angles.values[j], stand.values[j], 0.02);
  }
}

}  // namespace
}  // namespace gt
