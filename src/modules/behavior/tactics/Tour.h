#pragma once
#include <vector>

#include "modules/behavior/tactics/WorldState.h"

namespace gt {

/// The order of places (mm, on the field) on the shortest path from a place through all of them,
/// without returning. Exact; for up to eight places.
std::vector<Vector2d> shortestTour(const Vector2d& from, std::vector<Vector2d> places);

/// A tour through the places to be visited (report 4.2.1). It is planned when its first place is
/// requested, from the robot's position at that time. It is forgotten if no place was requested for
/// five seconds.
class Tour {
 public:
  /// A place of the tour (mm, on the field), with the rotation in which the robot looks at the
  /// border of the field. The robot's own pose if the index is out of range.
  const Pose2D& at(std::size_t index, const WorldState& world);
  /// The number of places; 0 before the tour was planned.
  std::size_t size() const { return poses_.size(); }

 private:
  std::vector<Pose2D> poses_;
  Pose2D own_;
  Time asked_ = never();
};

/// The rotation (rad) at a place (mm, on the field) in which the robot looks at the nearest border
/// of the field that it can see from there.
double towardsBorder(const Vector2d& place, const FieldDimensions& field);

}  // namespace gt
