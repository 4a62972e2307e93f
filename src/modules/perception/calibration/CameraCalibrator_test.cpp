#include "modules/perception/calibration/CameraCalibrator.h"

#include <gtest/gtest.h>

#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"
#include "modules/perception/testing/DrawnCheckerboard.h"

namespace gt {
namespace {

// Corners as a robot sees them that leans otherwise than it believes, with another lens.
TEST(CameraCalibrator, CalibratesOpeningAnglesAndBody) {
  const DrawnCheckerboard drawn;
  Random random{4};
  std::vector<Vector2d> corners;
  const RobotDimensions robot;
  const RobotCalibration truth{fromDegrees(3), fromDegrees(-2)};
  CameraInfo camera;
  camera.focalX = 150;
  camera.focalY = 171;
  CameraCalibrator calibrator{drawn.board};
  CameraCalibration found;
  EXPECT_FALSE(calibrator.calibrate(CameraInfo{}, robot, {}, found)) << "without any image";
  for (int i = 0; i < 15; ++i) {
    JointAngles joints;
    joints[Joint::headTilt] = random.uniform(-0.2, 0.15);
    joints[Joint::headPan] = random.uniform(-0.35, 0.35);
    const Pose3D pose =
        cameraPose(robot, bodyPose(bodyPosture(robot, truth, joints)),
                   {joints[Joint::headTilt], joints[Joint::headPan], joints[Joint::headRoll]});
    corners.clear();
    for (int k = 0; k < drawn.board.rows * drawn.board.columns; ++k)
      corners.push_back(camera.project(
          pose.inverse() * drawn.cornerAt(k % drawn.board.columns, k / drawn.board.columns, 600)));
    calibrator.add(corners, joints);
  }
  ASSERT_TRUE(calibrator.calibrate(CameraInfo{}, robot, {}, found));
  EXPECT_NEAR(found.focalX, camera.focalX, 0.01);
  EXPECT_NEAR(found.focalY, camera.focalY, 0.01);
  EXPECT_NEAR(found.body.bodyTiltOffset, truth.bodyTiltOffset, 1e-4);
  EXPECT_NEAR(found.body.bodyRollOffset, truth.bodyRollOffset, 1e-4);
  EXPECT_NEAR(found.boardPosition.x(), 600, 0.1);
  EXPECT_LT(found.error, 1e-3);
}

}  // namespace
}  // namespace gt
