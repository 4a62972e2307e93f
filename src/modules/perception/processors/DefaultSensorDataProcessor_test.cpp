#include "modules/perception/processors/DefaultSensorDataProcessor.h"

#include <gtest/gtest.h>

#include "base/Random.h"
#include "base/Statistics.h"
#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"

namespace gt {
namespace {

/// A robot whose head pans at constant speed, and of which one leg may move.
class DefaultSensorDataProcessorTest : public testing::Test {
 protected:
  void fill(double panSpeed, const Vector3d& acceleration = {0, 0, 9810}, bool paws = true) {
    for (int i = 0; i < SensorDataBuffer::capacity; ++i) {
      SensorData frame;
      frame.time = {now_.ms - 8 * (SensorDataBuffer::capacity - 1 - i)};
      frame.joints[Joint::headTilt] = -0.3;
      frame.joints[Joint::headPan] = panSpeed * static_cast<double>(frame.time.ms) / 1000;
      frame.joints[Joint::legFR1] = legSpeed_ * static_cast<double>(frame.time.ms - now_.ms) / 1000;
      frame.acceleration = acceleration;
      for (const Switch s : {Switch::pawFR, Switch::pawFL, Switch::pawHR, Switch::pawHL})
        frame.switches[s] = paws;
      sensors_.push(frame);
    }
    image_.time = now_;
  }
  void run() {
    processor_.update({now_}, sensors_, image_, robot_, calibration_, FieldDimensions{}, motion_,
                      odometry_, Previous<BallPercept>{ball_},
                      Previous<LandmarksPercept>{landmarks_}, matrix_, body_, psd_, learned_);
  }

