#pragma once
#include <vector>

#include "base/Geometry.h"
#include "simulation/scene/MuJoCo.h"

namespace gt {

/// The overlap of a disc on the ground with something: the direction in which to push the disc out
/// (unit vector), and the distance (mm).
struct Overlap {
  Vector2d normal = Vector2d::Zero();
  double depth = 0;
};

/// The immobile objects on the field (walls, goals, flags), seen from above: rectangles and discs,
/// from the model's geoms of group 2. Lengths are mm, on the field.
class Obstacles {
 public:
  Obstacles() = default;
  /// `data` must have the poses of all geoms.
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

  /// Distance from a point to the nearest obstacle (mm); 0 within one.
  double distanceTo(const Vector2d& point) const;

 private:
  struct Obstacle {
    Vector2d center;
    Vector2d half;        ///< Half of a rectangle's sides; zero for a disc.
    double cosine, sine;  ///< Of a rectangle's direction.
    double round;         ///< Radius of a disc; 0 for a rectangle.
    double bound;         ///< Radius of a circle around the obstacle.

    /// A direction of the field in its own axes.
    Vector2d local(const Vector2d& d) const {
      return {cosine * d.x() + sine * d.y(), cosine * d.y() - sine * d.x()};
    }
  };

  static bool overlaps(const Obstacle& obstacle, const Vector2d& center, double radius,
                       Overlap& overlap);

  std::vector<Obstacle> obstacles_;
};

/// Computes how the first of two discs overlaps the second; false if their centers are at least
/// `distance` (mm) apart. Discs with equal centers are pushed apart along x.
bool discsOverlap(const Vector2d& first, const Vector2d& second, double distance, Overlap& overlap);

}  // namespace gt
