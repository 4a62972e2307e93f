#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/Random.h"
#include "modules/modeling/selflocator/FieldEdges.h"

namespace gt {

/// What the lines self-locator looks up instead of computing it: for each type of edge the closest
/// model point of each place (report 3.3.3.1), and the poses from which an edge is seen at a
/// distance (3.3.3.2). Computed once for a field.
class EdgeTables {
 public:
  struct Point {
    float x, y;
  };

  /// An edge near a cell: a point on it, and where to it lies from the cell, as a unit vector.
  struct Edge {
    Point point, normal;
  };

  EdgeTables(const FieldDimensions& field, TeamColor team);

  /// The edge of a type that is nearest to the cell in which a place lies; beyond the table, to the
  /// nearest cell.
  const Edge& nearest(EdgeType type, float x, float y) const {
    return edges_[type][static_cast<std::size_t>(row(y) * columns_ + column(x))];
  }
  /// The point on that edge, taken for a straight one, that is nearest to the place.
  Point closest(EdgeType type, float x, float y) const {
    const Edge& edge = nearest(type, x, y);
    const float distance = (edge.point.x - x) * edge.normal.x + (edge.point.y - y) * edge.normal.y;
    return {x + distance * edge.normal.x, y + distance * edge.normal.y};
  }

  /// How many poses see an edge of a type at about the distance (mm) of a point.
  std::size_t posesCount(EdgeType type, const Vector2d& seen) const;
  /// One of the poses from which an edge of a type is seen at a point, given relative to the robot.
  /// There must be some.
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
