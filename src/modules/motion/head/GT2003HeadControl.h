#pragma once
#include <optional>

#include "framework/Module.h"
#include "modules/kinematics/HeadKinematics.h"
#include "modules/motion/head/HeadPathPlanner.h"
#include "representations/behavior/HeadControlMode.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotCalibration.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallModel.h"
#include "representations/motion/HeadMotionRequest.h"

namespace gt {

/// Solution *GT2003* of HeadControl: a state machine that carries out the head control modes
/// (report 3.9.3). Only balls that the robot itself has seen are looked at.
class GT2003HeadControl {
 public:
  struct Parameters {
    int ballSeenBeforeScan = 300;
    int scanTime = 880;
    double scanWidth = 0.75;
    double rollingSpeed = 250;
    double rollingNear = 1500;
    int ballLostAfter = 400;
    int ballSearchTime = 3000;
    double searchNear = 500;
    int nearSearchTime = 2300;
    int landmarkSearchTime = 4000;
    double horizonTilt = -0.05;
    double aheadTilt = -0.2;
    double scanSpeed = 2;
    double forcedTolerance = 0.05;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::ballSeenBeforeScan>(
              Unit::ms, "search-auto: time for which the ball is seen before a scan", {0, 5000}),
          field<&P::scanTime>(Unit::ms, "search-auto: time of a scan away from the ball and back",
                              {100, 880}),
          field<&P::scanWidth>(Unit::rad, "search-auto: width of a scan to one side of the ball",
                               {0.1, 2}),
          field<&P::rollingSpeed>(
              Unit::mmPerS,
              "search-auto: speed above which a near rolling ball is watched without scans",
              {0, 5000}),
          field<&P::rollingNear>(
              Unit::mm, "search-auto: distance below which a rolling ball is watched without scans",
              {0, 10000}),
          field<&P::ballLostAfter>(Unit::ms,
                                   "time after which a ball that is looked at and not seen is lost",
                                   {100, 5000}),
          field<&P::ballSearchTime>(Unit::ms, "time of one round of searching the ball",
                                    {1000, 10000}),
          field<&P::searchNear>(
              Unit::mm,
              "distance of the last seen ball below which it is searched near the robot first, "
              "then in every other round",
              {0, 10000}),
          field<&P::nearSearchTime>(
              Unit::ms, "time of one round of searching the ball near the robot", {1000, 10000}),
          field<&P::landmarkSearchTime>(Unit::ms, "time of one round of looking for landmarks",
                                        {1000, 10000}),
          field<&P::horizonTilt>(Unit::rad,
                                 "tilt of the camera over ground when landmarks are looked for",
                                 {-0.5, 0.5}),
          field<&P::aheadTilt>(
              Unit::rad,
              "tilt of the camera when it looks straight ahead: balls farther away than 300 mm are "
              "seen",
              {-1, 0.5}),
          field<&P::scanSpeed>(Unit::radPerS, "scan-left-right: speed of the pan joint", {0.1, 3}),
          field<&P::forcedTolerance>(
              Unit::rad, "stay-as-forced: by how much a joint must be turned to stay there",
              {0, 0.5})};
    }
  };
  Parameters parameters;

  virtual ~GT2003HeadControl() = default;

  /// Provides the target angles of the head (rad). Its present angles are the newest sensor
  /// readings, whatever their age. A ball that was never seen is searched for.
  void update(const HeadControlMode& mode, const BallModel& ball, const SensorDataBuffer& sensors,
              const RobotDimensions& robot, const RobotCalibration& calibration,
              const FrameInfo& frame, HeadMotionRequest& request);

 protected:
  static constexpr double widestPan = 1.45;  ///< Greatest pan of scans to each side, rad.
  /// Speed of the tilt joint in scans (rad/s), which weaker servos can follow, too.
  static constexpr double tiltSpeed = 1.6;

  /// Inputs of the states in a frame. The body's pose (mm) is relative to the robot, angles are in
  /// rad.
  struct Situation {
    const BallModel& ball;
    Time now;
    Pose3D body;
    double bodyTilt;
    HeadAngles ballAngles;
    HeadAngles measured;
  };
  /// A scan of search-auto: away from the ball and back.
  struct Glance {
    double pan;       ///< Pan at which it turns back, rad.
    double duration;  ///< ms
  };

  /// Decides how to look away from a ball that was watched for long enough; empty to continue to
  /// watch it. This implementation scans to both sides in turn (report 3.9.3.1). Has a side effect.
  virtual std::optional<Glance> chooseGlance(const Situation& situation);

 private:
  enum class State {
    idle,
    lookAtBall,
    scanBesideBall,
    searchForBall,
    searchForLandmarks,
    scanLeftRight
  };

  HeadAngles lookForBall(const Situation& situation, bool scanBesides);
  HeadAngles searchForBall(const Situation& situation);
  HeadAngles searchForLandmarks(const Situation& situation);
  HeadAngles scanLeftRight(const HeadControlMode& mode, const Situation& situation);
  void stayAsForced(const JointAngles& measured, HeadMotionRequest& request) const;
  HeadAngles lookAtBall(const Situation& situation, bool scanBesides);
  void enter(State, Time now);
  void planScanBesideBall(const Situation& situation, const Glance& glance);
  void planBallSearch(const Situation& situation);
  void planLandmarkSearch(const Situation& situation);
  bool ballSeen(const Situation& situation) const;

  State state_ = State::idle;
  Time entered_;
  bool scanLeft_ = true;       ///< Whether the next scan is to the left.
  bool searchesNear_ = false;  ///< Whether this round searches the ball near the robot.
  HeadAngles head_;
  HeadPathPlanner path_;
  double scanTilt_ = 0, scanRange_ = 0;  ///< Parameters of the planned path from left to right.
};

}  // namespace gt
