#include "modules/perception/processors/ImageDelay.h"

#include <algorithm>
#include <cmath>

#include "modules/perception/specialists/SeenHeights.h"

namespace gt {
namespace {

constexpr std::int64_t longestGap = 120;  // ms between two images of a flag
constexpr double mostOff = 0.25;          // rad: what differs by more is another thing
constexpr double longestDelay = 0.05;     // s
constexpr double angleNoise = 0.03;       // rad: of a flag's change while the robot walks
constexpr double heightNoise = 0.025;     // rad: of a flag's elevation, which tilt and roll have
constexpr double usualDelay = 0.02;       // s: standard deviation before anything is known
constexpr double longestPause = 1000;     // ms that count as time in which to forget

}  // namespace

void ImageDelay::learn(const LandmarksPercept& landmarks, const CameraMatrix& matrix,
                       const Pose2D& odometry, const FieldDimensions& field, double memory) {
  if (landmarks.time != matrix.time || landmarks.time == lastImage_ || !matrix.valid) return;
  const double pause =
      std::clamp(static_cast<double>(landmarks.time - lastImage_), 0., longestPause);
  lastImage_ = landmarks.time;
  products_ *= std::exp(-pause / memory);
  squares_ *= std::exp(-pause / memory);
  const double turning = matrix.turning.z();
  for (int i = 0; i < landmarks.numberOfFlags; ++i) {
    const FlagPercept& flag = landmarks.flags[static_cast<std::size_t>(i)];
    if (flag.distance == 0 || flag.boundary.leftOnBorder || flag.boundary.rightOnBorder) continue;
    const Sighting now{landmarks.time, flag.angle + seconds_ * turning, flag.distance, turning,
                       odometry};
    learn(last_[flag.type], now);
    learnFromHeight(flag, matrix, field);
    last_[flag.type] = now;
  }
  const double prior = std::pow(angleNoise / usualDelay, 2);
  seconds_ = std::clamp(products_ / (squares_ + prior), 0., longestDelay);
}

void ImageDelay::learn(const Sighting& before, const Sighting& now) {
  if (before.time == never() || now.time - before.time > longestGap) return;
  const Vector2d place =
      relative(now.odometry.relativeTo(before.odometry), before.distance * direction(before.angle));
  const double off = normalize(now.angle - angleOf(place));
  if (std::abs(off) > mostOff) return;
  const double faster = now.turning - before.turning;
  products_ += faster * off;
  squares_ += faster * faster;
}

void ImageDelay::learnFromHeight(const FlagPercept& flag, const CameraMatrix& matrix,
                                 const FieldDimensions& field) {
  const auto height = heightOf(flag, matrix, field);
  if (!height) return;
  const ConditionalBoundary& b = flag.boundary;
  const double azimuth = height->azimuth, seen = (std::tan(b.top) + std::tan(b.bottom)) / 2;
  const double rising =
      matrix.turning.cross(Vector3d{std::cos(azimuth), std::sin(azimuth), seen}).z();
  const double off = height->tooHigh + seconds_ * rising;
  if (std::abs(off) > mostOff) return;
  const double weight = std::pow(angleNoise / heightNoise, 2);
  products_ += weight * rising * off;
  squares_ += weight * rising * rising;
}

}  // namespace gt
