#pragma once
#include "framework/Module.h"
#include "modules/motion/Tasks.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

/// Solution *Default* of MotionControl: passes on what the module of the present motion does, and
/// changes to the one requested as soon as that module may be left (report 3.9). To stand is to
/// walk with speed 0. All joints are kept within their limits, the head's and those of a motion
/// just begun within a speed (report 3.9.3.4).
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
          field<&P::changeSpeed>(Unit::radPerS,
                                 "greatest speed of a leg until a new motion's angles are reached",
                                 {0.1, 10})};
    }
  };
  Parameters parameters;

  /// Provides the joints' angles and gains, the odometry, and what is being done. A request that is
  /// too old is one to stand. At first it resumes from the angles and the odometry that another
  /// solution has provided.
  void update(const FrameInfo& frame, const MotionRequest& request,
              const WalkingEngineOutput& walking, const SpecialActionsOutput& special,
              const GetupEngineOutput& getup, const HeadMotionRequest& head, JointData& joints,
              JointGains& gains, OdometryData& odometry, MotionInfo& info);

 private:
  /// Who moves the legs.
  enum class Mover { walkingEngine, specialActions, getupEngine };

  static Mover moverFor(const MotionRequest& wanted);
  /// Lets another one move the robot as soon as the present one may be left.
  void choose(Mover wanted, bool mayLeave);
  /// Brings the angles as near to the target as the joints' speeds allow.
  void protect(const JointAngles& target);
  void report(const MotionRequest& wanted, const WalkingEngineOutput& walking,
              const SpecialActionsOutput& special, const GetupEngineOutput& getup,
              MotionInfo& info) const;

  Mover mover_ = Mover::walkingEngine;
  bool changing_ = true;  ///< The legs are still on their way to where the walk has them.
  int settling_ = 12;     ///< Frames for which it then rests, once it was switched on.
  bool begun_ = false;
  JointAngles angles_;
  Pose2D odometry_;
};

}  // namespace gt
