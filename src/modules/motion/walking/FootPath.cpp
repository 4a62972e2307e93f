#include "modules/motion/walking/FootPath.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

/// The point at a share of the path around an ellipse with half axes 1 and `height`, which begins
/// at its rear end and first goes up.
FootPath::Point onEllipse(double share, double height) {
  const double angle = pi * share;
  return {-std::cos(angle), 0, 0, height * std::sin(angle)};
}

FootPath::Point pointOf(const Vector3d& corner) {
  return {corner.x(), 0, corner.y(), corner.z()};
}

}  // namespace

FootPath::FootPath(const WalkParameters& p, Leg leg)
    : mode_{p.footMode},
      air_{1 - (isFore(leg) ? p.foreGroundPhase : p.hindGroundPhase)},
      lift_{isFore(leg) ? p.foreLiftPhase : p.hindLiftPhase},
      lowering_{isFore(leg) ? p.foreLoweringPhase : p.hindLoweringPhase},
      height_{isFore(leg) ? p.foreFootLift : p.hindFootLift},
      quadruple_{isFore(leg) ? p.foreFreeFormQuadPos : p.hindFreeFormQuadPos} {
  // Where both leave too little time for the way ahead, each is shortened alike.
  const double leastAcross = air_ / 10;
  const double tooLong = (lift_ + lowering_) / (air_ - leastAcross);
  if (tooLong > 1) {
    lift_ /= tooLong;
    lowering_ /= tooLong;
  }
}

FootPath::Point FootPath::at(double phase) const {
  if (!inAir(phase)) return onGround((phase - air_) / (1 - air_));
  if (phase < lift_) return inFlight(phase / lift_);
  const double left = air_ - phase;
  if (left < lowering_) return inFlight(3 - left / lowering_);
  return inFlight(1 + (phase - lift_) / (air_ - lift_ - lowering_));
}

FootPath::Point FootPath::onGround(double share) const {
  switch (mode_) {
    case FootMode::ellipse:
      return onEllipse(1 + share, height_ / 2);
    case FootMode::freeFormQuad:
      return pointOf(quadruple_[0] + share * (quadruple_[1] - quadruple_[0]));
    default:
      return {1 - 2 * share, 0, 0, 0};
  }
}

FootPath::Point FootPath::inFlight(double progress) const {
  const double lifted = std::clamp(progress, 0., 1.), across = std::clamp(progress - 1, 0., 1.),
               lowered = std::clamp(progress - 2, 0., 1.);
  switch (mode_) {
    case FootMode::halfEllipse:
      return onEllipse(progress / 3, height_);
    case FootMode::ellipse:
      return onEllipse(progress / 3, height_ / 2);
    case FootMode::oval: {
      // Half a circle behind, the way ahead, half a circle there.
      const double angle = pi * (lifted + lowered), radius = height_ / 2;
      return {2 * across - 1, -radius * std::sin(angle), 0, radius * (1 - std::cos(angle))};
    }
    case FootMode::freeFormQuad: {
      const auto& q = quadruple_;
      const auto part = std::min(static_cast<std::size_t>(progress), std::size_t{2});
      const Vector3d from = q[part + 1], to = q[(part + 2) % q.size()];
      return pointOf(from + (progress - static_cast<double>(part)) * (to - from));
    }
    case FootMode::rectangle:
      break;
  }
  return {2 * across - 1, 0, 0, height_ * (lifted - lowered)};
}

}  // namespace gt
