#pragma once
#include <array>
#include <cmath>

#include "base/Geometry.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A measured bearing on a vertical edge of a landmark, seen from the camera (report 3.3.2.2).
struct Bearing {
  Vector2d landmark;   ///< Where the flag's axis or the goal's post stands on the field, in mm.
  double radius;       ///< Of the flag in mm: + its left edge, - its right edge, 0 a post.
  Vector2d direction;  ///< Unit vector to the edge, in the robot's system.
};

/// The bearings of one picture: two edges of each of six flags, two posts of each of two goals.
struct Bearings {
  std::array<Bearing, 16> list;
  int count = 0;

  void add(const Vector2d& landmark, double radius, double angle) {
    list[static_cast<std::size_t>(count++)] = {landmark, radius, direction(angle)};
  }
  const Bearing* begin() const { return list.data(); }
  const Bearing* end() const { return list.data() + count; }
};

/// Where a goal's front post stands that is seen at the left or at the right of the goal.
inline Vector2d positionOfPost(GoalColor color, bool left, TeamColor team,
                               const FieldDimensions& field) {
  const double side = color == ownGoal(team) ? -1 : 1;
  return {side * field.xGroundline, (left ? side : -side) * field.yGoal};
}

/// All edges that do not lie on the picture's border.
Bearings bearingsIn(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field);

/// atan2 by a polynomial, 1e-5 rad exact: the similarity (3.11) needs no more.
inline double fastAtan2(double y, double x) {
  const double ax = std::abs(x), ay = std::abs(y);
  const double larger = ax > ay ? ax : ay, smaller = ax > ay ? ay : ax;
  if (larger == 0) return 0;
  const double z = smaller / larger, z2 = z * z;
  double a =
      z * (0.9998660 + z2 * (-0.3302995 + z2 * (0.1801410 + z2 * (-0.0851330 + z2 * 0.0208351))));
  a = ay > ax ? pi / 2 - a : a;
  a = x < 0 ? pi - a : a;
  return y < 0 ? -a : a;
}

/// How far the measured bearing lies beside the one expected from a camera at `camera` on the
/// field, carried by a robot that looks along the unit vector `heading`; in [-pi, pi] (report
/// (3.10)).
inline double deviation(const Bearing& bearing, const Vector2d& camera, const Vector2d& heading) {
  const double vx = bearing.landmark.x() - camera.x(), vy = bearing.landmark.y() - camera.y();
  const double wx = heading.x() * vx + heading.y() * vy, wy = heading.x() * vy - heading.y() * vx;
  // asin(radius / distance) turns the flag's axis to its edge; as sine and cosine, both times the
  // distance.
  const double r = bearing.radius, squared = wx * wx + wy * wy - r * r;
  const double k = std::sqrt(squared > 0 ? squared : 0);
  const double ex = k * wx - r * wy, ey = k * wy + r * wx;
  const Vector2d& m = bearing.direction;
  return fastAtan2(ex * m.y() - ey * m.x(), ex * m.x() + ey * m.y());
}

}  // namespace gt
