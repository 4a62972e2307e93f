#include "modules/perception/processors/DefaultSensorDataProcessor.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "modules/kinematics/BodyPosture.h"
#include "modules/kinematics/HeadKinematics.h"

namespace gt {
namespace {

// The position of the distance sensor relative to the center of pan rotation: forward, and up while
// the neck is upright (mm) (facts, 1.1: 61.4 above the tilt axis, from which the pan center is 48
// away).
constexpr double psdForward = 26.5, psdUp = 13.4;
constexpr double psdRange = 900;

Pose3D cameraPoseOn(const RobotDimensions& robot, const BodyPosture& posture,
                    const JointAngles& joints) {
  return cameraPose(robot, bodyPose(posture),
                    {joints[Joint::headTilt], joints[Joint::headPan], joints[Joint::headRoll]});
}

/// The mean acceleration of all frames (mm/s^2) if the legs hold still in them and only gravity
/// acts; otherwise nothing.
std::optional<Vector3d> gravityAtRest(const SensorDataBuffer& sensors) {
  constexpr double still = fromDegrees(15) / 1000;  // rad/ms; of a joint
  constexpr double gravity = 9810, allowed = 1000;  // mm/s^2; with the sensors' zero
  const Time newest = sensors.newest().time;
  const auto duration = static_cast<double>(newest - sensors.frames.front().time);
  const JointMotion joints = jointMotion(sensors, newest, duration);
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
    for (int number = 1; number <= 3; ++number)
      if (std::abs(joints.perMillisecond[legJoint(leg, number)]) > still) return std::nullopt;
  const Vector3d mean = averageAcceleration(sensors, SensorDataBuffer::capacity);
  if (std::abs(mean.norm() - gravity) > allowed) return std::nullopt;
  return mean;
}

/// The rotation vector of a rotation matrix.
Vector3d rotationVector(const Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  return turn.axis() * turn.angle();
}

/// The direction of the camera's optical axis relative to the robot (rad, positive: left).
double azimuthOf(const CameraMatrix& matrix) {
  return angleOf(matrix.pose.rotation.col(0).head<2>());
}

/// Whether the time of a frame lies in an image's exposure, half a tick early or late included.
bool isDuring(const SensorData& frame, Time end, double duration) {
  constexpr double halfTick = 4;
  const double age = static_cast<double>(end - frame.time);
  return age >= -halfTick && age <= duration + halfTick;
}

/// The time from the exposure of an image's first row to that of its last row (ms).
double exposureOf(const Image& image) {
  return (image.info.height - 1) * image.info.rowTime;
}

/// The camera's pose when an image's middle row was exposed, and how it turned during the exposure.
/// `delay` is by how much the image is older than its time stamp (ms). `speed` is that of the robot
/// (mm/s, rad/s). The robot's system is that at the time stamp. `poseFor` returns the camera's pose
/// for joint angles.
template <typename PoseFor>
CameraMatrix cameraMatrix(const JointMotion& joints, const Image& image, double delay,
                          const Pose2D& speed, PoseFor poseFor) {
  const CameraInfo& info = image.info;
  const double duration = exposureOf(image);
  const auto poseAt = [&](double milliseconds) { return poseFor(joints.at(milliseconds)); };
  CameraMatrix matrix;
  matrix.time = image.time;
  matrix.info = info;
  const double back = -(duration / 2 + delay) / 1000;
  const Vector2d way = speed.translation * back;
  matrix.pose = Pose3D{rotationZ(speed.rotation * back), {way.x(), way.y(), 0}} * poseAt(0);
  matrix.turning = {0, 0, speed.rotation};
  if (duration > 0)
    matrix.turning +=
        rotationVector(poseAt(duration / 2).rotation * poseAt(-duration / 2).rotation.transpose()) /
        (duration / 1000);
  return matrix;
}

}  // namespace

JointAngles JointMotion::at(double milliseconds) const {
  JointAngles joints;
  for (std::size_t i = 0; i < joints.values.size(); ++i)
    joints.values[i] = angles.values[i] + milliseconds * perMillisecond.values[i];
  return joints;
}

JointMotion jointMotion(const SensorDataBuffer& sensors, Time end, double duration) {
  double n = 0, squares = 0, sum = 0;
  const auto since = [&](const SensorData& frame) {
    return static_cast<double>(frame.time - end) + duration / 2;
  };
  for (const SensorData& frame : sensors.frames) {
    if (!isDuring(frame, end, duration)) continue;
    n += 1;
    sum += since(frame);
  }
  JointMotion motion;
  if (n == 0) {
    motion.angles = sensors.at(end).joints;
    return motion;
  }
  const double middle = sum / n;
  for (const SensorData& frame : sensors.frames)
    if (isDuring(frame, end, duration)) squares += std::pow(since(frame) - middle, 2);
  for (std::size_t i = 0; i < motion.angles.values.size(); ++i) {
    double angle = 0, slope = 0;
    for (const SensorData& frame : sensors.frames) {
      if (!isDuring(frame, end, duration)) continue;
      angle += frame.joints.values[i] / n;
      slope += frame.joints.values[i] * (since(frame) - middle);
    }
    motion.perMillisecond.values[i] = squares > 0 ? slope / squares : 0;
    motion.angles.values[i] = angle - middle * motion.perMillisecond.values[i];
  }
  return motion;
}

Vector3d averageAcceleration(const SensorDataBuffer& sensors, int ticks) {
  const int n = std::clamp(ticks, 1, SensorDataBuffer::capacity);
  Vector3d sum = Vector3d::Zero();
  for (int i = SensorDataBuffer::capacity - n; i < SensorDataBuffer::capacity; ++i)
    sum += sensors.frames[static_cast<std::size_t>(i)].acceleration;
  return sum / n;
}

void DefaultSensorDataProcessor::update(const FrameInfo& frame, const SensorDataBuffer& sensors,
                                        const Image& image, const RobotDimensions& robot,
                                        const RobotCalibration& calibration,
                                        const FieldDimensions& field, const MotionInfo& motion,
                                        const OdometryData& odometry, Previous<BallPercept> ball,
                                        Previous<LandmarksPercept> landmarks, CameraMatrix& matrix,
                                        BodyPercept& body, PsdPercept& psd,
                                        LearnedCalibration& learned) {
  // On a log that holds percepts instead of images, those of this image have come already.
  if (landmarks->time == lastMatrix_.time) {
    lastLandmarks_ = *landmarks;
    lastBall_ = *ball;
  }
  delay_.learn(lastLandmarks_, lastMatrix_, odometry_, field, parameters.delayMemory);
  // With another robot.cfg it is another robot.
  if (calibration != calibration_) lean_ = {};
  calibration_ = calibration;
  lean_.parameters = parameters.lean;
  if (stood_ && lastLandmarks_.time == lastMatrix_.time) {
    takeHeights(lastMatrix_, lastBall_, lastLandmarks_, field, heights_);
    lean_.learn(heights_, azimuthOf(lastMatrix_), giving_);
  }
  lastLandmarks_ = *landmarks;
  lastBall_ = *ball;
  const SensorData& newest = sensors.newest();
  const Vector3d shortAverage = averageAcceleration(sensors, parameters.shortAverage);
  const double elapsed = static_cast<double>(frame.time - lastUpdate_);
  const double gain = 1 - std::exp(-elapsed / parameters.longAverage);
  longAverage_ += std::clamp(gain, 0.0, 1.0) * (shortAverage - longAverage_);
  lastUpdate_ = frame.time;
  const Pose2D walked = odometry.pose.relativeTo(odometry_);
  odometry_ = odometry.pose;
  Pose2D speed;
  // After a longer time it is not valid for this image.
  if (elapsed > 0 && elapsed <= 200)
    speed = {walked.rotation * 1000 / elapsed, walked.translation * 1000 / elapsed};

  const BodyPosture posture = bodyPosture(robot, newest.joints);
  body.time = newest.time;
  body.state = stateOf(shortAverage, newest, motion.stable);
  body.tilt = std::atan2(shortAverage.x(), std::hypot(shortAverage.y(), shortAverage.z()));
  body.roll = std::atan2(shortAverage.y(), shortAverage.z());
  body.height = posture.height;
  body.switches = newest.switches;
  body.tailPan = newest.joints[Joint::tailPan];

  const double exposure = exposureOf(image);
  const double delay = delay_.milliseconds();
  const Time end = image.time - std::lround(delay);
  const JointMotion joints = jointMotion(sensors, end, exposure);
  const bool stands = body.state == BodyState::standing;
  lean_.predict(elapsed, speed.rotation != 0 || !speed.translation.isZero());
  const PostureModel legsGive{parameters.posture};
  const auto givingAt = [&](Time moment) {
    return legsGive.correction(PostureModel::featuresAt(robot, sensors, moment));
  };
  // What neither walks nor kicks may lie, as a goalie that blocks: how it lies shows at rest.
  const std::optional<Vector3d> gravity = motion.stable ? std::nullopt : gravityAtRest(sensors);
  const auto poseFor = [&](JointAngles angles, const BodyPosture& giving) {
    const BodyPosture leaned =
        gravity ? restingPosture(robot, angles, *gravity)
                : bodyPosture(robot, calibration, angles) + lean_.posture(giving);
    angles[Joint::headRoll] += calibration.headRollOffset + lean_.headRoll();
    return cameraPoseOn(robot, leaned, angles);
  };
  giving_ = givingAt(image.time - std::lround(delay + exposure / 2));
  matrix = cameraMatrix(joints, image, delay, speed,
                        [&](const JointAngles& angles) { return poseFor(angles, giving_); });
  matrix.covariance = lean_.covariance(azimuthOf(matrix), giving_);
  matrix.valid = stands && (motion.stable || gravity);
  stood_ = stands && motion.stable;
  lastMatrix_ = matrix;

  const BodyPosture built = lean_.built(), deviation = lean_.deviation();
  learned.robot = {calibration.bodyTiltOffset + built.tilt, calibration.bodyRollOffset + built.roll,
                   calibration.bodyHeightOffset + built.height,
                   calibration.headRollOffset + lean_.headRoll()};
  learned.deviation = {deviation.tilt, deviation.roll, deviation.height, lean_.headRollDeviation()};
  learned.legsGive = lean_.legsGive();
  learned.imageDelay = delay;

  const Pose3D camera = poseFor(newest.joints, givingAt(newest.time));
  psd.time = newest.time;
  psd.tooFarAway = newest.psd >= psdRange;
  psd.offset = camera * Vector3d{psdForward - robot.panToCamera + newest.psd, 0, psdUp};
}

// Fallen: the body has leaned for a long time and still leans. Lifted: direction or strength of the
// acceleration differ from its long average, or the feet hang in the air (report 3.1). A robot that
// performs a special action may lie with its paws off the ground.
BodyState DefaultSensorDataProcessor::stateOf(const Vector3d& shortAverage,
                                              const SensorData& newest, bool onPaws) {
  const auto leans = [&](const Vector3d& acceleration) {
    return acceleration.z() < std::cos(parameters.fallenAngle) * acceleration.norm();
  };
  bool anyPaw = false;
  for (const Switch paw : {Switch::pawFR, Switch::pawFL, Switch::pawHR, Switch::pawHL})
    anyPaw = anyPaw || newest.switches[paw];
  if (anyPaw || !onPaws) lastOnGround_ = newest.time;
  if (leans(shortAverage) && leans(longAverage_)) return BodyState::fallen;
  const bool changed = (shortAverage - longAverage_).norm() > parameters.liftedChange;
  const bool hangs = static_cast<double>(newest.time - lastOnGround_) > parameters.offGround;
  return !anyPaw && (changed || hangs) ? BodyState::liftedUp : BodyState::standing;
}

}  // namespace gt
