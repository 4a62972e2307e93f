#include <span>
#include <tuple>

#include "Fuzz.h"
#include "debug/Drawing.h"
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
#include "representations/perception/PsdPercept.h"
#include "streams/Binary.h"

namespace {

template <typename... T>
void decodeAll(std::span<const std::byte> bytes) {
  // Static: some are large.
  static std::tuple<T...> values;
  std::apply([&](auto&... value) { ((void)!gt::decode(bytes, value), ...); }, values);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gt;
  decodeAll<Drawing, HeadControlMode, LedRequest, LedValue, MotionRequest, BehaviorTeamMessage,
            TeamMessage, TeamMessages, CameraInfo, FieldDimensions, FrameInfo, GameControlData,
            Image, JointData, OracledWorldState, Player, RobotDimensions, SensorData,
            SensorDataBuffer, BallModel, TeamBallModel, RobotPose, RobotState, HeadMotionRequest,
            MotionInfo, OdometryData, SpecialActionsOutput, WalkingEngineOutput, BallPercept,
            BodyPercept, CameraMatrix, ColorTable64, LandmarksPercept, PsdPercept>(
      std::as_bytes(std::span{data, size}));
  return 0;
}
