#pragma once
#include <array>

#include "modules/motion/head/GT2003HeadControl.h"
#include "modules/motion/head/PoseUncertainty.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/modeling/PlayersCollection.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Solution *ActiveVision* of HeadControl, beyond the report: all head control modes are those of
/// GT2003, except that search-auto looks away from the ball in the direction with the greatest
/// expected gain of information per time. The gain is measured in nats: information on the pose
/// from landmarks on the path (PoseUncertainty), on known opponents, and on unknown ones in
/// directions in which the robot has not looked for long. Its cost is the growing uncertainty of
/// the ball's position. Without any gain the head continues to look at the ball.
class ActiveVisionHeadControl : private GT2003HeadControl {
 public:
  struct Parameters {
    GT2003HeadControl::Parameters modes;
    PoseUncertainty::Parameters pose;
    double landmarkWeight = 1;
    double opponentWeight = 1;
    double ballWeight = 0.5;
    double glanceSpeed = 2;
    double opponentSpeed = 200;
    double ballSpeed = 200;
    double unseenAfter = 5;
    double leastValidity = 0.1;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::modes>(),
          field<&P::pose>(),
          field<&P::landmarkWeight>("weight of information on the pose", {0, 100}),
          field<&P::opponentWeight>("weight of information on opponents", {0, 100}),
          field<&P::ballWeight>("weight of information on the ball", {0, 100}),
          field<&P::glanceSpeed>(Unit::radPerS, "speed of the head off the ball and back",
                                 {0.5, 3}),
          field<&P::opponentSpeed>(
              Unit::mmPerS, "growth of the uncertainty of an opponent that is not seen", {1, 1000}),
          field<&P::ballSpeed>(Unit::mmPerS,
                               "growth of the uncertainty of a resting ball that is not seen",
                               {1, 3000}),
          field<&P::unseenAfter>(
              Unit::s,
              "time constant after which unknown opponents may be in a direction that is not "
              "looked at",
              {0.5, 60}),
          field<&P::leastValidity>(
              "validity of the pose below which the robot scans both sides in turn, as GT2003 does",
              {0, 1})};
    }
  };
  Parameters parameters;

  /// Provides the target angles of the head (rad), as GT2003HeadControl does.
  void update(const HeadControlMode& mode, const BallModel& ball, const RobotPose& pose,
              const PlayersCollection& players, const SensorDataBuffer& sensors,
              const RobotDimensions& robot, const RobotCalibration& calibration,
              const FieldDimensions& field, const FrameInfo& frame, HeadMotionRequest& request);

 private:
  static constexpr std::size_t sectors = 36;

  /// Directions from left to right, relative to the robot (rad).
  struct Sweep {
    double right, left;

    bool contains(double angle) const { return angle > right && angle < left; }
  };

  std::optional<Glance> chooseGlance(const Situation& situation) override;
  void remember(const SensorData& sensors, double bodyTilt, Time now);
  double worth(const Sweep& sweep, Time now) const;
  double landmarkGain(const Sweep& sweep) const;
  double opponentGain(const Sweep& sweep, Time now) const;
  double ballLoss(const BallModel& ball, double seconds) const;
  double directionOf(const Vector2d& onField) const { return angleOf(relative(robot_, onField)); }

  Pose2D robot_;
  double validity_ = 0;
  const PlayersCollection* players_ = nullptr;  ///< During an update.
  std::array<Vector2d, 10> landmarks_;          ///< Flags and goal posts, mm, on the field.
  PoseUncertainty pose_;
  /// Time at which each direction on the field was last in an image.
  std::array<Time, sectors> looked_;
  Time remembered_ = never();
};

}  // namespace gt
