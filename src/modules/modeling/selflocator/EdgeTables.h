#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/Random.h"
#include "modules/modeling/selflocator/FieldEdges.h"

namespace gt {

/// Lookup tables of the self-locator Lines: for each type of edge the closest model point of each
/// place (report 3.3.3.1), and the poses from which an edge is seen at a distance (3.3.3.2).
/// Computed once for a field. Lengths in mm, on the field.
class EdgeTables {
 public:
  struct Point {
    float x, y;
  };

  /// An edge near a cell: a point on it, and the unit vector from the cell to it, perpendicular to
  /// the edge.
  struct Edge {
    Point point, normal;
  };

  EdgeTables(const FieldDimensions& field, TeamColor team);

  /// The edge of a type that is nearest to the cell of a place; for places outside of the table, to
  /// the nearest cell.
  const Edge& nearest(EdgeType type, float x, float y) const {
    return edges_[type][static_cast<std::size_t>(row(y) * columns_ + column(x))];
  }
  /// The point on the nearest edge, approximated by a straight line, that is nearest to the place.
  Point closest(EdgeType type, float x, float y) const {
    const Edge& edge = nearest(type, x, y);
    const float distance = (edge.point.x - x) * edge.normal.x + (edge.point.y - y) * edge.normal.y;
    return {x + distance * edge.normal.x, y + distance * edge.normal.y};
  }

  /// The number of poses from which an edge of a type is seen at about the distance of a point (mm,
  /// relative to the robot).
  std::size_t posesCount(EdgeType type, const Vector2d& seen) const;
  /// A random one of the poses from which an edge of a type is seen at a point (mm, relative to the
  /// robot). posesCount must not be 0.
  Pose2D drawPose(EdgeType type, const Vector2d& seen, Random& random) const;

  double resolution() const { return resolution_; }

 private:
  static constexpr double distanceStep = 50;  ///< mm
  static constexpr int distanceSteps = 80;

  int column(float x) const { return cell(x, low_.x, columns_); }
  int row(float y) const { return cell(y, low_.y, rows_); }
  int cell(float value, float low, int count) const {
    const float i = (value - low) * perMillimeter_;
    return i > 0 ? (i < static_cast<float>(count) ? static_cast<int>(i) : count - 1) : 0;
  }
  void fillEdges(const FieldEdges& edges);
  void fillPoses(const FieldEdges& edges, const FieldDimensions& field);
  static std::size_t step(const Vector2d& seen);

  double resolution_;
  float perMillimeter_;
  Point low_;
  int columns_, rows_;
  EnumArray<EdgeType, std::vector<Edge>> edges_;
  EnumArray<EdgeType, std::array<std::vector<Pose2D>, distanceSteps>> poses_;
};

}  // namespace gt
