#include "modules/perception/processors/LeanFilter.h"

#include <algorithm>
#include <cmath>

namespace gt {

void LeanFilter::predict(double elapsed, bool walks) {
  const Parameters& p = parameters;
  const auto variance = [](double deviation) { return deviation * deviation; };
  if (!begun_)
    state_.covariance.diagonal() << variance(p.lean), variance(p.lean), variance(p.headRoll),
        variance(p.height), variance(p.giving), 0, 0;
  begun_ = true;
  constexpr double longest = 1000;  // ms: after a break it is as unsure as after this time.
  const double seconds = std::clamp(elapsed, 0., longest) / 1000;
  for (const int angle : {leanX, leanY, ofHead})
    state_.covariance(angle, angle) += variance(p.drift) * seconds;
  const double keep = std::exp(-std::max(elapsed, 0.) / p.swayTime);
  walks_ = walks;
  if (walkingVariance_ == 0) walkingVariance_ = variance(p.swayWalking);
  const double sway = walks ? walkingVariance_ : variance(p.swayStanding);
  for (const int angle : {swayX, swayY}) {
    state_.value[angle] *= keep;
    state_.covariance.row(angle) *= keep;
    state_.covariance.col(angle) *= keep;
    state_.covariance(angle, angle) += (1 - keep * keep) * sway;
  }
}

void LeanFilter::learn(std::span<const SeenHeight> heights, double cameraAzimuth,
                       const BodyPosture& giving) {
  if (!parameters.learns) return;
  const Shares shared = shares(cameraAzimuth, giving);
  const State::Vector before = state_.value;
  for (const SeenHeight& seen : heights) {
    const State::Vector row = shared.transpose() * seen.mended();
    const double swayHeight = parameters.swayHeight / seen.distance;
    const double variance = seen.deviation * seen.deviation + swayHeight * swayHeight;
    // What the matrix was corrected by was not seen any more.
    const double measured = seen.tooHigh + row.dot(before);
    if (walks_) adaptSwaying(state_.surprise(row, measured, variance));
    state_.add(row, measured, variance);
  }
}

void LeanFilter::adaptSwaying(double surprise) {
  constexpr double gain = 0.02, mostSurprise = 3;
  constexpr double least = fromDegrees(0.2), most = fromDegrees(2);
  const double counts = std::min(surprise, mostSurprise);
  walkingVariance_ =
      std::clamp(walkingVariance_ * (1 + gain * (counts * counts - 1)), least * least, most * most);
}

BodyPosture LeanFilter::posture(const BodyPosture& giving) const {
  const double gives = legsGive();
  return built() + BodyPosture{gives * giving.height, gives * giving.tilt - state_.value[swayY],
                               gives * giving.roll + state_.value[swayX]};
}

BodyPosture LeanFilter::built() const {
  return {state_.value[height], -state_.value[leanY], state_.value[leanX]};
}

BodyPosture LeanFilter::deviation() const {
  const auto of = [&](int i) { return std::sqrt(state_.covariance(i, i)); };
  return {of(height), of(leanY), of(leanX)};
}

LeanFilter::Shares LeanFilter::shares(double cameraAzimuth, const BodyPosture& giving) {
  Shares shares = Shares::Zero();
  shares(0, leanX) = shares(0, swayX) = 1;
  shares(1, leanY) = shares(1, swayY) = 1;
  shares(2, height) = 1;
  shares.col(share) << giving.roll, -giving.tilt, giving.height;
  shares(0, ofHead) = std::cos(cameraAzimuth);
  shares(1, ofHead) = std::sin(cameraAzimuth);
  return shares;
}

Matrix3d LeanFilter::covariance(double cameraAzimuth, const BodyPosture& giving) const {
  const Shares shared = shares(cameraAzimuth, giving);
  Matrix3d covariance = shared * state_.covariance * shared.transpose();
  covariance(2, 2) += parameters.swayHeight * parameters.swayHeight;
  return covariance;
}

}  // namespace gt
