#include "simulation/world/Gait.h"

#include <algorithm>
#include <cmath>

#include "simulation/world/World.h"

namespace gt {
namespace {

constexpr double usualSpeed = 200;  // mm/s: at which the swaying is that of the scene
/// The exponent with which the swaying grows with the speed: hardly (`realism.sway`).
constexpr double growth = 0.25;
constexpr double usualLift = 25;  // mm (facts, 4)
/// How long the irregular part of the swaying keeps its direction: half of a step.
constexpr double wanderTime = 0.15;  // s
/// The shares of the variance of a sine in step with the feet and of the irregular part.
const double regular = std::sqrt(0.5) * std::sqrt(2.0), irregular = std::sqrt(0.5);

}  // namespace

const Sway& Gait::sway(const BodyParameters& body, const std::array<double, 4>& lifts,
                       double speed) {
  if (body.swayTilt == 0 && body.swayRoll == 0 && body.swayHeight == 0) return now_ = {};
  const double keep = std::exp(-tickSeconds / wanderTime);
  const double fresh = std::sqrt(1 - keep * keep);
  for (double* wander : {&wanderTilt_, &wanderRoll_, &wanderHeight_})
    *wander = keep * *wander + fresh * random_.gaussian();
  const double strength = std::pow(std::min(speed / usualSpeed, 2.), growth);
  const auto lifted = [&](double mm) { return std::clamp(mm / usualLift, -1.0, 1.0); };
  // While the right legs' and the left legs' feet are lifted in turns, the body leans to the side
  // that has less below it; fore and hind likewise.
  const double right = lifts[0] + lifts[2], left = lifts[1] + lifts[3];
  const double fore = lifts[0] + lifts[1], hind = lifts[2] + lifts[3];
  const double diagonal = lifts[0] + lifts[3] - lifts[1] - lifts[2];
  const double rolls =
      lifted(std::abs(right - left) > std::abs(diagonal) ? right - left : diagonal);
  const double tilts = lifted(hind - fore);
  const auto part = [&](double amplitude, double inStep, double wander) {
    return strength * amplitude * (regular * inStep + irregular * wander);
  };
  now_.tilt = part(fromDegrees(body.swayTilt), tilts, wanderTilt_);
  now_.roll = part(fromDegrees(body.swayRoll), rolls, wanderRoll_);
  now_.height = part(body.swayHeight, std::abs(rolls) - 0.5, wanderHeight_);
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

}  // namespace gt
