#pragma once
#include <array>

#include "base/Geometry.h"
#include "framework/Module.h"
#include "modules/motion/walking/Balance.h"
#include "modules/motion/walking/FootPath.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/WalkingEngineOutput.h"

namespace gt {

/// Solution *InvKin* of WalkingEngine: moves the feet like wheels around their centers, on the
/// ground against the body's motion, in the air back again, and computes the joint angles by
/// inverse kinematics (report 3.9.1). With speed 0 the robot stands. Each walk type has parameters
/// of its own; a new type begins when all feet are on the ground.
class InvKinWalkingEngine {
 public:
  using Parameters = WalkTypes;
  Parameters parameters;

  /// Provides the legs' angles (rad) and the odometry step; those of standing while another module
  /// moves the robot, or if the request is too old.
  void update(const FrameInfo& frame, const MotionRequest& request, const RobotDimensions& robot,
              const SensorDataBuffer& sensors, Previous<MotionInfo> motion,
              WalkingEngineOutput& output);

 private:
  struct Foot {
    Vector2d center = Vector2d::Zero(), position = Vector2d::Zero(), liftedAt = Vector2d::Zero();
    Vector3d offset = Vector3d::Zero();  ///< Offset from `position` by the path of the foot, mm.
    bool inAir = false;
    bool rests = true;  ///< Whether it was not lifted since the robot stood still.
    double raised = 0;  ///< Height added after it has met an obstacle, mm.
  };

  /// Heights and tilts of the stance, which change slowly after a change of the walk type.
  struct Stance {
    double foreHeight = 0, hindHeight = 0;  ///< mm
    double foreTilt = 0, hindTilt = 0;      ///< Tilts of the feet's paths, rad.
  };

  const WalkParameters& walk() const { return parameters[type_]; }
  void reset(const RobotDimensions& robot);
  void change(WalkType type, const RobotDimensions& robot);
  void setCenters(const RobotDimensions& robot);
  Stance wantedStance() const;
  void adjustStance();
  bool allOnGround() const;
  bool flies() const;
  void rest();
  void accelerate(const Pose2D& target);
  /// Reacts to pushes and obstacles that the sensors show.
  void balance(const SensorData& measured, const JointAngles& asked);
  void moveFoot(Leg);
  void shiftBody();
  bool standing() const;
  /// The speed of the feet (mm/s, rad/s) for a requested speed of the robot, limited by the size of
  /// the steps.
  Pose2D allowed(const Pose2D& request) const;
  /// The speed of the robot (mm/s, rad/s) that results from the speed of the feet (report 3.9.1.3).
  Pose2D measured(const Pose2D& ofFeet) const;
  Pose2D speedOf(Leg, const Pose2D& speed) const;
  /// The time in which a foot on the ground moves by one unit of its path (s).
  double unitTime(const FootPath& path) const;
  double phaseOf(Leg) const;
  static bool isCentered(const Foot& foot);
  static Vector3d offset(Leg leg, const FootPath::Point& point);
  Vector3d target(const RobotDimensions& robot, Leg leg) const;
  Foot& footOf(Leg leg) { return feet_[static_cast<std::size_t>(leg)]; }
  const Foot& footOf(Leg leg) const { return feet_[static_cast<std::size_t>(leg)]; }

  WalkType type_ = WalkType::normal;
  Stance stance_;
  std::array<Foot, 4> feet_;
  Pose2D speed_;  ///< Speed of the feet, before the correction.
  Balance balance_;
  /// Speed of the feet, with the speed by which they yield to a push.
  Pose2D moving_;
  Vector2d placement_ = Vector2d::Zero();  ///< Shift of the landing feet after a push, mm.
  Vector2d bodyShift_ = Vector2d::Zero();  ///< Shift of the body, mm.
  double swing_ = 0;                       ///< Factor to the body's shift; 0 while standing.
  int frame_ = -1;                         ///< In the step cycle; -1 before the first.
};

}  // namespace gt
