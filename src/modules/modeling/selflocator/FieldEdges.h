#pragma once
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/perception/LinesPercept.h"

namespace gt {

/// Where the edges of the field lie that a robot can see: the middles of the lines, the foot of the
/// border, the foot of both goals' walls (report 3.3.3.1). In a team's coordinates. Where a field
/// has no walls (height 0), lines lie there instead.
class FieldEdges {
 public:
  FieldEdges(const FieldDimensions& field, TeamColor team);

  /// The point on an edge of a type that is nearest to a point (mm).
  Vector2d closest(EdgeType type, const Vector2d& point) const;
  /// Adds how far away (mm, ahead) a ray along a unit vector crosses edges of a type.
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
