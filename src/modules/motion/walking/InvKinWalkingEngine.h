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
/// ground against the body's motion, in the air back again, and finds the joints by inverse
/// kinematics (report 3.9.1). With speed 0 it stands. Each walk type has parameters of its own; a
/// new type begins when all feet are on the ground.
class InvKinWalkingEngine {
 public:
  using Parameters = WalkTypes;
  Parameters parameters;

  /// Provides the legs' angles and the step that they make; those of standing while another module
  /// moves the robot, or if the request is too old.
  void update(const FrameInfo& frame, const MotionRequest& request, const RobotDimensions& robot,
              const SensorDataBuffer& sensors, Previous<MotionInfo> motion,
              WalkingEngineOutput& output);

 private:
  struct Foot {
    Vector2d center = Vector2d::Zero(), position = Vector2d::Zero(), liftedAt = Vector2d::Zero();
    Vector3d offset = Vector3d::Zero();  ///< By the path, beside its position.
    bool inAir = false;
    bool rests = true;  ///< Since it stood still it was not lifted.
    double raised = 0;  ///< By how much it is higher (mm), since it has met something.
  };

  /// How the body stands on its feet: it changes slowly with the walk type.
  struct Stance {
    double foreHeight = 0, hindHeight = 0;  ///< mm
    double foreTilt = 0, hindTilt = 0;      ///< rad, of the feet's paths
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
  /// Takes what the walk did not expect.
  void balance(const SensorData& measured, const JointAngles& asked);
  void moveFoot(Leg);
  void shiftBody();
  bool standing() const;
  /// The speed of the feet for a request, clipped to what the steps allow.
  Pose2D allowed(const Pose2D& request) const;
  /// The speed of the robot that the feet's speed yields (report 3.9.1.3).
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
  Pose2D speed_;  ///< Of the feet, before the correction.
  Balance balance_;
  Pose2D moving_;                          ///< The same, and what they yield to a push.
  Vector2d placement_ = Vector2d::Zero();  ///< By which feet land farther after a push (mm).
  Vector2d bodyShift_ = Vector2d::Zero();  ///< mm
  double swing_ = 0;                       ///< Share of the body's shift: 0 in the stand.
  int frame_ = -1;                         ///< In the step cycle; -1 before the first.
};

}  // namespace gt
