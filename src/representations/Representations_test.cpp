#include <gtest/gtest.h>

#include "representations/behavior/HeadControlMode.h"
#include "representations/behavior/LedRequest.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/Player.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/RobotState.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"
#include "representations/motion/SpecialActionsOutput.h"
#include "representations/motion/WalkingEngineOutput.h"
#include "representations/perception/BallPercept.h"
#include "representations/perception/BodyPercept.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/ColorTable64.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/LinesPercept.h"
#include "representations/perception/ObstaclesPercept.h"
#include "representations/perception/PlayersPercept.h"
#include "representations/perception/PsdPercept.h"
#include "streams/Binary.h"
#include "streams/Config.h"
#include "streams/Samples.h"
#include "streams/Schema.h"
#include "streams/Streams.h"

namespace gt {
namespace {

template <typename T>
class Representations : public testing::Test {};

using All =
    testing::Types<HeadControlMode, LedRequest, LedValue, MotionRequest, BehaviorTeamMessage,
                   TeamMessage, TeamMessages, CameraInfo, FieldDimensions, FrameInfo,
                   GameControlData, Image, JointData, OracledWorldState, Player, RobotDimensions,
                   SensorData, SensorDataBuffer, BallModel, TeamBallModel, RobotPose, RobotState,
                   HeadMotionRequest, MotionInfo, OdometryData, SpecialActionsOutput,
                   WalkingEngineOutput, BallPercept, BodyPercept, CameraMatrix, ColorTable64,
                   LandmarksPercept, LinesPercept, ObstaclesPercept, PlayersPercept, PsdPercept>;
TYPED_TEST_SUITE(Representations, All);

TYPED_TEST(Representations, KeepTheirValuesInAllFormats) {
  Random random{1};
  for (int i = 0; i < 10; ++i) {
    TypeParam value{};
    samples::randomize(valueOf(value), random);
    std::vector<std::byte> bytes;
    encode(value, bytes);
    const auto expectSame = [&](const TypeParam& read, const char* format) {
      std::vector<std::byte> again;
      encode(read, again);
      EXPECT_TRUE(again == bytes) << format;
    };

    TypeParam fromBinary{};
    ASSERT_TRUE(decode(bytes, fromBinary));
    expectSame(fromBinary, "binary");

    TypeParam fromText{};
    OutTextMemory text;
    text << value;
    InTextMemory in{text.text()};
    in >> fromText;
    ASSERT_TRUE(in) << in.error()->text();
    expectSame(fromText, "text");

    TypeParam fromConfig{};
    const auto result = parseConfig(writeConfig(value), "test.cfg", fromConfig);
    ASSERT_TRUE(result) << result.error().text();
    expectSame(fromConfig, "config");
  }
}

// ROS demands it of the names of fields, and that no two are the same.
TYPED_TEST(Representations, HaveFieldsWithNamesForRos) {
  std::vector<std::string> names;
  for (const Part& part : typeOf<TypeParam>().parts) {
    const std::string name = snakeCase(part.name);
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 0) << name;
    EXPECT_TRUE(!name.empty() && name.front() >= 'a' && name.front() <= 'z') << name;
    names.push_back(name);
  }
  EXPECT_FALSE(schemaOf<TypeParam>().text.empty());
}

}  // namespace
}  // namespace gt
