#include <array>
#include <span>
#include <tuple>

#include "Fuzz.h"
#include "debug/Drawing.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/OracledWorldState.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/RobotPose.h"
#include "representations/perception/LandmarksPercept.h"
#include "streams/Binary.h"

namespace {

using Types = std::tuple<gt::Drawing, gt::MotionRequest, gt::TeamMessages, gt::GameControlData,
                         gt::Image, gt::OracledWorldState, gt::SensorDataBuffer, gt::BallModel,
                         gt::RobotPose, gt::LandmarksPercept>;

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto bytes = std::as_bytes(std::span{data, size});
  Types values;
  std::apply([&](auto&... value) { ((void)!gt::decode(bytes, value), ...); }, values);
  return 0;
}
