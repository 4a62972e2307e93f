#include "modules/modeling/selflocator/EdgeTables.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

constexpr double cellSize = 25;      // mm, as in the report
constexpr double mostCells = 600;    // along an axis; larger fields have larger cells
constexpr int posesOfTable = 20000;  // looked at, of each type

/// The fractional part, in [0, 1).
double fraction(double x) {
  return x - std::floor(x);
}

/// Poses that cover the field evenly: multiples of the powers of the root of x^4 = x + 1.
Pose2D evenPose(int i, const FieldDimensions& field) {
  constexpr double root = 1.2207440846057596;
  const double a = fraction(0.5 + i / root), b = fraction(0.5 + i / (root * root));
  const double c = fraction(0.5 + i / (root * root * root));
  return {pi * (2 * c - 1), field.xGroundline * (2 * a - 1), field.ySideline * (2 * b - 1)};
}

}  // namespace

EdgeTables::EdgeTables(const FieldDimensions& field, TeamColor team) {
  // A point that is measured wrongly may well lie beyond the walls.
  const double farX = std::max(field.xGoalBack, field.xGroundline) + 500;
  const double farY = field.ySideline + 500;
  resolution_ = std::max(cellSize, 2 * std::max(farX, farY) / mostCells);
  perMillimeter_ = static_cast<float>(1 / resolution_);
  columns_ = static_cast<int>(std::ceil(2 * farX / resolution_));
  rows_ = static_cast<int>(std::ceil(2 * farY / resolution_));
  low_ = {static_cast<float>(-farX), static_cast<float>(-farY)};
  const FieldEdges edges{field, team};
  fillEdges(edges);
  fillPoses(edges, field);
}

void EdgeTables::fillEdges(const FieldEdges& edges) {
  // Not quite the middle, which may lie on an edge and then tells no direction.
  constexpr double middle = 0.501;
  const auto point = [](const Vector2d& v) {
    return Point{static_cast<float>(v.x()), static_cast<float>(v.y())};
  };
  for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
    const auto type = static_cast<EdgeType>(t);
    edges_[type].reserve(static_cast<std::size_t>(columns_ * rows_));
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const Vector2d cell{low_.x + (column + middle) * resolution_,
                            low_.y + (row + middle) * resolution_};
        const Vector2d closest = edges.closest(type, cell);
        edges_[type].push_back({point(closest), point((closest - cell).normalized())});
      }
  }
}

void EdgeTables::fillPoses(const FieldEdges& edges, const FieldDimensions& field) {
  std::vector<double> distances, walls;
  for (int i = 0; i < posesOfTable; ++i) {
    const Pose2D pose = evenPose(i, field);
    const Vector2d ray = direction(pose.rotation);
    walls.assign(1, distanceStep * distanceSteps);
    edges.crossings(EdgeType::border, pose.translation, ray, walls);
    const double wall = *std::min_element(walls.begin(), walls.end());
    for (std::size_t t = 0; t < enumCount<EdgeType>; ++t) {
      const auto type = static_cast<EdgeType>(t);
      distances.clear();
      edges.crossings(type, pose.translation, ray, distances);
      for (const double distance : distances)
        if (distance <= wall && distance < distanceStep * distanceSteps)
          poses_[type][static_cast<std::size_t>(distance / distanceStep)].push_back(pose);
    }
  }
}

std::size_t EdgeTables::step(const Vector2d& seen) {
  return static_cast<std::size_t>(std::min(seen.norm() / distanceStep, distanceSteps - 1.0));
}

std::size_t EdgeTables::posesCount(EdgeType type, const Vector2d& seen) const {
  return poses_[type][step(seen)].size();
}

Pose2D EdgeTables::drawPose(EdgeType type, const Vector2d& seen, Random& random) const {
  const std::vector<Pose2D>& poses = poses_[type][step(seen)];
  Pose2D pose = poses[random.index(poses.size())];
  // The table looks straight ahead.
  return pose.rotate(-angleOf(seen));
}

}  // namespace gt
