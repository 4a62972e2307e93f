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

/// Solution *Gravity* of GetupEngine: brings the robot to a stand from everywhere (report 3.9).
/// Where the acceleration points says how it lies, and by that which special action of the motion
/// net is performed; so it goes on, action after action, until one has ended upright: each of them
/// ends with the stand. A robot that is upright at first may lie on its belly or sit.
class GravityGetupEngine {
 public:
  struct Parameters {
    double upright = 0.45;
    double average = 0.1;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::upright>(Unit::rad, "a body that leans by less stands", {0.05, 1.5}),
          field<&P::average>(Unit::s, "over which the acceleration is averaged", {0.008, 1})};
    }
  };
  Parameters parameters;

  /// Provides the joints of the action that gets the robot up, all "don't care" while it does
  /// something else or stands.
  void update(const FrameInfo& frame, const SensorDataBuffer& sensors, const MotionNet& net,
              Previous<MotionInfo> motion, Previous<JointData> joints, GetupEngineOutput& output,
              Debug& debug);

 private:
  /// The action for a robot that lies so that this direction points up.
  std::string_view actionFor(const Vector3d& up) const;

  Vector3d acceleration_ = Vector3d::Zero();  ///< Averaged, mm/s^2.
  GT2003MotionNetSpecialActions actions_;
  SpecialActionsOutput performed_;
  bool active_ = false;
};

}  // namespace gt
