#pragma once
#include "framework/Module.h"
#include "modules/perception/Tasks.h"
#include "modules/perception/processors/ImageDelay.h"
#include "modules/perception/processors/LeanFilter.h"
#include "modules/perception/processors/PostureModel.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/Image.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"

namespace gt {

/// Solution *Default* of SensorDataProcessor: computes the camera matrix of an image, the body
/// percept and the percept of the distance sensor (PSD) from the sensor frames around the image
/// (report 3.1).
class DefaultSensorDataProcessor {
 public:
  struct Parameters {
    int shortAverage = 16;
    double longAverage = 1500;
    double fallenAngle = fromDegrees(50);
    double liftedChange = 2500;
    double offGround = 400;
    double delayMemory = 60000;
    PostureModel::Parameters posture;
    LeanFilter::Parameters lean;

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::shortAverage>(Unit::ticks,
                                           "duration over which acceleration is averaged",
                                           {1, SensorDataBuffer::capacity}),
          field<&Parameters::longAverage>(
              Unit::ms, "time constant of the long average of acceleration", {100, 10000}),
          field<&Parameters::fallenAngle>(Unit::rad, "least inclination of a body that has fallen",
                                          {0, pi}),
          field<&Parameters::liftedChange>(
              Unit::mmPerS2,
              "least difference of the short and the long average of acceleration of a lifted "
              "robot",
              {0, 20000}),
          field<&Parameters::offGround>(
              Unit::ms, "least time without a paw on the ground after which a robot is lifted",
              {0, 10000}),
          field<&Parameters::delayMemory>(
              Unit::ms,
              "time constant of learning by how much images are older than their time stamps",
              {1000, 1e7}),
          field<&Parameters::posture>("how bodies lean and sink on legs that give way"),
          field<&Parameters::lean>("how the inclination of this robot is learned in play")};
    }
  };
  Parameters parameters;

  /// Provides the camera matrix of the image, the body's state and the point that the distance
  /// sensor measures. The body's posture is computed from the joint angles of the legs, from a
  /// model of how the legs give way, and from what was seen in earlier images. The matrix is
  /// invalid while the robot kicks, gets up or falls, but valid while it holds still in a special
  /// action. Without new sensor readings the last ones are used. The delay of images is learned
  /// from the flags in the last image.
  void update(const FrameInfo& frame, const SensorDataBuffer& sensors, const Image& image,
              const RobotDimensions& robot, const RobotCalibration& calibration,
              const FieldDimensions& field, const MotionInfo& motion, const OdometryData& odometry,
              Previous<BallPercept> ball, Previous<LandmarksPercept> landmarks,
              CameraMatrix& matrix, BodyPercept& body, PsdPercept& psd,
              LearnedCalibration& learned);

 private:
  BodyState stateOf(const Vector3d& shortAverage, const SensorData& newest, bool onPaws);

  LeanFilter lean_;
  BodyPosture giving_;            ///< The posture model's correction for the last matrix.
  bool stood_ = false;            ///< Whether the robot stood on its legs at the last matrix.
  RobotCalibration calibration_;  ///< The calibration for which `lean_` learns.
  std::vector<SeenHeight> heights_;
  ImageDelay delay_;
  CameraMatrix lastMatrix_;
  LandmarksPercept lastLandmarks_;
  BallPercept lastBall_;
  Pose2D odometry_;  ///< At the last matrix.
  Vector3d longAverage_ = Vector3d::Zero();
  Time lastUpdate_ = never();
  Time lastOnGround_ = never();
};

/// The motion of the joints around a moment: a straight line fitted to the measurements, which
/// reduces their noise. In rad and rad/ms.
struct JointMotion {
  JointAngles angles, perMillisecond;

  JointAngles at(double milliseconds) const;
};

/// The joints' motion in the interval of `duration` (ms) that ends at `end`, relative to the middle
/// of the interval. If no sensor frame lies in the interval, the joint angles of the newest frame
/// before its end.
JointMotion jointMotion(const SensorDataBuffer& sensors, Time end, double duration);

/// The mean acceleration (mm/s^2) of the last ticks (report 3.1), at most of those in the buffer.
Vector3d averageAcceleration(const SensorDataBuffer& sensors, int ticks);

}  // namespace gt
