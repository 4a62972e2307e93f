#pragma once
#include "debug/Debug.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/modeling/BallModel.h"
#include "representations/modeling/ObstaclesModel.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/CameraMatrix.h"
#include "representations/perception/LandmarksPercept.h"
#include "representations/perception/ObstaclesPercept.h"
#include "representations/perception/PsdPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *Default* of ObstaclesLocator: keeps a radar-like view of the surroundings from the
/// free ground seen in images, the distance sensor and odometry (report 3.5).
class DefaultObstaclesLocator {
 public:
  struct Parameters {
    bool useImages = true;
    bool usePsd = false;
    double psdAgreement = 0;
    std::int64_t forgetAfter = 4000;
    double caution = fromDegrees(0.6);
    double ballSize = 150;
    std::int64_t ballTime = 500;
    double lowestObstacle = 100;
    double highestObstacle = 300;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::useImages>("whether images count"),
          field<&P::usePsd>("whether the distance sensor counts; it did not in the competition"),
          field<&P::psdAgreement>(
              Unit::mm,
              "greatest distance between two consecutive readings of the distance sensor that "
              "count, which rejects reflections; 0: all count",
              {0, 10000}),
          field<&P::forgetAfter>(Unit::ms,
                                 "time after which a sector that is not seen again is forgotten",
                                 {100, 100000}),
          field<&P::caution>(
              Unit::rad, "angle by which the end of free ground may be seen too high", {0, 0.2}),
          field<&P::ballSize>(
              Unit::mm,
              "distance from the ball within which the end of free ground is no obstacle, but the "
              "ball",
              {0, 1000}),
          field<&P::ballTime>(
              Unit::ms, "time since the ball was seen during which ballSize applies", {0, 10000}),
          field<&P::lowestObstacle>(
              Unit::mm,
              "height of the lowest obstacle; where the distance sensor's ray is higher, it does "
              "not free the ground",
              {1, 1000}),
          field<&P::highestObstacle>(
              Unit::mm, "height above which a point measured by the distance sensor is no obstacle",
              {1, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the obstacles around the robot. Without new percepts they are moved by the odometry
  /// and forgotten with age. The distance sensor counts only with a valid camera matrix, free
  /// ground also without one.
  void update(const ObstaclesPercept& percept, const PsdPercept& psd,
              const LandmarksPercept& landmarks, const BallModel& ball, const CameraMatrix& camera,
              const OdometryData& odometry, const FrameInfo& frame, ObstaclesModel& model,
              Debug& debug);

 private:
  void move(const Pose2D& step, Time now);
  void seeImage(const ObstaclesPercept& percept, const BallModel& ball, const CameraMatrix& camera);
  FreeGround surelyFree(const FreeGround& line, const CameraMatrix& camera) const;
  void seePsd(const PsdPercept& psd, const CameraMatrix& camera);
  void clear(const Vector2d& from, const Vector2d& to);
  void seeGoal(const GoalPercept& percept, const LandmarksPercept& landmarks);
  void draw(const CameraMatrix& camera, Debug& debug) const;

  ObstaclesModel model_;
  Vector2d psdHit_ = Vector2d::Zero();  ///< Of the last reading, mm, relative to the robot.
  bool first_ = true;
  OdometryData lastOdometry_;
  std::vector<FreeGround> sure_;  ///< Surely free ground in the last image.
  Time lastPicture_ = never(), lastPsd_ = never(), lastLandmarks_ = never();
};

}  // namespace gt
