#include "simulation/world/Gait.h"

#include <algorithm>
#include <cmath>

#include "simulation/world/World.h"

namespace gt {
namespace {

constexpr double usualSpeed = 200;  // mm/s: at which the swaying is that of the scene

// How bodies sway in the dynamic fidelity, fitted to `realism.sway` with both walks that play uses
// (docs/realism.md). With the feet: it rolls as soon as one diagonal is lifted, nods after how high
// it is lifted, and rises and sinks less than the legs do.
constexpr double rollLift = 8;                                                      // mm
constexpr double rollTime = 0.02, nodTime = 0.03, heightTime = 0.08, meanTime = 1;  // s
/// How far the body sinks while the robot stands, and while it walks for each mm of the feet's mean
/// lift, as multiples of the scene's `swayHeight`.
constexpr double sinkingStand = 1.3, sinkingWalk = 0.24, sinkingTime = 0.3;  // s
/// How far the body leans to its nose while the robot walks, and how much more if it walks ahead
/// (less if back), as multiples of the scene's `swayTilt`.
constexpr double leanWalk = 0.6, leanAhead = 1.05;
/// The standard deviations of roll, nod (mm) and level in the walk `normal`.
constexpr double usualRoll = 0.8, usualNod = 0.91, usualLevel = 0.28;
constexpr double heightGrowth = 0.2;  ///< The exponent of the height's growth with the speed.
constexpr double slowGrowth = 0.25;   ///< That of lean and roll, up to the usual speed.
/// The irregular part of the sway: shares of the above in a stroke of the usual length, which grow
/// with its fourth power. A stroke is the distance that the body moves while a foot stands.
constexpr double irregularTilt = 0.28, irregularRoll = 0.11, irregularHeight = 0.37;
constexpr double usualStroke = 28, longestStroke = 42;  // mm: none was measured beyond.
constexpr double strokeShare = 0.2;                     ///< Of each new stroke in their mean.
constexpr double lifted = 1;                            // mm: a foot stands that is lower.
/// Time for which the irregular part keeps its direction: half of a step.
constexpr double wanderTime = 0.15;  // s

/// Moves a number towards another one for a tick, with a time constant (s).
void approach(double& number, double other, double seconds) {
  number += (1 - std::exp(-tickSeconds / seconds)) * (other - number);
}

}  // namespace

void Gait::follow(double uneven, double height) {
  const double leans = std::clamp(uneven / rollLift, -1., 1.);
  approach(rolls_, leans, rollTime);
  double feet = std::abs(uneven);
  for (double& nod : nods_) {
    approach(nod, feet, nodTime);
    feet = nod;
  }
  level_ = std::abs(leans);
  approach(meanLevel_, level_, heightTime);
  if (height_ < 0) height_ = height;
  approach(height_, height, heightTime);
}

void Gait::stand(const std::array<double, 4>& lifts) {
  for (std::size_t leg = 0; leg < lifts.size(); ++leg) {
    if (lifts[leg] < lifted) {
      stands_[leg] += tickSeconds;
      continue;
    }
    if (stands_[leg] > 0) stance_ += strokeShare * (stands_[leg] - stance_);
    stands_[leg] = 0;
  }
}

const Sway& Gait::sway(const BodyParameters& body, const std::array<double, 4>& lifts,
                       double height, double speed, double ahead) {
  if (body.swayTilt == 0 && body.swayRoll == 0 && body.swayHeight == 0) return now_ = {};
  const double keep = std::exp(-tickSeconds / wanderTime);
  const double fresh = std::sqrt(1 - keep * keep);
  for (double* wander : {&wanderTilt_, &wanderRoll_, &wanderHeight_})
    *wander = keep * *wander + fresh * random_.gaussian();
  // While diagonals are lifted in turns, the body leans to the side that has less below it;
  // likewise if the feet of both sides are.
  const double side = lifts[0] + lifts[2] - lifts[1] - lifts[3];
  const double diagonal = lifts[0] + lifts[3] - lifts[1] - lifts[2];
  approach(sides_, std::abs(side), meanTime);
  approach(diagonals_, std::abs(diagonal), meanTime);
  follow(sides_ > diagonals_ ? side : diagonal, height);
  const double times = speed / usualSpeed, slow = std::pow(std::min(times, 1.), slowGrowth);
  approach(walks_, slow, sinkingTime);
  approach(walksAhead_, slow * ahead, sinkingTime);
  const double sinking =
      std::lerp(sinkingStand, sinkingWalk * std::max(sides_, diagonals_), walks_);
  now_ = {-fromDegrees(body.swayTilt) * (leanWalk * walks_ + leanAhead * walksAhead_), 0,
          -sinking * body.swayHeight};
  if (speed == 0) {
    height_ = height;
    stands_ = {};
    return now_;
  }
  stand(lifts);
  const double stroke = std::min(speed * stance_, longestStroke) / usualStroke;
  const double irregular = std::pow(stroke, 4);
  now_.tilt += fromDegrees(body.swayTilt) *
               ((nods_[3] - nods_[2]) / usualNod + irregularTilt * irregular * wanderTilt_);
  now_.roll = fromDegrees(body.swayRoll) *
              (slow * rolls_ / usualRoll + irregularRoll * irregular * wanderRoll_);
  now_.height +=
      body.swayHeight * (std::pow(times, heightGrowth) * (meanLevel_ - level_) / usualLevel +
                         irregularHeight * irregular * wanderHeight_);
  if (body.swayHeight > 0) now_.height += height_ - height;
  return now_;
}

double Gait::progress(const WalkingParameters& walking, double speed) {
  double share = 1 - walking.shortfall - walking.gaitShortfall * speed / usualSpeed;
  if (walking.bursts > 0) {
    slipsFor_ -= tickSeconds;
    if (slipsFor_ <= 0 && random_.chance(walking.bursts / 60 * tickSeconds))
      slipsFor_ = -walking.burstTime * std::log(1 - random_.uniform());
    if (slipsFor_ > 0) share *= 1 - walking.burstSlip;
  }
  return share;
}

double Gait::contactTurn(const WalkingParameters& walking, bool blocked) {
  if (walking.contactTurn == 0 || !blocked) return turning_ = 0;
  if (turning_ == 0) turning_ = random_.symmetric();
  return turning_ * fromDegrees(walking.contactTurn) * tickSeconds;
}

Vector3d Gait::contactShaking(const WalkingParameters& walking, bool blocked) {
  if (walking.contactShaking == 0 || !blocked) return Vector3d::Zero();
  Vector3d shaking;
  for (double& axis : shaking) axis = walking.contactShaking * random_.gaussian();
  return shaking;
}

}  // namespace gt
