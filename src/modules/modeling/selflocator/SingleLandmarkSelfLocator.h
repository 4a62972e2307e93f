#pragma once
#include "base/Time.h"
#include "debug/Debug.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/modeling/RobotPose.h"
#include "representations/motion/OdometryData.h"
#include "representations/perception/LandmarksPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Solution *SingleLandmark* of SelfLocator: estimates the robot's pose by moving it towards the
/// measured distance and direction of each single landmark (report 3.3.1). The method is cheap, but
/// never exact.
class SingleLandmarkSelfLocator {
 public:
  struct Parameters {
    double progressiveness = 0.15;
    double minimumQuality = 0.1;
    double distanceRange = 1500;
    double flagAngleQuality = 0.6;
    double goalDistanceQuality = 0.05;
    double goalAngleQuality = 0.9;
    double positionTolerance = 500;
    double angleTolerance = 0.35;
    double lossByTime = 0.05;
    double lossByDistance = 0.0004;
    double lossByAngle = 0.1;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::progressiveness>(
              "share of a correction that is applied; 0: none, 1: the pose follows each "
              "measurement",
              {0, 1}),
          field<&P::minimumQuality>("least quality of a landmark that is used", {0, 1}),
          field<&P::distanceRange>(
              Unit::mm, "distance of a flag at which the quality of the distance is a half",
              {100, 10000}),
          field<&P::flagAngleQuality>("quality of the direction of a flag that is seen completely",
                                      {0, 1}),
          field<&P::goalDistanceQuality>("quality of a goal's distance", {0, 1}),
          field<&P::goalAngleQuality>("quality of the direction of a goal that is seen completely",
                                      {0, 1}),
          field<&P::positionTolerance>(
              Unit::mm, "correction of the position at which its reliability becomes 0",
              {1, 10000}),
          field<&P::angleTolerance>(
              Unit::rad, "correction of the orientation at which its reliability becomes 0",
              {0.01, 3}),
          field<&P::lossByTime>(Unit::perS, "share of the reliability that is lost in a second",
                                {0, 10}),
          field<&P::lossByDistance>(
              Unit::perMm, "share of the reliability of the position lost for each mm walked",
              {0, 1}),
          field<&P::lossByAngle>(
              Unit::perRad, "share of the reliability of the orientation lost for each rad turned",
              {0, 10})};
    }
  };
  Parameters parameters;

  /// Provides the robot's pose on the field and its validity. Without a new percept the pose is
  /// moved by the odometry and becomes less reliable. Whether the camera matrix was valid is not
  /// checked.
  void update(const LandmarksPercept& percept, const OdometryData& odometry,
              const FieldDimensions& field, const Player& player, RobotPose& robotPose,
              Debug& debug);

 private:
  /// The measurement of one landmark (mm, on the field): distance (mm) and angle (rad) relative to
  /// the robot, each with its quality.
  struct Measurement {
    Vector2d landmark = Vector2d::Zero();
    double distance = 0, distanceQuality = 0;
    double angle = 0, angleQuality = 0;
  };

  void move(const OdometryData& odometry, Time now);
  Measurement flagIn(const FlagPercept& flag, TeamColor team, const FieldDimensions& field) const;
  void useBestFlags(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field);
  void useGoals(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field);
  void correct(const Measurement& measurement);
  void correctPosition(const Measurement& measurement);
  void correctOrientation(const Measurement& measurement);

  Pose2D pose_;
  double positionReliability_ = 0, orientationReliability_ = 0;
  OdometryData lastOdometry_;
  Time lastPicture_ = never();
  bool started_ = false;
};

}  // namespace gt
