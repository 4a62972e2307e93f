#pragma once
#include <array>

#include "debug/Debug.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionInfo.h"
#include "representations/perception/CollisionPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// Kinds of walks in which the legs lag differently behind their commands.
enum class Gait { standing, forward, backward, sideways, turning };

/// Solution *Report* of CollisionDetector: compares the commanded with the measured angles of the
/// legs, since a leg that is held up lags behind (report 3.6).
class ReportCollisionDetector {
 public:
  static constexpr int window = 12;  ///< Number of squared differences that are summed.
  /// Greatest number of frames by which commands may be ahead of the sensors.
  static constexpr int mostFrames = 16;

  /// The thresholds of a gait by its speed: bands of 40 mm/s, of which the last one includes all
  /// higher speeds.
  static constexpr std::size_t speeds = 6;
  static constexpr double speedBand = 40;  ///< mm/s
  using SpeedTable = std::array<double, speeds>;

  struct Parameters {
    EnumArray<Gait, SpeedTable> thresholds{{{{0.02, 0.02, 0.02, 0.02, 0.02, 0.02},
                                             {0.03, 0.04, 0.052, 0.1, 0.145, 0.145},
                                             {0.03, 0.04, 0.052, 0.1, 0.145, 0.145},
                                             {0.017, 0.019, 0.03, 0.03, 0.03, 0.03},
                                             {0.02, 0.03, 0.039, 0.039, 0.039, 0.039}}}};
    int leastShift = 1, mostShift = 8;
    double suddenSpeed = 40;
    double suddenTurn = 0.3;
    std::int64_t settleTime = 400;
    int inARow = 3;

    static constexpr auto fields() {
      using P = Parameters;
      constexpr Range frames{0, mostFrames};
      return Fields{
          field<&P::thresholds>(
              Unit::rad2,
              "threshold of the sum of a leg's squared differences, for each gait and speed",
              {0, 1000}),
          field<&P::leastShift>(Unit::frames, "least phase shift of the sensors, in frames of 8 ms",
                                frames),
          field<&P::mostShift>(Unit::frames, "greatest phase shift of the sensors", frames),
          field<&P::suddenSpeed>(
              Unit::mmPerS,
              "change of the command within a frame that makes the legs lag by itself", {0, 10000}),
          field<&P::suddenTurn>(Unit::radPerS, "change of the turning speed that does the same",
                                {0, 100}),
          field<&P::settleTime>(Unit::ms, "time without detection after such a change", {0, 10000}),
          field<&P::inARow>(Unit::frames,
                            "number of frames above the threshold that make a collision",
                            {1, 100})};
    }
  };
  Parameters parameters;

  /// Index of a motion's threshold in the table. The speed of a turn is that of its feet.
  struct Place {
    Gait gait;
    std::size_t speed;
  };
  static Place placeOf(const MotionRequest& motion);

  /// Provides the collisions of the legs; none without enough sensor readings, and none during
  /// special actions.
  void update(const SensorDataBuffer& sensors, const JointData& joints, const MotionInfo& motion,
              CollisionPercept& percept, Debug& debug);

 private:
  using LegAngles = EnumArray<Leg, std::array<double, 2>>;  ///< Rotator and elevator, rad.

  double leastSum(Leg leg, std::size_t joint) const;
  bool changedSuddenly(const MotionRequest& motion);

  std::array<LegAngles, window + mostFrames> commands_;  ///< Newest first.
  std::array<LegAngles, window> measured_;
  int frames_ = 0;
  MotionRequest last_;
  Time changed_ = never();
  EnumArray<Leg, int> above_;
};

}  // namespace gt
