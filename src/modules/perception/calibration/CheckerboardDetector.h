#pragma once
#include "debug/Debug.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/calibration/CameraCalibrator.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {

/// Solution *CheckerboardDetector* of ImageProcessor: finds a checkerboard and nothing else, and
/// calibrates camera and body by it while the robot stands before it and looks around. Sends what
/// it found under the debug key `ImageProcessor/calibration`, a CameraCalibration.
class CheckerboardDetector {
 public:
  struct Parameters {
    Checkerboard board;
    int pictures = 40;

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::board>(),
          field<&Parameters::pictures>("after which it calibrates and begins anew", {3, 1000})};
    }
  };
  Parameters parameters;

  /// Provides the percepts of an image that shows nothing. Images with an invalid camera matrix,
  /// and those that the head took while it turned, do not count.
  void update(const Image& image, const CameraMatrix& matrix, const SensorDataBuffer& sensors,
              const RobotDimensions& robot, const RobotCalibration& calibration, Percepts percepts,
              Debug& debug);

  /// The last calibration; its images are 0 if there was none yet.
  const CameraCalibration& calibration() const { return result_; }
  const std::vector<Vector2d>& corners() const { return corners_; }

 private:
  void take(const CameraMatrix& matrix, const JointAngles& joints);
  void draw(bool found, Debug& debug) const;

  CheckerboardFinder finder_;
  std::vector<Vector2d> corners_;
  CameraCalibrator calibrator_{Checkerboard{}};
  Checkerboard known_;  ///< What the calibrator was made for.
  Vector3d lastAxis_ = Vector3d::Zero();
  CameraCalibration result_;
};

}  // namespace gt
