#include "modules/modeling/selflocator/RecentView.h"

#include <algorithm>
#include <cmath>

#include "modules/modeling/selflocator/PoseTemplates.h"

namespace gt {
namespace {

constexpr std::size_t pointsOfImage = 12;
constexpr int oldest = 15;  // images

/// Rotates vectors by an angle whose sine and cosine are computed once.
class Rotation {
 public:
  explicit Rotation(double angle) : cosine_{std::cos(angle)}, sine_{std::sin(angle)} {}
  Vector2d operator*(const Vector2d& v) const {
    return {cosine_ * v.x() - sine_ * v.y(), sine_ * v.x() + cosine_ * v.y()};
  }

 private:
  double cosine_, sine_;
};

double toleranceOf(const Vector2d& point) {
  return 50 + 0.15 * point.norm();
}

/// 1 if the error is 0, 1/2 if it equals the tolerance.
double fit(double error, double tolerance) {
  const double ratio = error / tolerance;
  return 1 / (1 + ratio * ratio);
}

}  // namespace

void RecentView::move(const Pose2D& odometry) {
  const Rotation back{-odometry.rotation};
  for (std::size_t i = 0; i < numberOfPoints_; ++i) {
    SeenPoint& seen = points_[i];
    seen.point = back * (seen.point - odometry.translation);
    seen.tolerance = toleranceOf(seen.point);
  }
  for (std::size_t i = 0; i < numberOfBearings_; ++i) {
    SeenBearing& b = bearings_[i];
    b.camera = back * (b.camera - odometry.translation);
    b.direction = back * b.direction;
    b.angle = angleOf(b.direction);
  }
}

void RecentView::add(const std::vector<ChosenPoint>& points, Random& random) {
  for (std::size_t i = 0; i < numberOfBearings_; ++i) ++bearings_[i].age;
  const std::size_t count = std::min(pointsOfImage, points.size());
  const std::size_t start = points.empty() ? 0 : random.index(points.size());
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [type, point] = points[(start + i * points.size() / count) % points.size()];
    points_[nextPoint_] = {type, point, toleranceOf(point)};
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
    *place = {bearing.landmark, cameraOffset, bearing.direction, angleOf(bearing.direction), 0};
  }
}

double RecentView::score(const Pose2D& pose, const EdgeTables& tables, double least) const {
  constexpr double bearingWeight = 4;
  double most = static_cast<double>(numberOfPoints_);
  for (std::size_t i = 0; i < numberOfBearings_; ++i)
    if (bearings_[i].age <= oldest) most += bearingWeight;
  if (most == 0) return 0;
  // What a pose may lose; rounding must not decide.
  double left = most * (1 + 1e-9 - least);
  double sum = 0;
  const auto add = [&](double weight, double fits) {
    sum += weight * fits;
    left -= weight * (1 - fits);
    return left >= 0;
  };
  const Rotation turn{pose.rotation};
  for (std::size_t i = 0; i < numberOfPoints_; ++i) {
    const auto& [type, point, tolerance] = points_[i];
    const Vector2d place = pose.translation + turn * point;
    const EdgeTables::Point edge =
        tables.closest(type, static_cast<float>(place.x()), static_cast<float>(place.y()));
    if (!add(1, fit((Vector2d{edge.x, edge.y} - place).norm(), tolerance))) return 0;
  }
  for (std::size_t i = 0; i < numberOfBearings_; ++i) {
    const SeenBearing& b = bearings_[i];
    if (b.age > oldest) continue;
    const Vector2d way = b.landmark - (pose.translation + turn * b.camera);
    if (!add(bearingWeight, fit(normalize(angleOf(way) - pose.rotation - b.angle), 0.1))) return 0;
  }
  return sum / most;
}

std::optional<Pose2D> RecentView::drawPose(const EdgeTables& tables, const FieldDimensions& field,
                                           Random& random) const {
  if (numberOfBearings_ > 0 && (numberOfPoints_ == 0 || random.chance(0.5)))
    return drawFromBearings(field, random);
  if (numberOfPoints_ == 0) return std::nullopt;
  const auto& [type, point, tolerance] = points_[random.index(numberOfPoints_)];
  if (tables.posesCount(type, point) == 0) return std::nullopt;
  return tables.drawPose(type, point, random);
}

/// Bearings on two landmarks determine a curve of poses, a bearing on one an area: the remaining
/// degrees of freedom are drawn at random.
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
