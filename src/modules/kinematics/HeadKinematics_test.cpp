#include "modules/kinematics/HeadKinematics.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "modules/kinematics/BodyPosture.h"

namespace gt {
namespace {

TEST(HeadKinematics, StraightAheadTheCameraIsWhereTheDrawingHasIt) {
  const RobotDimensions robot;
  const auto pose = cameraPose(robot, bodyPose({110, 0}), {});
  EXPECT_LT((pose.translation - Vector3d{75 + 66.6, 0, 110 + 50 + 48}).norm(), 1e-9);
  EXPECT_LT((pose.rotation - Matrix3d::Identity()).norm(), 1e-9);
}

TEST(HeadKinematics, SignsOfTheAngles) {
  const RobotDimensions robot;
  const auto body = bodyPose({110, 0});
  const Vector3d ahead{1, 0, 0}, left{0, 1, 0};
  EXPECT_GT((cameraPose(robot, body, {0.3, 0, 0}).rotation * ahead).z(), 0.2);
  EXPECT_GT((cameraPose(robot, body, {0, 0.3, 0}).rotation * ahead).y(), 0.2);
  EXPECT_GT((cameraPose(robot, body, {0, 0, 0.3}).rotation * left).z(), 0.2);
  EXPECT_GT((cameraPose(robot, bodyPose({110, 0.3}), {}).rotation * ahead).z(), 0.2);
  EXPECT_GT((cameraPose(robot, bodyPose({110, 0, 0.3}), {}).rotation * left).z(), 0.2);
}

/// The report's seven steps, written out (report 3.1).
TEST(HeadKinematics, FollowsTheSevenSteps) {
  const RobotDimensions robot;
  Random random{5};
  for (int i = 0; i < 100; ++i) {
    const BodyPosture posture{random.uniform(60, 130), random.uniform(-0.3, 0.3),
                              random.uniform(-0.2, 0.2)};
    const HeadAngles head{random.uniform(-1.2, 0.6), random.uniform(-1.5, 1.5),
                          random.uniform(-0.4, 0.4)};
    const Vector3d neck = bodyPose(posture) * Vector3d{robot.neckX, 0, robot.neckZ};
    Pose3D steps;
    steps.translate(neck.x(), neck.y(), neck.z())
        .rotate(rotationX(posture.roll))
        .rotate(rotationY(-(posture.tilt + head.tilt)))
        .translate(0, 0, robot.neckToPan)
        .rotate(rotationZ(head.pan))
        .rotate(rotationX(head.roll))
        .translate(robot.panToCamera, 0, 0);
    const auto pose = cameraPose(robot, bodyPose(posture), head);
    EXPECT_LT((pose.translation - steps.translation).norm(), 1e-9);
    EXPECT_LT((pose.rotation - steps.rotation).norm(), 1e-9);
  }
}

TEST(HeadKinematics, LookAtBringsThePointToThePixel) {
  const RobotDimensions robot;
  const CameraInfo camera;
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    Random random{seed};
    for (int i = 0; i < 300; ++i) {
      const auto body = bodyPose(
          {random.uniform(80, 120), random.uniform(-0.15, 0.15), random.uniform(-0.1, 0.1)});
      const Vector3d point{random.uniform(300, 3000), random.uniform(-250, 250),
                           random.uniform(0, 250)};
      const Vector2d pixel{random.uniform(30, 146), random.uniform(30, 114)};
      const auto head = lookAt(robot, body, point, camera, pixel);
      const Vector3d seen = cameraPose(robot, body, head).inverse() * point;
      ASSERT_GT(seen.x(), 0);
      EXPECT_LT((camera.project(seen) - pixel).norm(), 1e-6);
    }
  }
}

TEST(HeadKinematics, LookAtStaysWithinTheLimits) {
  const RobotDimensions robot;
  const CameraInfo camera;
  const auto body = bodyPose({110, 0});
  Random random{6};
  for (int i = 0; i < 500; ++i) {
    const Vector3d point{random.uniform(-500, 500), random.uniform(-500, 500),
                         random.uniform(-100, 1000)};
    const auto head = lookAt(robot, body, point, camera, {88, 72});
    const auto pan = limitsOf(Joint::headPan), tilt = limitsOf(Joint::headTilt);
    EXPECT_TRUE(head.pan >= pan.low && head.pan <= pan.high);
    EXPECT_TRUE(head.tilt >= tilt.low && head.tilt <= tilt.high);
  }
  EXPECT_GT(lookAt(robot, body, {-500, 100, 43}, camera, {88, 72}).pan, 1.5);
  EXPECT_LT(lookAt(robot, body, {-500, -100, 43}, camera, {88, 72}).pan, -1.5);
}

}  // namespace
}  // namespace gt
