#include "robot/replay/LogPlatform.h"

#include <utility>

#include "representations/infrastructure/SensorData.h"
#include "representations/motion/OdometryData.h"

namespace gt {

const std::vector<const RepresentationType*>& LogPlatform::representations() {
  // Not all logs hold a robot's joints: then they are never sent, but defaults may want them.
  static const std::vector<const RepresentationType*> list{
      &representation<Image>(), &representation<CameraMatrix>(), &representation<OdometryData>(),
      &representation<SensorDataBuffer>()};
  return list;
}

Result<LogPlatform> LogPlatform::make(const NaoLog& log, RobotSetup setup) {
  setup.platform = representations();
  auto robot = Robot::make(setup);
  if (!robot) return robot.error();
  return LogPlatform{log, std::move(*robot)};
}

Result<void> LogPlatform::step() {
  const NaoImage& picture = log_->pictures[next_++];
  drawings_.clear();
  robot_->toTools().clear();
  if (auto done = log_->decode(picture, image_); !done) return done;
  robot_->send(picture.cameraMatrix);
  robot_->send(OdometryData{picture.odometry});
  robot_->send(image_);
  robot_->step(image_.time);
  robot_->toTools().handleAllMessages([this](const Message& message) {
    Drawing drawing;
    if (message.is<Drawing>() && message.read(drawing) && drawing.space == DrawingSpace::image)
      drawings_.push_back(std::move(drawing));
  });
  return {};
}

}  // namespace gt
