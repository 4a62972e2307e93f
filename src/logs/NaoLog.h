#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"
#include "base/Time.h"
#include "representations/infrastructure/Image.h"
#include "representations/perception/CameraMatrix.h"

namespace gt {

/// What a real robot's log of 2009 contains about one camera image (facts, 3). Provided by
/// readNaoLog.
struct NaoImage {
  int number = 0;  ///< From 0, in the order of the log.
  CameraMatrix cameraMatrix;
  Vector2d horizon = Vector2d::Zero();       ///< A point of the horizon in the image, pixels.
  Vector2d horizonDirection{1, 0};           ///< Along the horizon to the right.
  Pose2D odometry;                           ///< The last one before the image, mm and rad.
  std::size_t jpegOffset = 0, jpegSize = 0;  ///< Where in the file the image stands.
};

/// What a real robot's log contains about one motion frame (facts, 3). Provided by readNaoLog.
struct NaoMotionFrame {
  Time time;
  std::array<double, 22> joints{};  ///< rad; 1000 where a joint is not there.
  std::array<float, 18>
      sensors{};    ///< gyro 3, acceleration 3, battery, feet 8, ultrasound, body's angles 2.
  Pose2D odometry;  ///< mm and rad.

  static constexpr auto fields() {
    return Fields{field<&NaoMotionFrame::time>(Unit::ms),
                  field<&NaoMotionFrame::joints>(Unit::rad, "1000 where a joint is not there"),
                  field<&NaoMotionFrame::sensors>(
                      "gyro 3, acceleration 3, battery, feet 8, ultrasound, body's angles 2"),
                  field<&NaoMotionFrame::odometry>(Unit::mmRad)};
  }
};

/// A log of a real robot in memory: its frames in the order of time (facts, 3).
class NaoLog {
 public:
  std::vector<NaoImage> pictures;
  std::vector<NaoMotionFrame> motionFrames;
  std::vector<Error> damage;  ///< Messages that cannot be read, and where the log is cut off.

  /// Decodes an image. The error names the image and its time.
  Result<void> decode(const NaoImage& picture, Image& image) const;

 private:
  friend Result<NaoLog> parseNaoLog(std::string bytes, const std::string& file);

  std::string file_;
  std::string bytes_;
};

/// Whether a file begins as such a log does.
bool isNaoLog(const std::string& file);

/// The log in the bytes of a file, as far as it is whole. An error if no message of it is.
Result<NaoLog> parseNaoLog(std::string bytes, const std::string& file);

/// Reads a log file (facts, 3).
Result<NaoLog> readNaoLog(const std::string& file);

}  // namespace gt
