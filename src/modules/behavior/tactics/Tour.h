#pragma once
#include <vector>

#include "modules/behavior/tactics/WorldState.h"

namespace gt {

/// The shortest way from a place through all others, not back: the order in which to visit them.
/// Exact; for up to eight places.
std::vector<Vector2d> shortestTour(const Vector2d& from, std::vector<Vector2d> places);

/// A tour through the places that are to be visited (report 4.2.1). It is planned when its first
/// place is asked for, from where the robot is then; it is forgotten when nobody has asked for a
/// place for five seconds.
class Tour {
 public:
  /// A place with the rotation in which the robot stands there: so that it looks at the border of
  /// the field. The robot's own pose if there is no such place.
  const Pose2D& at(std::size_t index, const WorldState& world);
  /// Of places; 0 before it was planned.
  std::size_t size() const { return poses_.size(); }

 private:
  std::vector<Pose2D> poses_;
  Pose2D own_;
  Time asked_ = never();
};

/// The rotation at a place in which the robot looks at the nearest border of the field that it can
/// see from there.
double towardsBorder(const Vector2d& place, const FieldDimensions& field);

}  // namespace gt
