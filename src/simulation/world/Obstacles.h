#pragma once
#include <vector>

#include "base/Geometry.h"
#include "simulation/scene/MuJoCo.h"

namespace gt {

/// How a disc on the ground overlaps something: where to push it, and how far (mm).
struct Overlap {
  Vector2d normal = Vector2d::Zero();
  double depth = 0;
};

/// What stands on the field and does not move (walls, goals, flags), seen from above: rectangles
/// and discs, from the model's geoms of group 2.
class Obstacles {
 public:
  Obstacles() = default;
  /// `data` has the poses of all geoms.
  Obstacles(const mjModel& model, const mjData& data);

  /// Pushes a disc out of all obstacles and calls touched(normal) for each that it touched.
  template <typename Touched>
  void pushOut(Vector2d& center, double radius, const Touched& touched) const {
    for (const Obstacle& obstacle : obstacles_) {
      Overlap overlap;
      if (!overlaps(obstacle, center, radius, overlap)) continue;
      center += overlap.depth * overlap.normal;
      touched(overlap.normal);
    }
  }

  /// How far it is from a point to the nearest obstacle (mm); 0 within one.
  double distanceTo(const Vector2d& point) const;

 private:
  struct Obstacle {
    Vector2d center;
    Vector2d half;  ///< For a disc: zero, its radius is in `round`.
    double cosine, sine;
    double round;
    double bound;

    /// A direction of the field in its own axes.
    Vector2d local(const Vector2d& d) const {
      return {cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x()};
    }
  };

  static bool overlaps(const Obstacle& obstacle, const Vector2d& center, double radius,
                       Overlap& overlap);

  std::vector<Obstacle> obstacles_;
};

/// How the first of two discs overlaps the second; equal centers are parted along x.
bool discsOverlap(const Vector2d& first, const Vector2d& second, double distance, Overlap& overlap);

}  // namespace gt
