#pragma once
#include <gtest/gtest.h>

#include <memory>

#include "representations/infrastructure/RobotDimensions.h"
#include "simulation/scene/ProfileTable.h"
#include "simulation/world/World.h"

namespace gt {

/// A match scene of the repository, without chance.
inline SceneDescription matchScene() {
  auto scene = loadScene("scenes/match.scene");
  EXPECT_TRUE(scene) << (scene ? "" : scene.error().text());
  setProfile(*scene, Profile::perfect);
  return *scene;
}

/// A scene with one robot and one ball, without chance.
inline SceneDescription duelScene(const Pose2D& robot, const Vector2d& ball) {
  SceneDescription scene = matchScene();
  scene.robots.resize(1);
  scene.robots[0].x = robot.translation.x();
  scene.robots[0].y = robot.translation.y();
  scene.robots[0].rotation = toDegrees(robot.rotation);
  scene.balls[0].x = ball.x();
  scene.balls[0].y = ball.y();
  return scene;
}

inline std::unique_ptr<World> worldOf(const SceneDescription& scene, std::uint64_t seed = 1) {
  auto world = makeWorld(scene, Random{seed});
  EXPECT_TRUE(world) << (world ? "" : world.error().text());
  return std::move(*world);
}

/// The angles of a standing robot.
inline JointAngles standing() {
  JointAngles angles;
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    angles[legJoint(leg, 1)] = fromDegrees(-20);
    angles[legJoint(leg, 2)] = fromDegrees(8);
    angles[legJoint(leg, 3)] = fromDegrees(75);
  }
  angles[Joint::mouth] = fromDegrees(-3);
  return angles;
}

/// Legs under the body's center of mass, which lies ahead of its middle.
inline JointAngles firmStand() {
  JointAngles angles = standing();
  for (const Leg leg : {Leg::hindRight, Leg::hindLeft}) {
    angles[legJoint(leg, 1)] = fromDegrees(-30);
    angles[legJoint(leg, 3)] = fromDegrees(60);
  }
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft}) {
    angles[legJoint(leg, 1)] = fromDegrees(-10);
    angles[legJoint(leg, 3)] = fromDegrees(60);
  }
  return angles;
}

inline RobotCommand standingCommand(const Pose2D& step = {}) {
  return {standing(), step};
}

/// All robots do the same.
inline void run(World& world, const RobotCommand& command, int ticks) {
  const std::vector<RobotCommand> commands(world.activeRobots(), command);
  for (int i = 0; i < ticks; ++i) world.step(commands);
}

/// Angles drawn from all that the joints can do.
inline JointAngles randomAngles(Random& random) {
  JointAngles angles;
  for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
    const JointLimits limits = limitsOf(static_cast<Joint>(j));
    angles.values[j] = random.uniform(limits.low, limits.high);
  }
  return angles;
}

}  // namespace gt
