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

/// The data about one camera image in a real robot's log of 2009 (facts, 3). Provided by
/// readNaoLog.
struct NaoImage {
  int number = 0;  ///< From 0, in the order of the log.
  CameraMatrix cameraMatrix;
  Vector2d horizon = Vector2d::Zero();       ///< A point of the horizon in the image, pixels.
  Vector2d horizonDirection{1, 0};           ///< Direction of the horizon in the image, to the
                                             ///< right.
  Pose2D odometry;                           ///< Last odometry before the image, mm and rad.
  std::size_t jpegOffset = 0, jpegSize = 0;  ///< Position and size of the image in the file, in
                                             ///< bytes.
};

/// The data of one motion frame in a real robot's log (facts, 3). Provided by readNaoLog.
struct NaoMotionFrame {
  Time time;
  std::array<double, 22> joints{};  ///< rad; 1000 for missing joints.
  std::array<float, 18>
      sensors{};    ///< gyro 3, acceleration 3, battery, feet 8, ultrasound, body's angles 2.
  Pose2D odometry;  ///< mm and rad.

  static constexpr auto fields() {
    return Fields{
        field<&NaoMotionFrame::time>(Unit::ms),
        field<&NaoMotionFrame::joints>(Unit::rad, "joint angles; 1000 for missing joints"),
        field<&NaoMotionFrame::sensors>(
            "sensor values: gyro 3, acceleration 3, battery, feet 8, ultrasound, body's angles 2"),
        field<&NaoMotionFrame::odometry>(Unit::mmRad)};
  }
};

/// A log of a real robot in memory: its frames in the order of time (facts, 3).
class NaoLog {
 public:
  std::vector<NaoImage> pictures;
  std::vector<NaoMotionFrame> motionFrames;
  std::vector<Error> damage;  ///< Errors for unreadable messages, and for the place where the log
                              ///< is cut off.

  /// Decodes an image. The error names the image and its time.
  Result<void> decode(const NaoImage& picture, Image& image) const;

 private:
  friend Result<NaoLog> parseNaoLog(std::string bytes, const std::string& file);

  std::string file_;
  std::string bytes_;
};

/// Whether a file begins in the way of such a log.
bool isNaoLog(const std::string& file);

/// Parses the undamaged part of a log from the bytes of a file. Returns an error if no message is
/// readable.
Result<NaoLog> parseNaoLog(std::string bytes, const std::string& file);

/// Reads a log file (facts, 3).
Result<NaoLog> readNaoLog(const std::string& file);

}  // namespace gt
