#pragma once
#include <array>
#include <cmath>

#include "base/Geometry.h"
#include "modules/modeling/selflocator/FastMath.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A measured bearing on a vertical edge of a landmark, seen from the camera (report 3.3.2.2).
struct Bearing {
  Vector2d landmark;  ///< Position of the flag's axis or the goal's post on the field, in mm.
  /// Radius of the flag in mm; positive for its left edge, negative for its right edge, 0 for a
  /// post.
  double radius;
  Vector2d direction;  ///< Unit vector from the camera to the edge, in the robot's system.
};

/// The bearings of one image: two edges of each of six flags, two posts of each of two goals.
struct Bearings {
  std::array<Bearing, 16> list;
  int count = 0;

  void add(const Vector2d& landmark, double radius, double angle) {
    list[static_cast<std::size_t>(count++)] = {landmark, radius, direction(angle)};
  }
  const Bearing* begin() const { return list.data(); }
  const Bearing* end() const { return list.data() + count; }
};

/// Position (mm, on the field) of the front post that is seen at the left or at the right of a
/// goal.
inline Vector2d positionOfPost(GoalColor color, bool left, TeamColor team,
                               const FieldDimensions& field) {
  const double side = color == ownGoal(team) ? -1 : 1;
  return {side * field.xGroundline, (left ? side : -side) * field.yGoal};
}

/// The bearings of all edges that do not lie on the image's border.
Bearings bearingsIn(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field);

/// A bearing in single precision, for loops over particles.
struct BearingTerms {
  float landmarkX, landmarkY, radius, directionX, directionY;

  explicit BearingTerms(const Bearing& bearing)
      : landmarkX{static_cast<float>(bearing.landmark.x())},
        landmarkY{static_cast<float>(bearing.landmark.y())},
        radius{static_cast<float>(bearing.radius)},
        directionX{static_cast<float>(bearing.direction.x())},
        directionY{static_cast<float>(bearing.direction.y())} {}

  /// The difference (rad, in [-pi, pi]) between the measured bearing and the one expected from a
  /// camera at (x, y) on the field (mm), on a robot with the given cosine and sine of its rotation
  /// (report (3.10)).
  float deviation(float x, float y, float cosine, float sine) const {
    const float vx = landmarkX - x, vy = landmarkY - y;
    const float wx = cosine * vx + sine * vy, wy = cosine * vy - sine * vx;
    // asin(radius / distance) turns the flag's axis to its edge; as sine and cosine, both times the
    // distance.
    const float squared = wx * wx + wy * wy - radius * radius;
    const float k = std::sqrt(squared > 0 ? squared : 0);
    const float ex = k * wx - radius * wy, ey = k * wy + radius * wx;
    return fastAtan2(ex * directionY - ey * directionX, ex * directionX + ey * directionY);
  }
};

}  // namespace gt
