#pragma once
#include <string>
#include <string_view>

#include "debug/Debug.h"
#include "framework/Module.h"
#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/GetupEngineOutput.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/MotionNet.h"

namespace gt {

/// Solution *Gravity* of GetupEngine: lets the robot stand up from any posture (report 3.9). The
/// direction of the acceleration determines how the robot lies and which special action of the
/// motion net is performed. Actions are repeated until one has ended upright; each of them ends
/// with standing. A robot that is upright at first may lie on its belly or sit, so at least one
/// action is performed.
class GravityGetupEngine {
 public:
  struct Parameters {
    double upright = 0.45;
    double average = 0.1;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::upright>(Unit::rad, "inclination of the body below which it is upright",
                             {0.05, 1.5}),
          field<&P::average>(Unit::s, "time constant of averaging the acceleration", {0.008, 1})};
    }
  };
  Parameters parameters;

  /// Provides the joint angles of the action that gets the robot up; all are "don't care" during
  /// other motions and while it stands.
  void update(const FrameInfo& frame, const SensorDataBuffer& sensors, const MotionNet& net,
              Previous<MotionInfo> motion, Previous<JointData> joints, GetupEngineOutput& output,
              Debug& debug);

 private:
  /// The action for a lying robot; `up` is the direction of up in the body's axes.
  std::string_view actionFor(const Vector3d& up) const;

  Vector3d acceleration_ = Vector3d::Zero();  ///< Averaged, mm/s^2.
  GT2003MotionNetSpecialActions actions_;
  SpecialActionsOutput performed_;
  bool active_ = false;
};

}  // namespace gt
