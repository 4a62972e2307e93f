#pragma once
#include <functional>

#include "base/DataRoot.h"
#include "measure/Experiment.h"
#include "representations/motion/MotionInfo.h"
#include "simulation/Simulation.h"

namespace gt {

/// What a robot did in a tick, and what really happened to it.
struct CollisionFrame {
  const SensorDataBuffer& sensors;
  const JointData& commanded;
  const MotionInfo& motion;
  const RobotBody& body;
  bool counts = true;  ///< The robot is up and nobody has moved it.
};

/// Tells free robots from those that something holds up.
///
/// A robot is held up for half a second if it touches walls or robots all the time, with gaps of a
/// quarter of a second at most, and makes less than half of the way that its legs go, which is 4 cm
/// at least; a turn of 1 rad counts as 15 cm. It is free if it has touched nothing for a second.
class HoldUp {
 public:
  static constexpr int window = 62;  ///< Ticks: half a second.

  /// What the half second was that ends with a tick: with the first one a collision begins.
  enum class Ended { none, collision, goesOn };
  Ended add(const CollisionFrame& frame);
  bool free() const { return free_; }

 private:
  void move(const Pose2D& pose, const MotionRequest& walk);

  int touching_ = 0, untouched_ = 0;  ///< Ticks.
  bool held_ = false, free_ = false;
  double made_ = 0, wanted_ = 0;  ///< mm
  Pose2D last_;
};

/// Called after each tick with the number of a robot and what it did.
using CollisionObserver = std::function<void(std::size_t robot, const CollisionFrame& frame)>;

/// Lets the eight robots of the match scene walk about without seeing anything, with all walk types
/// of play, for some minutes. Who falls or gets stuck at the field's border is put elsewhere.
Result<void> observeWalks(const Job& job, const DataRoot& root, double minutes,
                          const CollisionObserver& observe);
/// Lets them play.
Result<void> observePlay(const Job& job, const DataRoot& root, double minutes,
                         const CollisionObserver& observe);

}  // namespace gt
