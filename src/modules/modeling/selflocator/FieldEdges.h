#pragma once
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

/// The edges of the field that a robot can see: the middles of the lines, the foot of the border,
/// the foot of both goals' walls (report 3.3.3.1). In mm, in a team's coordinates. On a field
/// without walls (height 0) lines replace the border.
class FieldEdges {
 public:
  FieldEdges(const FieldDimensions& field, TeamColor team);

  /// The point on an edge of a type that is nearest to a point (mm).
  Vector2d closest(EdgeType type, const Vector2d& point) const;
  /// Appends the distances (mm) along a ray, from a point (mm) in the direction of a unit vector,
  /// at which it crosses edges of a type.
  void crossings(EdgeType type, const Vector2d& from, const Vector2d& ray,
                 std::vector<double>& distances) const;

 private:
  struct Segment {
    Vector2d from, to;
  };

  void addMirrored(EdgeType type, const Vector2d& from, const Vector2d& to);

  EnumArray<EdgeType, std::vector<Segment>> segments_;
  double circleRadius_;
};

}  // namespace gt
