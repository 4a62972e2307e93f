#include "modules/motion/collisions/ReportCollisionDetector.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gt {
namespace {

const DebugKey plotStrength{"CollisionDetector/strength"};

template <typename Array, typename T>
void pushFront(Array& values, const T& value) {
  std::rotate(values.begin(), values.end() - 1, values.end());
  values[0] = value;
}

}  // namespace

void ReportCollisionDetector::update(const SensorDataBuffer& sensors, const JointData& joints,
                                     const MotionInfo& motion, CollisionPercept& percept,
                                     Debug& debug) {
  LegAngles command, measured;
  for (std::size_t i = 0; i < enumCount<Leg>; ++i)
    for (std::size_t j = 0; j < 2; ++j) {
      const Joint joint = legJoint(static_cast<Leg>(i), static_cast<int>(j) + 1);
      command.values[i][j] = joints.angles[joint];
      measured.values[i][j] = sensors.newest().joints[joint];
    }
  pushFront(commands_, command);
  pushFront(measured_, measured);
  frames_ = std::min(frames_ + 1, window + mostFrames);
  percept.time = sensors.newest().time;
  if (changedSuddenly(motion.executed)) changed_ = percept.time;
  const bool settled =
      frames_ == window + mostFrames && percept.time - changed_ >= parameters.settleTime &&
      (motion.executed.type == MotionType::walk || motion.executed.type == MotionType::stand);
  const auto [gait, speed] = placeOf(motion.executed);
  const double limit = std::max(1e-9, parameters.thresholds[gait][speed]);
  percept.strength = 0;
  for (std::size_t i = 0; i < enumCount<Leg>; ++i) {
    const Leg leg = static_cast<Leg>(i);
    const double strength = settled ? (leastSum(leg, 0) + leastSum(leg, 1)) / limit : 0;
    above_[leg] = strength >= 1 ? above_[leg] + 1 : 0;
    percept.legs[leg] = above_[leg] >= parameters.inARow;
    if (percept.legs[leg]) percept.lastCollision = percept.time;
    percept.strength = std::max(percept.strength, strength);
  }
  debug.plot(plotStrength, percept.strength);
}

/// The smallest sum of squared differences over the range of phase shifts.
double ReportCollisionDetector::leastSum(Leg leg, std::size_t joint) const {
  double least = std::numeric_limits<double>::max();
  const int last = std::max(parameters.leastShift, parameters.mostShift);
  for (int shift = parameters.leastShift; shift <= last; ++shift) {
    double sum = 0;
    for (int k = 0; k < window; ++k) {
      const double difference = measured_[static_cast<std::size_t>(k)][leg][joint] -
                                commands_[static_cast<std::size_t>(k + shift)][leg][joint];
      sum += difference * difference;
    }
    least = std::min(least, sum);
  }
  return least;
}

ReportCollisionDetector::Place ReportCollisionDetector::placeOf(const MotionRequest& motion) {
  if (motion.type != MotionType::walk) return {Gait::standing, 0};
  const Vector2d& v = motion.walk.translation;
  constexpr double arm = 150;  // mm: from the robot's middle to its feet
  const double turn = std::abs(motion.walk.rotation) * arm, speed = std::max(turn, v.norm());
  const auto band =
      static_cast<std::size_t>(std::clamp(speed / speedBand, 0., static_cast<double>(speeds - 1)));
  if (turn > v.norm()) return {Gait::turning, band};
  if (std::abs(v.y()) > std::abs(v.x())) return {Gait::sideways, band};
  return {v.x() < 0 ? Gait::backward : Gait::forward, band};
}

// Abrupt changes of the commands look like collisions.
bool ReportCollisionDetector::changedSuddenly(const MotionRequest& motion) {
  const bool sudden =
      motion.type != last_.type ||
      (motion.walk.translation - last_.walk.translation).norm() > parameters.suddenSpeed ||
      std::abs(motion.walk.rotation - last_.walk.rotation) > parameters.suddenTurn;
  last_ = motion;
  return sudden;
}

}  // namespace gt
