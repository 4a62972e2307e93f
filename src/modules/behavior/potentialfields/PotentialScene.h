#pragma once
#include <optional>
#include <vector>

#include "base/Enum.h"
#include "modules/behavior/tactics/WorldState.h"
#include "representations/behavior/PotentialFields.h"

namespace gt {

/// Something on the field that draws or repels: points joined by straight lines, with a thickness.
struct PotentialShape {
  std::vector<Vector2d> points;
  bool closed = false;  ///< An area, counterclockwise; what is in it has a negative distance.
  double radius = 0;    ///< mm

  /// The nearest point of the outline, without the thickness.
  Vector2d nearest(const Vector2d& from) const;
  /// Whether a place lies in the area.
  bool contains(const Vector2d& place) const;
};

/// Where the objects are that rules are about, on the field.
struct PotentialScene {
  EnumArray<PotentialObject, std::vector<PotentialShape>> objects;

  /// The objects of the world, all but the target. The obstacles are given relative to the robot.
  static PotentialScene of(const WorldState& world, const ObstaclesModel& obstacles,
                           const Vector2d& ball);
  void setTarget(const Vector2d& target) { objects[PotentialObject::target] = {{{target}}}; }
  Vector2d target() const { return objects[PotentialObject::target].front().points.front(); }

  /// The force of a rule at a place, over all its objects.
  Vector2d force(const PotentialRule& rule, const Vector2d& at) const;
  /// How strong it is at a place: the strongest force of one of its objects.
  double strength(const PotentialRule& rule, const Vector2d& at) const;
  /// The superposed forces of a field at a place.
  Vector2d force(const PotentialField& field, const Vector2d& at) const;
};

}  // namespace gt
