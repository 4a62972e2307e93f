#include "modules/motion/collisions/MotorModelCollisionDetector.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gt {
namespace {

const DebugKey plotStrength{"CollisionDetector/strength"};

}  // namespace

double MotorModelCollisionDetector::Walk::score(const CollisionFeatures::Values& features) const {
  return std::inner_product(features.begin(), features.end(), weights.begin(), constant);
}

const MotorModelCollisionDetector::Walk* MotorModelCollisionDetector::Parameters::of(
    WalkType type) const {
  switch (type) {
    case WalkType::normal:
      return &normal;
    case WalkType::fast:
    case WalkType::backward:
      return &fast;
    case WalkType::dribble:
      return &dribble;
    default:
      return nullptr;
  }
}

void MotorModelCollisionDetector::update(const SensorDataBuffer& sensors, const JointData& joints,
                                         const MotionInfo& motion, CollisionPercept& percept,
                                         Debug& debug) {
  static const Walk unknown;
  const Walk* walk = parameters.of(motion.executed.walkType);
  features_.add(sensors.newest(), joints, motion, walk ? walk->motors : unknown.motors);
  percept.time = sensors.newest().time;
  percept.legs = {};
  constexpr double strongest = 5;
  percept.strength =
      walk && features_.ready()
          ? std::exp(std::clamp(walk->score(features_.values()), -strongest, strongest))
          : 0;
  above_ = percept.strength > 1 ? above_ + 1 : 0;
  if (above_ >= parameters.inARow) {
    percept.legs[features_.mostOff()] = true;
    percept.lastCollision = percept.time;
  }
  debug.plot(plotStrength, percept.strength);
}

}  // namespace gt
