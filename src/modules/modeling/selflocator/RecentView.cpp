#include "modules/modeling/selflocator/RecentView.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/PoseTemplates.h"

namespace gt {
namespace {

constexpr std::size_t pointsOfImage = 12;
constexpr int oldest = 15;  // images

/// 1 for what fits exactly, 1/2 for what is off by the tolerance.
double fit(double error, double tolerance) {
  const double ratio = error / tolerance;
  return 1 / (1 + ratio * ratio);
}

}  // namespace

void RecentView::move(const Pose2D& odometry) {
  for (std::size_t i = 0; i < numberOfPoints_; ++i)
    points_[i].point = relative(odometry, points_[i].point);
  for (std::size_t i = 0; i < numberOfBearings_; ++i) {
    SeenBearing& b = bearings_[i];
    b.camera = relative(odometry, b.camera);
    b.direction = rotated(b.direction, -odometry.rotation);
  }
}

void RecentView::add(const std::vector<ChosenPoint>& points, Random& random) {
  for (std::size_t i = 0; i < numberOfBearings_; ++i) ++bearings_[i].age;
  const std::size_t count = std::min(pointsOfImage, points.size());
  const std::size_t start = points.empty() ? 0 : random.index(points.size());
  for (std::size_t i = 0; i < count; ++i) {
    points_[nextPoint_] = points[(start + i * points.size() / count) % points.size()];
    nextPoint_ = (nextPoint_ + 1) % points_.size();
    numberOfPoints_ = std::min(numberOfPoints_ + 1, points_.size());
  }
}

void RecentView::add(const Bearings& bearings, const Vector2d& cameraOffset) {
  for (const Bearing& bearing : bearings) {
    // One of each landmark, the newest.
    const auto end = bearings_.begin() + static_cast<std::ptrdiff_t>(numberOfBearings_);
    auto place = std::find_if(bearings_.begin(), end, [&](const SeenBearing& b) {
      return (b.landmark - bearing.landmark).squaredNorm() < 1;
    });
    if (place == end) {
      place = bearings_.begin() + static_cast<std::ptrdiff_t>(nextBearing_);
      nextBearing_ = (nextBearing_ + 1) % bearings_.size();
      numberOfBearings_ = std::min(numberOfBearings_ + 1, bearings_.size());
    }
    *place = {bearing.landmark, cameraOffset, bearing.direction, 0};
  }
}

double RecentView::score(const Pose2D& pose, const EdgeTables& tables) const {
  double sum = 0, most = 0;
  for (std::size_t i = 0; i < numberOfPoints_; ++i) {
    const auto& [type, point] = points_[i];
    const Vector2d place = pose * point;
    const EdgeTables::Point edge =
        tables.closest(type, static_cast<float>(place.x()), static_cast<float>(place.y()));
    sum += fit((Vector2d{edge.x, edge.y} - place).norm(), 50 + 0.15 * point.norm());
    ++most;
  }
  constexpr double bearingWeight = 4;
  for (std::size_t i = 0; i < numberOfBearings_; ++i) {
    const SeenBearing& b = bearings_[i];
    if (b.age > oldest) continue;
    const Vector2d way = b.landmark - pose * b.camera;
    const double angle = normalize(angleOf(way) - pose.rotation - angleOf(b.direction));
    sum += bearingWeight * fit(angle, 0.1);
    most += bearingWeight;
  }
  return most > 0 ? sum / most : 0;
}

std::optional<Pose2D> RecentView::drawPose(const EdgeTables& tables, const FieldDimensions& field,
                                           Random& random) const {
  if (numberOfBearings_ > 0 && (numberOfPoints_ == 0 || random.chance(0.5)))
    return drawFromBearings(field, random);
  if (numberOfPoints_ == 0) return std::nullopt;
  const auto& [type, point] = points_[random.index(numberOfPoints_)];
  if (tables.posesCount(type, point) == 0) return std::nullopt;
  return tables.drawPose(type, point, random);
}

/// Two landmarks leave a curve of poses, one leaves an area: any distance, any place.
std::optional<Pose2D> RecentView::drawFromBearings(const FieldDimensions& field,
                                                   Random& random) const {
  const SeenBearing& a = bearings_[random.index(numberOfBearings_)];
  const SeenBearing& b = bearings_[random.index(numberOfBearings_)];
  if (a.age > oldest || b.age > oldest) return std::nullopt;
  if (&a == &b) {
    Pose2D pose = randomPose(field, random);
    pose.rotation = normalize(angleOf(a.landmark - pose.translation) - angleOf(a.direction));
    return pose;
  }
  const double distance = random.uniform(300, 2 * field.xGroundline);
  std::array<Pose2D, 2> poses;
  const int count =
      posesFrom({a.landmark, a.camera + distance * a.direction}, {b.landmark, b.direction}, poses);
  if (count == 0) return std::nullopt;
  return poses[random.index(static_cast<std::uint64_t>(count))];
}

}  // namespace gt
