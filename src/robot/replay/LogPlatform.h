#pragma once
#include <memory>
#include <vector>

#include "debug/Drawing.h"
#include "logs/NaoLog.h"
#include "representations/infrastructure/Image.h"
#include "robot/Robot.h"

namespace gt {

/// The platform of a robot that runs on a log. Sends the recorded data, image by image, instead of
/// sensor readings, and ignores the robot's commands.
class LogPlatform {
 public:
  /// The representations that a log provides: images, the camera matrix of each, odometry.
  static const std::vector<const RepresentationType*>& representations();

  /// Makes the robot; `setup.platform` is replaced by the representations of a log. The log must
  /// outlive the platform.
  static Result<LogPlatform> make(const NaoLog& log, RobotSetup setup);

  bool finished() const { return next_ == log_->pictures.size(); }
  /// Sends the next image and the data that was recorded with it, and lets the robot's processes
  /// run. Returns an error if the image cannot be decoded; the next step continues after it.
  Result<void> step();

  /// The image of the last step.
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
