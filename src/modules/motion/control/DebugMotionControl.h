#pragma once
#include "framework/Module.h"
#include "modules/motion/Tasks.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/JointDataSequence.h"

namespace gt {

/// Solution *Debug* of MotionControl: ignores all motion requests and executes sequences of joint
/// data that a person sends (report J.5.4). Otherwise the robot stays as forced: each joint keeps
/// its angle until somebody turns it by hand, and stays there then.
class DebugMotionControl {
 public:
  struct Parameters {
    double tolerance = 0.1;
    double settling = 0.4;

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::tolerance>(
              Unit::rad,
              "a joint that is farther from where it shall be is turned by hand; legs give way "
              "by up to 0.05 under the robot's weight",
              {0.01, 1}),
          field<&Parameters::settling>(
              Unit::s,
              "time in which joints arrive after a sequence: meanwhile nobody turns them by hand",
              {0, 5})};
    }
  };
  Parameters parameters;

  /// Provides the joints' angles, with the gains as recommended; the odometry stays as it was. Each
  /// sequence is executed once, also one that came together with the switch to this solution.
  void update(const SensorDataBuffer& sensors, const JointDataSequence& sequence, JointData& joints,
              JointGains& gains, OdometryData& odometry, MotionInfo& info);

 private:
  void play(const JointDataSequence& sequence);
  void stayAsForced(const JointAngles& measured);

  bool begun_ = false;
  int number_ = 0;        ///< Of the last sequence.
  bool playing_ = false;  ///< It is being executed.
  std::size_t line_ = 0;
  int frame_ = 0;        ///< Of the line.
  JointAngles from_;     ///< Where the line began.
  double settling_ = 0;  ///< For how long joints may still arrive, in s.
  JointAngles angles_;
};

}  // namespace gt
