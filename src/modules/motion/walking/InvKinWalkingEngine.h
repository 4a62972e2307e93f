#pragma once
#include <array>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "framework/Module.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/RobotDimensions.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/WalkingEngineOutput.h"

namespace gt {

/// How a foot moves while it is in the air (report, figure 3.20).
enum class FootMode { rectangle, halfEllipse };

/// The walk as parameters, with the names of report 3.9.1.2. Left out are what a trot makes
/// ineffective (the body shift), the foot modes hardly used, and the head's angles.
struct WalkParameters {
  FootMode footMode = FootMode::halfEllipse;
  double foreHeight = 105, foreWidth = 82, foreCenterX = 15;
  double hindHeight = 110, hindWidth = 82, hindCenterX = -15;
  double foreFootTilt = 0.03, hindFootTilt = 0.03;
  double foreFootLift = 15, hindFootLift = 15;
  double legSpeedFactorX = 1, legSpeedFactorY = 1, legSpeedFactorR = 1;
  double maxStepSizeX = 36, maxStepSizeY = 27;
  double maxSpeedXChange = 500, maxSpeedYChange = 400, maxRotationChange = 5;
  double counterRotation = 0;
  int stepLen = 80;
  double foreGroundPhase = 0.5, hindGroundPhase = 0.5;
  double foreLiftPhase = 0.12, hindLiftPhase = 0.12;
  double foreLoweringPhase = 0.12, hindLoweringPhase = 0.12;
  EnumArray<Leg, double> legPhase{{0.5, 0, 0, 0.5}};
  double correctionX = 1, correctionY = 1, correctionR = 1;

  static constexpr auto fields() {
    using P = WalkParameters;
    return Fields{
        field("footMode", &P::footMode, "", "path of a foot in the air"),
        field("foreHeight", &P::foreHeight, "mm", "height of the shoulder above the foot ball",
              {50, 130}),
        field("foreWidth", &P::foreWidth, "mm", "distance of the foot from the body's middle",
              {40, 150}),
        field("foreCenterX", &P::foreCenterX, "mm", "distance of the foot before the shoulder",
              {-80, 100}),
        field("hindHeight", &P::hindHeight, "mm", "height of the shoulder above the foot ball",
              {50, 140}),
        field("hindWidth", &P::hindWidth, "mm", "distance of the foot from the body's middle",
              {40, 150}),
        field("hindCenterX", &P::hindCenterX, "mm", "distance of the foot before the shoulder",
              {-100, 80}),
        field("foreFootTilt", &P::foreFootTilt, "rad", "tilt of the foot's path, + front up",
              {-0.5, 0.5}),
        field("hindFootTilt", &P::hindFootTilt, "rad", "tilt of the foot's path, + front up",
              {-0.5, 0.5}),
        field("foreFootLift", &P::foreFootLift, "mm", "height of the foot's path", {0, 60}),
        field("hindFootLift", &P::hindFootLift, "mm", "height of the foot's path", {0, 60}),
        field("legSpeedFactorX", &P::legSpeedFactorX, "",
              "speed of the hind feet, as a share of the fore feet's", {0.1, 3}),
        field("legSpeedFactorY", &P::legSpeedFactorY, "",
              "speed of the hind feet, as a share of the fore feet's", {0.1, 3}),
        field("legSpeedFactorR", &P::legSpeedFactorR, "",
              "speed of the hind feet, as a share of the fore feet's", {0.1, 3}),
        field("maxStepSizeX", &P::maxStepSizeX, "mm", "greatest distance of a foot from its center",
              {1, 80}),
        field("maxStepSizeY", &P::maxStepSizeY, "mm", "greatest distance of a foot from its center",
              {1, 80}),
        field("maxSpeedXChange", &P::maxSpeedXChange, "mm/s^2", "greatest acceleration", {1, 1e5}),
        field("maxSpeedYChange", &P::maxSpeedYChange, "mm/s^2", "greatest acceleration", {1, 1e5}),
        field("maxRotationChange", &P::maxRotationChange, "rad/s^2", "greatest acceleration",
              {0.01, 1e3}),
        field("counterRotation", &P::counterRotation, "rad/mm",
              "turn for each mm walked sideways, against the turn that slipping makes",
              {-0.01, 0.01}),
        field("stepLen", &P::stepLen, "frames", "length of one step cycle, in frames of 8 ms",
              {8, 400}),
        field("foreGroundPhase", &P::foreGroundPhase, "", "share of the cycle on the ground",
              {0.2, 0.9}),
        field("hindGroundPhase", &P::hindGroundPhase, "", "share of the cycle on the ground",
              {0.2, 0.9}),
        field("foreLiftPhase", &P::foreLiftPhase, "", "share of the cycle for lifting",
              {0.001, 0.4}),
        field("hindLiftPhase", &P::hindLiftPhase, "", "share of the cycle for lifting",
              {0.001, 0.4}),
        field("foreLoweringPhase", &P::foreLoweringPhase, "", "share of the cycle for lowering",
              {0.001, 0.4}),
        field("hindLoweringPhase", &P::hindLoweringPhase, "", "share of the cycle for lowering",
              {0.001, 0.4}),
        field("legPhase", &P::legPhase, "", "share of the cycle after which the foot is lifted",
              {0, 1}),
        field("correctionX", &P::correctionX, "",
              "measured speed, as a share of that of the feet (3.9.1.3)", {0.2, 5}),
        field("correctionY", &P::correctionY, "", "measured speed, as a share of that of the feet",
              {0.2, 5}),
        field("correctionR", &P::correctionR, "", "measured speed, as a share of that of the feet",
              {0.2, 5})};
  }
};

/// Solution *InvKin* of WalkingEngine: moves the feet like wheels around their centers, on the
/// ground against the body's motion, in the air back again, and finds the joints by inverse
/// kinematics (report 3.9.1). With speed 0 it stands.
class InvKinWalkingEngine {
 public:
  using Parameters = WalkParameters;
  Parameters parameters;

  /// Provides the legs' angles and the step that they make; those of standing while another module
  /// moves the robot, or if the request is too old.
  void update(const FrameInfo& frame, const MotionRequest& request, const RobotDimensions& robot,
              Previous<MotionInfo> motion, WalkingEngineOutput& output);

 private:
  struct Foot {
    Vector2d center = Vector2d::Zero(), position = Vector2d::Zero(), liftedAt = Vector2d::Zero();
    double lift = 0;
    bool inAir = false;
  };

  void reset(const RobotDimensions& robot);
  void accelerate(const Pose2D& target);
  void moveFoot(Leg);
  bool standing() const;
  /// The speed of the feet for a request, clipped to what the steps allow.
  Pose2D allowed(const Pose2D& request) const;
  /// The speed of the robot that the feet's speed yields (report 3.9.1.3).
  Pose2D measured(const Pose2D& ofFeet) const;
  Pose2D speedOf(Leg, const Pose2D& speed) const;
  double timeOnGround(Leg) const;
  double phaseOf(Leg) const;
  Vector3d target(const RobotDimensions& robot, Leg leg) const;
  Foot& footOf(Leg leg) { return feet_[static_cast<std::size_t>(leg)]; }
  const Foot& footOf(Leg leg) const { return feet_[static_cast<std::size_t>(leg)]; }

  std::array<Foot, 4> feet_;
  Pose2D speed_;    ///< Of the feet, before the correction.
  int frame_ = -1;  ///< In the step cycle; -1 before the first.
};

}  // namespace gt
