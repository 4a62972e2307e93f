#include "modules/perception/calibration/CheckerboardDetector.h"

#include <cstdio>

#include "modules/perception/processors/DefaultSensorDataProcessor.h"

namespace gt {
namespace {

const DebugKey drawCheckerboard{"ImageProcessor/checkerboard"};
const DebugKey sendCalibration{"ImageProcessor/calibration"};

bool isSame(const Checkerboard& a, const Checkerboard& b) {
  return a.columns == b.columns && a.rows == b.rows && a.square == b.square && a.height == b.height;
}

std::string describe(const CameraCalibration& c) {
  char text[200];
  std::snprintf(
      text, sizeof text,
      "opening angles %.2f x %.2f deg (+- %.2f), bodyTiltOffset %.4f, bodyRollOffset %.4f "
      "(+- %.4f), error %.2f pixels in %d images",
      toDegrees(c.openingAngleX), toDegrees(c.openingAngleY), toDegrees(c.openingAngleError),
      c.body.bodyTiltOffset, c.body.bodyRollOffset, c.offsetError, c.error, c.pictures);
  return text;
}

}  // namespace

void CheckerboardDetector::update(const Image& image, const CameraMatrix& matrix,
                                  const SensorDataBuffer& sensors, const RobotDimensions& robot,
                                  const RobotCalibration& calibration, Percepts percepts,
                                  Debug& debug) {
  percepts.clear(image.time);
  if (!isSame(parameters.board, known_)) {
    known_ = parameters.board;
    calibrator_ = CameraCalibrator{known_};
  }
  const bool found = finder_.find(image, horizonOf(matrix), known_, corners_);
  draw(found, debug);
  if (!found || !matrix.valid) return;
  const double duration = (image.info.height - 1) * image.info.rowTime;
  take(matrix, jointMotion(sensors, image.time, duration).angles);
  if (static_cast<int>(calibrator_.pictures()) < parameters.pictures) return;
  if (calibrator_.calibrate(image.info, robot, calibration, result_)) {
    debug.text(describe(result_));
    debug.send(sendCalibration, result_);
  }
  calibrator_.clear();
}

// While the head turns, the rows of an image see the board from different directions. An image from
// the same direction as the last one adds no information.
void CheckerboardDetector::take(const CameraMatrix& matrix, const JointAngles& joints) {
  constexpr double mostTurning = 0.15, leastApart = 0.01;  // rad/s, rad
  const Vector3d axis = matrix.pose.rotation.col(0);
  if (matrix.turning.norm() > mostTurning || (axis - lastAxis_).norm() < leastApart) return;
  lastAxis_ = axis;
  calibrator_.add(corners_, joints);
}

void CheckerboardDetector::draw(bool found, Debug& debug) const {
  auto canvas = debug.onImage(drawCheckerboard);
  if (!canvas) return;
  for (const Vector2d& candidate : finder_.candidates()) canvas.point(candidate, colors::blue, 1);
  if (!found) return;
  for (std::size_t i = 0; i + 1 < corners_.size(); ++i)
    canvas.line(corners_[i], corners_[i + 1], colors::green, 0.5);
  for (const Vector2d& corner : corners_) canvas.point(corner, colors::red, 1);
}

}  // namespace gt
