#pragma once
#include "framework/Module.h"
#include "modules/motion/Tasks.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

/// Solution *Default* of MotionControl: forwards the output of the module of the present motion,
/// and changes to the requested one as soon as that module may be left (report 3.9). Standing is
/// walking with speed 0. The angles of all joints are limited, and the speeds of the head's joints
/// and, after a change of the motion, of the legs' joints (report 3.9.3.4).
class DefaultMotionControl {
 public:
  struct Parameters {
    double headTiltSpeed = 2.1, headPanSpeed = 3.0, headRollSpeed = 3.0;
    double actionSpeed = 6;
    double changeSpeed = 2.5;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::headTiltSpeed>(Unit::radPerS, "greatest speed of the head's tilt", {0.1, 10}),
          field<&P::headPanSpeed>(Unit::radPerS, "greatest speed of the head's pan", {0.1, 10}),
          field<&P::headRollSpeed>(Unit::radPerS, "greatest speed of the head's roll", {0.1, 10}),
          field<&P::actionSpeed>(
              Unit::radPerS,
              "greatest speed of the head's joints in special actions, such as kicks by the head",
              {0.1, 10}),
          field<&P::changeSpeed>(
              Unit::radPerS,
              "greatest speed of a leg's joint until a new motion's angles are reached",
              {0.1, 10})};
    }
  };
  Parameters parameters;

  /// Provides the joints' angles and gains, the odometry, and the executed motion. A request that
  /// is too old is replaced by standing. The first update resumes from the angles and the odometry
  /// that another solution has provided.
  void update(const FrameInfo& frame, const MotionRequest& request,
              const WalkingEngineOutput& walking, const SpecialActionsOutput& special,
              const GetupEngineOutput& getup, const HeadMotionRequest& head, JointData& joints,
              JointGains& gains, OdometryData& odometry, MotionInfo& info);

 private:
  /// The module that moves the legs.
  enum class Mover { walkingEngine, specialActions, getupEngine };

  static Mover moverFor(const MotionRequest& wanted);
  /// Changes to another mover as soon as the present one may be left.
  void choose(Mover wanted, bool mayLeave);
  /// Moves the angles as near to the target as the limits of the joints' speeds allow.
  void protect(const JointAngles& target);
  void report(const MotionRequest& wanted, const WalkingEngineOutput& walking,
              const SpecialActionsOutput& special, const GetupEngineOutput& getup,
              MotionInfo& info) const;

  Mover mover_ = Mover::walkingEngine;
  bool changing_ = true;  ///< Whether the legs are still on their way to the angles of the walk.
  int settling_ = 12;     ///< Frames of rest after the legs have first arrived after switching on.
  bool begun_ = false;
  JointAngles angles_;
  Pose2D odometry_;
};

}  // namespace gt
