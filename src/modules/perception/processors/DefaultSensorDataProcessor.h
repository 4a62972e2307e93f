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

/// Makes the camera matrix of an image, the body percept and the PSD percept from the sensor
/// frames around them (report 3.1), the solution Default of the SensorDataProcessor.
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
          field<&Parameters::shortAverage>(Unit::ticks, "over which acceleration is averaged",
                                           {1, SensorDataBuffer::capacity}),
          field<&Parameters::longAverage>(
              Unit::ms, "time constant of the long average of acceleration", {100, 10000}),
          field<&Parameters::fallenAngle>(Unit::rad, "a body that leans more has fallen", {0, pi}),
          field<&Parameters::liftedChange>(
              Unit::mmPerS2, "short and long average differ by more where the robot is lifted",
              {0, 20000}),
          field<&Parameters::offGround>(
              Unit::ms, "all paws are longer off the ground where the robot is lifted", {0, 10000}),
          field<&Parameters::delayMemory>(
              Unit::ms,
              "time constant with which it is learned how much older images are than their time "
              "stamps",
              {1000, 1e7}),
          field<&Parameters::posture>("how bodies lean on legs that give"),
          field<&Parameters::lean>("how it is learned in play how this robot leans")};
    }
  };
  Parameters parameters;

  /// Provides the camera matrix of the image, the body's state and the distance sensor's place. The
  /// body's posture follows from the legs and how they give, and from what was seen in images
  /// before. The matrix is invalid while the robot kicks, gets up or falls, but not while it holds
  /// still in a special action; without sensor readings it is that of the last ones. The flags of
  /// the last image tell how old images are.
  void update(const FrameInfo& frame, const SensorDataBuffer& sensors, const Image& image,
              const RobotDimensions& robot, const RobotCalibration& calibration,
              const FieldDimensions& field, const MotionInfo& motion, const OdometryData& odometry,
              Previous<BallPercept> ball, Previous<LandmarksPercept> landmarks,
              CameraMatrix& matrix, BodyPercept& body, PsdPercept& psd,
              LearnedCalibration& learned);

 private:
  BodyState stateOf(const Vector3d& shortAverage, const SensorData& newest, bool onPaws);

  LeanFilter lean_;
  BodyPosture giving_;            ///< That of the model, with the last matrix.
  bool stood_ = false;            ///< With that matrix, on its legs.
  RobotCalibration calibration_;  ///< With which it learns.
  std::vector<SeenHeight> heights_;
  ImageDelay delay_;
  CameraMatrix lastMatrix_;
  LandmarksPercept lastLandmarks_;
  BallPercept lastBall_;
  Pose2D odometry_;  ///< With the last matrix.
  Vector3d longAverage_ = Vector3d::Zero();
  Time lastUpdate_ = never();
  Time lastOnGround_ = never();
};

/// How the joints moved around a moment: a line through what was measured, which takes from each
/// measurement's noise.
struct JointMotion {
  JointAngles angles, perMillisecond;

  JointAngles at(double milliseconds) const;
};

/// The joints' motion from `duration` milliseconds before a point in time until then, around the
/// moment halfway; the newest frame that is not younger if none lies in between.
JointMotion jointMotion(const SensorDataBuffer& sensors, Time end, double duration);

/// The mean acceleration of the last ticks (report 3.1); of all there are if they are fewer.
Vector3d averageAcceleration(const SensorDataBuffer& sensors, int ticks);

}  // namespace gt
