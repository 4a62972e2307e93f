#include "modules/perception/DefaultSensorDataProcessor.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"

namespace gt {
namespace {

// The distance sensor from the centre of pan rotation: forward, and up where the neck is upright
// (facts, 1.1: 61.4 above the tilt axis, from which the pan centre is 48 away).
constexpr double psdForward = 26.5, psdUp = 13.4;
constexpr double psdRange = 900;

Pose3D cameraPoseFor(const RobotDimensions& robot, const RobotCalibration& calibration,
                     const JointAngles& joints) {
  return cameraPose(robot, bodyPose(bodyPosture(robot, calibration, joints)),
                    {joints[Joint::headTilt], joints[Joint::headPan], joints[Joint::headRoll]});
}

/// The rotation vector of a rotation matrix.
Vector3d rotationVector(const Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.axis() * turn.angle();
}

Vector3d averageAcceleration(const SensorDataBuffer& sensors) {
  Vector3d sum = Vector3d::Zero();
  for (const SensorData& frame : sensors.frames) sum += frame.acceleration;
  return sum / SensorDataBuffer::capacity;
}

/// The camera's pose when a picture's middle row was exposed, and how it turned meanwhile.
void computeMatrix(const SensorDataBuffer& sensors, const Image& image,
                   const RobotDimensions& robot, const RobotCalibration& calibration,
                   CameraMatrix& matrix) {
  const CameraInfo& info = image.info;
  const auto poseAtRow = [&](double row) {
    return cameraPoseFor(robot, calibration,
                         jointsAt(sensors, image.time, (row - (info.height - 1)) * info.rowTime));
  };
  matrix.time = image.time;
  matrix.info = info;
  matrix.pose = poseAtRow(info.height / 2.0);
  const double seconds = (info.height - 1) * info.rowTime / 1000;
  matrix.turning = Vector3d::Zero();
  if (seconds > 0)
    matrix.turning =
        rotationVector(poseAtRow(info.height - 1).rotation * poseAtRow(0).rotation.transpose()) /
        seconds;
}

}  // namespace

JointAngles jointsAt(const SensorDataBuffer& sensors, Time start, double milliseconds) {
  const auto& frames = sensors.frames;
  std::size_t after = frames.size() - 1;
  const auto age = [&](std::size_t i) {
    return static_cast<double>(frames[i].time - start) - milliseconds;
  };
  while (after > 0 && age(after - 1) >= 0) --after;
  if (after == 0 || age(after) <= 0) return frames[after].joints;
  const double low = age(after - 1), high = age(after);
  const double part = -low / std::max(high - low, 1e-9);
  JointAngles joints;
  for (std::size_t i = 0; i < joints.values.size(); ++i) {
    const double before = frames[after - 1].joints.values[i];
    joints.values[i] = before + part * (frames[after].joints.values[i] - before);
  }
  return joints;
}

void DefaultSensorDataProcessor::update(const FrameInfo& frame, const SensorDataBuffer& sensors,
                                        const Image& image, const RobotDimensions& robot,
                                        const RobotCalibration& calibration,
                                        const MotionInfo& motion, CameraMatrix& matrix,
                                        BodyPercept& body, PsdPercept& psd) {
  const SensorData& newest = sensors.newest();
  const Vector3d shortAverage = averageAcceleration(sensors);
  const double elapsed = static_cast<double>(frame.time - lastUpdate_);
  const double gain = 1 - std::exp(-elapsed / parameters.longAverage);
  longAverage_ += std::clamp(gain, 0.0, 1.0) * (shortAverage - longAverage_);
  lastUpdate_ = frame.time;

  const BodyPosture posture = bodyPosture(robot, newest.joints);
  body.time = newest.time;
  body.state = stateOf(shortAverage, newest);
  body.tilt = std::atan2(shortAverage.x(), std::hypot(shortAverage.y(), shortAverage.z()));
  body.roll = std::atan2(shortAverage.y(), shortAverage.z());
  body.height = posture.height;
  body.switches = newest.switches;

  computeMatrix(sensors, image, robot, calibration, matrix);
  matrix.valid = motion.stable && body.state == BodyState::standing;

  const Pose3D camera = cameraPoseFor(robot, calibration, newest.joints);
  psd.time = newest.time;
  psd.tooFarAway = newest.psd >= psdRange;
  psd.offset = camera * Vector3d{psdForward - robot.panToCamera + newest.psd, 0, psdUp};
}

// Fallen: the body leans for long, and still does. Lifted: gravity's direction or strength is no
// longer what it has been for long, or the feet hang in the air (report 3.1).
BodyState DefaultSensorDataProcessor::stateOf(const Vector3d& shortAverage,
                                              const SensorData& newest) {
  const auto leans = [&](const Vector3d& acceleration) {
    return acceleration.z() < std::cos(parameters.fallenAngle) * acceleration.norm();
  };
  bool anyPaw = false;
  for (const Switch paw : {Switch::pawFR, Switch::pawFL, Switch::pawHR, Switch::pawHL})
    anyPaw = anyPaw || newest.switches[paw];
  if (anyPaw) lastOnGround_ = newest.time;
  if (leans(shortAverage) && leans(longAverage_)) return BodyState::fallen;
  const bool changed = (shortAverage - longAverage_).norm() > parameters.liftedChange;
  const bool hangs = static_cast<double>(newest.time - lastOnGround_) > parameters.offGround;
  return !anyPaw && (changed || hangs) ? BodyState::liftedUp : BodyState::standing;
}

}  // namespace gt
