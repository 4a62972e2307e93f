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
              "the distance sensor's obstacle counts if the reading before was no farther off: "
              "reflections are not; 0: every reading counts",
              {0, 10000}),
          field<&P::forgetAfter>(Unit::ms,
                                 "time after which a sector that is not seen again is forgotten",
                                 {100, 100000}),
          field<&P::caution>(
              Unit::rad,
              "angle by which what stands at the end of free ground may be seen too high",
              {0, 0.2}),
          field<&P::ballSize>(
              Unit::mm,
              "distance from the ball within which the end of free ground is the ball, no obstacle",
              {0, 1000}),
          field<&P::ballTime>(Unit::ms, "time since the ball was seen for which that holds",
                              {0, 10000}),
          field<&P::lowestObstacle>(
              Unit::mm,
              "height of the lowest obstacle, which the distance sensor must not look over",
              {1, 1000}),
          field<&P::highestObstacle>(
              Unit::mm, "height above which what the distance sensor hits is no obstacle",
              {1, 10000})};
    }
  };
  Parameters parameters;

  /// Provides the obstacles around the robot. Without new percepts they move with the odometry and
  /// are forgotten with age. The distance sensor counts with a valid camera matrix only, free
  /// ground also without.
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
  Vector2d psdHit_ = Vector2d::Zero();  ///< Of the last reading, relative to the robot.
  bool first_ = true;
  OdometryData lastOdometry_;
  std::vector<FreeGround> sure_;  ///< Of the last image.
  Time lastPicture_ = never(), lastPsd_ = never(), lastLandmarks_ = never();
};

}  // namespace gt
