#pragma once
#include <array>

#include "debug/Debug.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/motion/MotionInfo.h"
#include "representations/perception/CollisionPercept.h"
#include "streams/Reflection.h"

namespace gt {

/// How the robot walks, as far as it matters for how its legs follow their commands.
enum class Gait { standing, forward, backward, sideways, turning };

/// Compares what the legs' motors were told with what they did: a leg that is held up lags behind
/// (report 3.6). A solution of CollisionDetector.
class DefaultCollisionDetector {
 public:
  static constexpr int window = 12;      ///< Squared differences that are summed.
  static constexpr int mostFrames = 16;  ///< By which commands may be ahead of the sensors.

  struct Parameters {
    EnumArray<Gait, double> thresholds{{0.02, 0.05, 0.05, 0.05, 0.05}};
    double thresholdBySpeed = 0;
    int leastShift = 1, mostShift = 8;
    double suddenSpeed = 40;
    double suddenTurn = 0.3;
    std::int64_t settleTime = 400;
    int inARow = 3;

    static constexpr auto fields() {
      using P = Parameters;
      constexpr Range frames{0, mostFrames};
      return Fields{
          field("thresholds", &P::thresholds, "rad^2",
                "of the sum of squared differences of a leg, for each gait", {0, 1000}),
          field("thresholdBySpeed", &P::thresholdBySpeed, "1/(mm/s)",
                "by which share of itself the threshold grows with speed", {0, 1}),
          field("leastShift", &P::leastShift, "frames", "of 8 ms: phase shift of the sensors",
                frames),
          field("mostShift", &P::mostShift, "frames", "", frames),
          field("suddenSpeed", &P::suddenSpeed, "mm/s",
                "change of the command within a frame that makes the legs lag by itself",
                {0, 10000}),
          field("suddenTurn", &P::suddenTurn, "rad/s", "likewise", {0, 100}),
          field("settleTime", &P::settleTime, "ms", "after that, without detection", {0, 10000}),
          field("inARow", &P::inARow, "frames", "above the threshold that make a collision",
                {1, 100})};
    }
  };
  Parameters parameters;

  void update(const SensorDataBuffer& sensors, const JointData& joints, const MotionInfo& motion,
              CollisionPercept& percept, Debug& debug);

 private:
  using LegAngles = EnumArray<Leg, std::array<double, 2>>;  ///< Rotator and elevator, rad.

  double leastSum(Leg leg, std::size_t joint) const;
  double threshold(const MotionRequest& motion) const;
  bool changedSuddenly(const MotionRequest& motion);

  std::array<LegAngles, window + mostFrames> commands_;  ///< Newest first.
  std::array<LegAngles, window> measured_;
  int frames_ = 0;
  MotionRequest last_;
  Time changed_ = never();
  EnumArray<Leg, int> above_;
};
static_assert(complete<DefaultCollisionDetector::Parameters>);

}  // namespace gt