  double legSpeed_ = 0;  ///< rad/s
  Time now_{200};
  SensorDataBuffer sensors_;
  Image image_;
  RobotDimensions robot_;
  RobotCalibration calibration_;
  MotionInfo motion_;
  OdometryData odometry_;
  BallPercept ball_;
  LandmarksPercept landmarks_;
  DefaultSensorDataProcessor processor_;
  CameraMatrix matrix_;
  BodyPercept body_;
  PsdPercept psd_;
  LearnedCalibration learned_;
};

TEST_F(DefaultSensorDataProcessorTest, GivesEachRowTheRotationOfItsMoment) {
  fill(1.5);
  run();
  ASSERT_TRUE(matrix_.valid);
  for (const int row : {0, 40, 72, 110, 143}) {
    const double time =
        static_cast<double>(now_.ms) - (image_.info.height - 1 - row) * image_.info.rowTime;
    const HeadAngles head{-0.3, 1.5 * time / 1000, 0};
    const Pose3D expected =
        cameraPose(robot_, bodyPose(bodyPosture(robot_, sensors_.newest().joints)), head);
    EXPECT_LT((matrix_.rotationAt(row) - expected.rotation).norm(), 1e-3) << row;
  }
  EXPECT_NEAR(matrix_.turning.z(), 1.5, 0.2);
}

// A flag is seen where the head looked 10 ms before the image's time stamp.
TEST_F(DefaultSensorDataProcessorTest, LearnsHowOldImagesAre) {
  constexpr double delay = 0.01;
  double speed = 1.5;
  for (int i = 0; i < 600; ++i) {
    now_ = now_ + 40;
    if (i % 10 == 0) speed = -speed;
    fill(speed);
    run();
    const double middle = static_cast<double>(now_.ms) / 1000 - delay -
                          (image_.info.height - 1) * image_.info.rowTime / 2000;
    const Matrix3d truth =
        cameraPose(robot_, bodyPose(bodyPosture(robot_, sensors_.newest().joints)),
                   {-0.3, speed * middle, 0})
            .rotation;
    const auto azimuth = [](const Matrix3d& camera) {
      return std::atan2(camera(1, 0), camera(0, 0));
    };
    landmarks_.time = now_;
    landmarks_.numberOfFlags = 1;
    landmarks_.flags[0].angle = 0.3 + normalize(azimuth(matrix_.pose.rotation) - azimuth(truth));
    landmarks_.flags[0].distance = 2000;
  }
  EXPECT_NEAR(landmarks_.flags[0].angle, 0.3, fromDegrees(0.2)) << "not 0.86 degrees";
}

TEST_F(DefaultSensorDataProcessorTest, CorrectsTheBodysPostureForThisRobot) {
  fill(0);
  run();
  const Vector3d uncorrected = matrix_.pose.rotation.col(0);
  calibration_ = {0.06, 0};
  run();
  const Vector3d tilted = matrix_.pose.rotation.col(0);
  EXPECT_NEAR(std::asin(tilted.z()) - std::asin(uncorrected.z()), 0.06, 1e-6) << "nose up";
  calibration_ = {0, 0.1};
  run();
  EXPECT_NEAR(std::asin(matrix_.pose.rotation.col(1).z()), 0.1, 1e-3) << "right side down";
}

// Legs that give: the camera's and the distance sensor's poses know of it.
TEST_F(DefaultSensorDataProcessorTest, KnowsHowBodiesLeanOnTheirLegs) {
  fill(0);
  processor_.parameters.posture.tilt[0] = 0.04;
  processor_.parameters.posture.roll[0] = 0.03;
  processor_.parameters.posture.height[0] = -5;
  const BodyPosture legs = bodyPosture(robot_, sensors_.newest().joints);
  const Pose3D expected = cameraPose(
      robot_, bodyPose({legs.height - 5, legs.tilt + 0.04, legs.roll + 0.03}), {-0.3, 0, 0});
  run();
  EXPECT_LT((matrix_.pose.rotation - expected.rotation).norm(), 1e-3);
  EXPECT_LT((matrix_.pose.translation - expected.translation).norm(), 0.2);
  EXPECT_NEAR((psd_.offset - matrix_.pose.translation).dot(matrix_.pose.rotation.col(1)), 0, 1e-3)
      << "straight ahead of the camera";
}

// A flag is seen 2 degrees too high, in each image: the camera looks higher than its joints tell.
TEST_F(DefaultSensorDataProcessorTest, LearnsInPlayHowThisRobotLeans) {
  const auto tiltOf = [&] { return std::asin(matrix_.pose.rotation(2, 0)); };
  fill(0);
  run();
  const double believed = tiltOf(), truth = believed - fromDegrees(2);
  const FieldDimensions field;
  constexpr double distance = 2000;
  for (int i = 0; i < 300; ++i, now_ = now_ + 40) {
    fill(0);
    run();
    landmarks_.time = now_;
    landmarks_.numberOfFlags = 1;
    ConditionalBoundary& b = landmarks_.flags[0].boundary;
    const auto seen = [&](double z) {
      return std::atan2(z - matrix_.pose.translation.z(), distance) + tiltOf() - truth;
    };
    b = {
        .left = 0.02, .right = -0.02, .top = seen(field.flagTop), .bottom = seen(field.flagBottom)};
  }
  EXPECT_NEAR(toDegrees(tiltOf() - truth), 0, 0.2);
  EXPECT_NEAR(toDegrees(learned_.robot.bodyTiltOffset), -2, 0.5);
  EXPECT_LT(learned_.deviation.bodyTiltOffset, fromDegrees(0.5));
  calibration_ = learned_.robot;  // As if saved.
  fill(0);
  run();
  EXPECT_NEAR(toDegrees(tiltOf() - truth), 0, 0.5);
  EXPECT_NEAR(learned_.robot.bodyTiltOffset, calibration_.bodyTiltOffset, 1e-9) << "begins anew";
}

TEST_F(DefaultSensorDataProcessorTest, StandsStill) {
  fill(0);
  run();
  EXPECT_EQ(body_.state, BodyState::standing);
  EXPECT_LT(matrix_.turning.norm(), 1e-9);
  EXPECT_NEAR(body_.height, bodyPosture(robot_, sensors_.newest().joints).height, 1e-9);
  EXPECT_TRUE(psd_.tooFarAway);
}

TEST_F(DefaultSensorDataProcessorTest, DoesNotTrustTheCameraDuringKicks) {
  motion_.stable = false;
  legSpeed_ = 1;
  fill(0);
  run();
  EXPECT_FALSE(matrix_.valid);
  legSpeed_ = 0;
  fill(0, {0, 0, 12000});
  run();
  EXPECT_FALSE(matrix_.valid) << "something pushes it";
}

// A goalie that blocks: its legs are stretched out, it leans, and no paw feels the ground.
TEST_F(DefaultSensorDataProcessorTest, KnowsFromWhereARobotLooksThatLiesStill) {
  motion_.stable = false;
  for (int i = 0; i < 25; ++i, now_ = now_ + 40) {
    const Vector3d felt = bodyPose({0, 0.1, -0.2}).rotation.transpose() * Vector3d{0, 0, 9810};
    fill(0, felt, false);
    for (SensorData& frame : sensors_.frames)
      for (const Leg leg : {Leg::foreLeft, Leg::hindLeft})
        frame.joints[legJoint(leg, 2)] = fromDegrees(80);
    run();
  }
  EXPECT_EQ(body_.state, BodyState::standing) << "nobody has lifted it up";
  ASSERT_TRUE(matrix_.valid);
  const Vector3d felt = sensors_.newest().acceleration;
  const BodyPosture lies = restingPosture(robot_, sensors_.newest().joints, felt);
  const Pose3D expected = cameraPose(robot_, bodyPose(lies), {-0.3, 0, 0});
  EXPECT_LT((matrix_.pose.rotation - expected.rotation).norm(), 1e-6);
  EXPECT_LT((matrix_.pose.translation - expected.translation).norm(), 1e-6);
}

// What it sees then tells nothing of how it stands on its legs.
TEST_F(DefaultSensorDataProcessorTest, LearnsNothingOfHowItLeansWhileItLies) {
  motion_.stable = false;
  for (int i = 0; i < 50; ++i, now_ = now_ + 40) {
    fill(0);
    run();
    ASSERT_TRUE(matrix_.valid);
    landmarks_.time = now_;
    landmarks_.numberOfFlags = 1;
    landmarks_.flags[0].boundary = {.left = 0.02, .right = -0.02, .top = 0.25, .bottom = 0.15};
  }
  EXPECT_EQ(learned_.robot, RobotCalibration{});
}

TEST_F(DefaultSensorDataProcessorTest, NoticesAFallOnlyWhenItLasts) {
  for (int i = 0; i < 50; ++i, now_ = now_ + 40) {
    fill(0);
    run();
  }
  fill(0, {0, 9700, 1000});
  run();
  EXPECT_EQ(body_.state, BodyState::standing);
  for (int i = 0; i < 100; ++i, now_ = now_ + 40) {
    fill(0, {0, 9700, 1000});
    run();
  }
  EXPECT_EQ(body_.state, BodyState::fallen);
  EXPECT_FALSE(matrix_.valid);
}

TEST_F(DefaultSensorDataProcessorTest, NoticesWhenItIsLifted) {
  for (int i = 0; i < 10; ++i, now_ = now_ + 40) {
    fill(0);
    run();
  }
  EXPECT_EQ(body_.state, BodyState::standing);
  for (int i = 0; i < 15; ++i, now_ = now_ + 40) {
    fill(0, {0, 0, 9810}, false);
    run();
  }
  EXPECT_EQ(body_.state, BodyState::liftedUp);
}

TEST_F(DefaultSensorDataProcessorTest, PutsTheDistanceSensorsHitAhead) {
  fill(0);
  for (SensorData& frame : sensors_.frames) frame.psd = 300;
  run();
  EXPECT_FALSE(psd_.tooFarAway);
  const Vector3d camera = matrix_.pose.translation;
  // 26.5 before the pan axis, 40.1 behind the camera, 13.4 above its axis.
  EXPECT_NEAR((psd_.offset - camera).dot(matrix_.pose.rotation.col(0)), 300 - 40.1, 1e-6);
  EXPECT_NEAR((psd_.offset - camera).dot(matrix_.pose.rotation.col(2)), 13.4, 1e-6);
}

// A line through five measurements is surer than one of them by the root of five.
TEST_F(DefaultSensorDataProcessorTest, AveragesTheJointsNoiseDuringTheExposure) {
  constexpr double noise = 0.004;
  Random random{1};
  RunningStatistics errors;
  fill(0);
  run();
  const double truth = std::asin(matrix_.pose.rotation.col(0).z());
  for (int i = 0; i < 400; ++i) {
    fill(0);
    for (SensorData& frame : sensors_.frames)
      frame.joints[Joint::headTilt] += noise * random.gaussian();
    run();
    errors.add(std::asin(matrix_.pose.rotation.col(0).z()) - truth);
  }
  EXPECT_NEAR(errors.mean(), 0, 3 * noise / std::sqrt(5 * 400));
  EXPECT_NEAR(errors.standardDeviation(), noise / std::sqrt(5), 0.2 * noise);
}

TEST_F(DefaultSensorDataProcessorTest, GivesEachRowTheTurnOfTheWalkingRobot) {
  fill(0);
  run();
  const Matrix3d standing = matrix_.pose.rotation;
  constexpr double turning = 1.2, speed = 150;
  now_ = now_ + 40;
  odometry_.pose = {0.04 * turning, 0.04 * speed, 0};
  fill(0);
  run();
  for (const int row : {0, 50, 100, 143}) {
    const double seconds = -(image_.info.height - 1 - row) * image_.info.rowTime / 1000;
    EXPECT_LT((matrix_.rotationAt(row) - rotationZ(turning * seconds) * standing).norm(), 1e-3)
        << row;
  }
  const double back = -(image_.info.height - 1) * image_.info.rowTime / 2000;
  EXPECT_NEAR(
      matrix_.pose.translation.x() -
          cameraPose(robot_, bodyPose(bodyPosture(robot_, sensors_.newest().joints)), {-0.3, 0, 0})
              .translation.x(),
      speed * back, 0.1);
}

TEST_F(DefaultSensorDataProcessorTest, AveragesTheLastTicks) {
  for (int i = 0; i < SensorDataBuffer::capacity; ++i) {
    SensorData frame;
    frame.acceleration = {100.0 * i, 0, 9810};
    sensors_.push(frame);
  }
  EXPECT_EQ(averageAcceleration(sensors_, 1).x(), 1500);
  EXPECT_EQ(averageAcceleration(sensors_, 4).x(), 1350);
  EXPECT_EQ(averageAcceleration(sensors_, 100).x(), 750) << "all there are";
}

TEST_F(DefaultSensorDataProcessorTest, TellsTiltAndRollFromAcceleration) {
  for (const double tilt : {-0.3, 0.0, 0.25})
    for (const double roll : {-0.4, 0.0, 0.2}) {
      const Matrix3d body = rotationY(-tilt) * rotationX(roll);
      fill(0, body.transpose() * Vector3d{0, 0, 9810});
      run();
      EXPECT_NEAR(body_.tilt, tilt, 1e-9);
      EXPECT_NEAR(body_.roll, roll, 1e-9);
    }
}

// The short average leaves the long one at once: no need to wait until the paws hang for long.
TEST_F(DefaultSensorDataProcessorTest, NoticesAtOnceWhenItIsLiftedWithAJerk) {
  for (int i = 0; i < 100; ++i, now_ = now_ + 40) {
    fill(0);
    run();
  }
  fill(0, {0, 2500, 12000}, false);
  run();
  EXPECT_EQ(body_.state, BodyState::liftedUp);
  fill(0, {0, 2500, 12000}, true);
  run();
  EXPECT_EQ(body_.state, BodyState::standing) << "with its paws on the ground it is only pushed";
}

TEST_F(DefaultSensorDataProcessorTest, PassesOnWhatTheNewestFrameSays) {
  fill(0);
  SensorData frame = sensors_.newest();
  frame.time = now_ = now_ + 8;
  frame.joints[Joint::tailPan] = 0.3;
  frame.switches[Switch::chin] = true;
  sensors_.push(frame);
  run();
  EXPECT_EQ(body_.time, now_);
  EXPECT_EQ(psd_.time, now_);
  EXPECT_EQ(body_.tailPan, 0.3);
  EXPECT_TRUE(body_.switches[Switch::chin]);
  EXPECT_EQ(matrix_.time, image_.time);
  EXPECT_NEAR(body_.height, bodyPosture(robot_, frame.joints).height, 1e-9);
}

}  // namespace
}  // namespace gt
