#pragma once
#include "debug/Debug.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/calibration/CameraCalibrator.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/SensorData.h"

namespace gt {

/// Solution *CheckerboardDetector* of ImageProcessor: finds only a checkerboard, and calibrates
/// camera and body with it while the robot stands in front of it and looks around. Sends the
/// result, a CameraCalibration, under the debug key `ImageProcessor/calibration`.
class CheckerboardDetector {
 public:
  struct Parameters {
    Checkerboard board;
    int pictures = 40;

    static constexpr auto fields() {
      return Fields{field<&Parameters::board>(),
                    field<&Parameters::pictures>(
                        "number of images after which it calibrates and starts again", {3, 1000})};
    }
  };
  Parameters parameters;

  /// Provides empty percepts. Images with an invalid camera matrix, and images taken while the head
  /// turned, are not used.
  void update(const Image& image, const CameraMatrix& matrix, const SensorDataBuffer& sensors,
              const RobotDimensions& robot, const RobotCalibration& calibration, Percepts percepts,
              Debug& debug);

  /// The last calibration; its number of images is 0 if there was none yet.
  const CameraCalibration& calibration() const { return result_; }
  const std::vector<Vector2d>& corners() const { return corners_; }

 private:
  void take(const CameraMatrix& matrix, const JointAngles& joints);
  void draw(bool found, Debug& debug) const;

  CheckerboardFinder finder_;
  std::vector<Vector2d> corners_;
  CameraCalibrator calibrator_{Checkerboard{}};
  Checkerboard known_;  ///< The board for which `calibrator_` was created.
  Vector3d lastAxis_ = Vector3d::Zero();
  CameraCalibration result_;
};

}  // namespace gt
