#pragma once
#include <memory>
#include <vector>

#include "debug/Drawing.h"
#include "logs/NaoLog.h"
#include "representations/infrastructure/Image.h"
#include "robot/Robot.h"

namespace gt {

/// The platform of a robot that runs on a log: instead of sensor readings it sends what was
/// recorded, image by image, and drops the robot's commands.
class LogPlatform {
 public:
  /// What a log provides: images, the camera matrix of each, odometry.
  static const std::vector<const RepresentationType*>& representations();

  /// Makes the robot; `setup.platform` becomes what a log provides. The log outlives the platform.
  static Result<LogPlatform> make(const NaoLog& log, RobotSetup setup);

  bool finished() const { return next_ == log_->pictures.size(); }
  /// Sends the next image and what was recorded with it, and gives the robot's processes their
  /// turn. An image that cannot be decoded is an error; the step after it goes on behind it.
  Result<void> step();

  /// Of the last step.
  const NaoImage& picture() const { return log_->pictures[next_ - 1]; }
  const Image& image() const { return image_; }
  /// What the robot drew on that image.
  const std::vector<Drawing>& drawings() const { return drawings_; }
  Robot& robot() { return *robot_; }
  const Robot& robot() const { return *robot_; }

 private:
  LogPlatform(const NaoLog& log, std::unique_ptr<Robot> robot)
      : log_{&log}, robot_{std::move(robot)} {}

  const NaoLog* log_;
  std::unique_ptr<Robot> robot_;
  std::size_t next_ = 0;
  Image image_;
  std::vector<Drawing> drawings_;
};

}  // namespace gt
