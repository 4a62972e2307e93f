#pragma once
#include <optional>
#include <vector>

#include "base/Enum.h"
#include "modules/behavior/tactics/WorldState.h"
#include "representations/behavior/PotentialFields.h"

namespace gt {

/// An object on the field that attracts or repels: points (mm) joined by straight lines, with a
/// thickness.
struct PotentialShape {
  std::vector<Vector2d> points;
  bool closed = false;  ///< Whether it is an area, counterclockwise; distances are negative inside.
  double radius = 0;    ///< Half of the thickness, mm.

  /// The nearest point of the outline, without the thickness.
  Vector2d nearest(const Vector2d& from) const;
  /// Whether a place (mm) lies in the area.
  bool contains(const Vector2d& place) const;
};

/// The positions on the field (mm) of the objects to which rules apply.
struct PotentialScene {
  EnumArray<PotentialObject, std::vector<PotentialShape>> objects;

  /// The scene with all objects of the world except the target. `obstacles` are relative to the
  /// robot, `ball` is on the field (mm).
  static PotentialScene of(const WorldState& world, const ObstaclesModel& obstacles,
                           const Vector2d& ball);
  void setTarget(const Vector2d& target) { objects[PotentialObject::target] = {{{target}}}; }
  Vector2d target() const { return objects[PotentialObject::target].front().points.front(); }

  /// The force of a rule at a place, over all its objects.
  Vector2d force(const PotentialRule& rule, const Vector2d& at) const;
  /// The strength of a rule at a place: that of the strongest force of its objects.
  double strength(const PotentialRule& rule, const Vector2d& at) const;
  /// The superposed forces of a field at a place.
  Vector2d force(const PotentialField& field, const Vector2d& at) const;
};

}  // namespace gt
