#pragma once
#include "framework/Module.h"
#include "modules/motion/Tasks.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/JointDataSequence.h"

namespace gt {

/// Solution *Debug* of MotionControl: ignores all motion requests and executes sequences of joint
/// data that a person sends (report J.5.4). Otherwise each joint keeps its angle until somebody
/// turns it by hand, and then stays at the new angle ("stay as forced").
class DebugMotionControl {
 public:
  struct Parameters {
    double tolerance = 0.1;
    double settling = 0.4;

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::tolerance>(
              Unit::rad,
              "difference from the target angle above which a joint is turned by hand; legs give "
              "way by up to 0.05 under the robot's weight",
              {0.01, 1}),
          field<&Parameters::settling>(
              Unit::s,
              "time in which joints reach their angles after a sequence, during which turning by "
              "hand is not detected",
              {0, 5})};
    }
  };
  Parameters parameters;

  /// Provides the joints' angles, with the recommended gains; the odometry does not change. Each
  /// sequence is executed once, also one that arrived together with the switch to this solution.
  void update(const SensorDataBuffer& sensors, const JointDataSequence& sequence, JointData& joints,
              JointGains& gains, OdometryData& odometry, MotionInfo& info);

 private:
  void play(const JointDataSequence& sequence);
  void stayAsForced(const JointAngles& measured);

  bool begun_ = false;
  int number_ = 0;        ///< Number of the last sequence.
  bool playing_ = false;  ///< Whether a sequence is being executed.
  std::size_t line_ = 0;
  int frame_ = 0;        ///< Frame within the line.
  JointAngles from_;     ///< Angles at the beginning of the line.
  double settling_ = 0;  ///< Remaining time in which joints reach their angles, in s.
  JointAngles angles_;
};

}  // namespace gt
