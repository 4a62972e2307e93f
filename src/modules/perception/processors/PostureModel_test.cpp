#include "modules/perception/processors/PostureModel.h"

#include <gtest/gtest.h>

#include "modules/kinematics/LegKinematics.h"

namespace gt {
namespace {

/// A robot that stands, with one fore leg lifted more and more.
SensorDataBuffer lifting() {
  SensorDataBuffer sensors;
  for (int i = 0; i < SensorDataBuffer::capacity; ++i) {
    SensorData frame;
    frame.time = Time{8 * i};
    frame.joints[Joint::legFL2] = 0.03 * (i + 1);
    frame.acceleration = {0, 0, 9810 + 98.1 * i};
    sensors.push(frame);
  }
  return sensors;
}

TEST(PostureModel, HasTheFeetAndTheAccelerationOfLastMoments) {
  const RobotDimensions robot;
  const SensorDataBuffer sensors = lifting();
  const auto features = PostureModel::featuresAt(robot, sensors, sensors.newest().time);
  EXPECT_EQ(features[0], 1);
  constexpr int each = PostureModel::legCount + PostureModel::axes;
  for (int i = 0; i < PostureModel::moments; ++i) {
    const int frame = SensorDataBuffer::capacity - 1 - PostureModel::apart * i;
    const int first = 1 + each * i;
    EXPECT_NEAR(features[first + PostureModel::legCount + 2], 1 + 0.01 * frame, 1e-9) << i;
    const double heights = features.segment<PostureModel::legCount>(first).minCoeff();
    EXPECT_NEAR(heights, 0, 1e-9) << "some feet stand";
    EXPECT_GT(features[first + static_cast<int>(Leg::foreLeft)], 0) << i;
  }
  EXPECT_GT(features[1 + static_cast<int>(Leg::foreLeft)],
            features[1 + each + static_cast<int>(Leg::foreLeft)])
      << "the latest first";
}

TEST(PostureModel, RepeatsTheOldestFrame) {
  const SensorDataBuffer sensors = lifting();
  const auto features = PostureModel::featuresAt(RobotDimensions{}, sensors, Time{0});
  constexpr int each = PostureModel::legCount + PostureModel::axes;
  for (int i = 1; i < PostureModel::moments; ++i)
    EXPECT_EQ(features.segment<each>(1 + each * i), features.segment<each>(1)) << i;
}

TEST(PostureModel, AddsNothingWithoutWeightsAndWhatTheyTellWith) {
  const auto features = PostureModel::featuresAt(RobotDimensions{}, lifting(), Time{120});
  PostureModel model;
  EXPECT_EQ(model.correction(features).tilt, 0);
  EXPECT_EQ(model.correction(features).height, 0);
  model.parameters.tilt[0] = 0.1;
  model.parameters.roll[1 + static_cast<int>(Leg::foreLeft)] = 2;
  model.parameters.height[PostureModel::legCount + PostureModel::axes] = -3;
  EXPECT_NEAR(model.correction(features).tilt, 0.1, 1e-9);
  EXPECT_NEAR(model.correction(features).roll, 2 * features[1 + static_cast<int>(Leg::foreLeft)],
              1e-9);
  EXPECT_NEAR(model.correction(features).height, -3 * 1.15, 1e-9);
}

}  // namespace
}  // namespace gt
