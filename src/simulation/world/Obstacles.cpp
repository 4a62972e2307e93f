#include "simulation/world/Obstacles.h"

#include <algorithm>
#include <limits>

namespace gt {

Obstacles::Obstacles(const mjModel& model, const mjData& data) {
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_group[geom] != 2 || model.body_weldid[model.geom_bodyid[geom]] != 0) continue;
    const int type = model.geom_type[geom];
    const mjtNum* size = model.geom_size + 3 * geom;
    const Matrix3d rotation = rotationFromMuJoCo(data.geom_xmat + 9 * geom);
    const double halfHeight = type == mjGEOM_BOX ? size[2] : size[1];
    // Only geoms that reach down to the height of robots and balls.
    if (data.geom_xpos[3 * geom + 2] - halfHeight > 0.05) continue;
    Obstacle obstacle;
    obstacle.center = fromMuJoCo(data.geom_xpos + 3 * geom).head<2>();
    obstacle.cosine = rotation(0, 0);
    obstacle.sine = rotation(1, 0);
    obstacle.half = type == mjGEOM_BOX ? Vector2d{1000 * size[0], 1000 * size[1]} : Vector2d{0, 0};
    obstacle.round = type == mjGEOM_BOX ? 0 : 1000 * size[0];
    obstacle.bound = obstacle.half.norm() + obstacle.round;
    obstacles_.push_back(obstacle);
  }
}

bool Obstacles::overlaps(const Obstacle& obstacle, const Vector2d& center, double radius,
                         Overlap& overlap) {
  const Vector2d d = center - obstacle.center;
  const double reach = radius + obstacle.bound;
  if (d.squaredNorm() >= reach * reach) return false;
  const Vector2d local = obstacle.local(d);
  const Vector2d nearest{std::clamp(local.x(), -obstacle.half.x(), obstacle.half.x()),
                         std::clamp(local.y(), -obstacle.half.y(), obstacle.half.y())};
  const Vector2d away = local - nearest;
  const double distance = away.norm();
  const double touching = radius + obstacle.round;
  if (distance >= touching) return false;
  Vector2d normal{1, 0};
  if (distance > 1e-9) {
    normal = away / distance;
    overlap.depth = touching - distance;
  } else {
    // The center lies inside: the disc is pushed out through the nearest side.
    const double outX = obstacle.half.x() - std::abs(local.x());
    const double outY = obstacle.half.y() - std::abs(local.y());
    if (outX < outY)
      normal = {local.x() < 0 ? -1. : 1., 0};
    else
      normal = {0, local.y() < 0 ? -1. : 1.};
    overlap.depth = touching + std::min(outX, outY);
  }
  overlap.normal = {obstacle.cosine * normal.x() - obstacle.sine * normal.y(),
                    obstacle.sine * normal.x() + obstacle.cosine * normal.y()};
  return true;
}

double Obstacles::distanceTo(const Vector2d& point) const {
  double nearest = std::numeric_limits<double>::max();
  for (const Obstacle& obstacle : obstacles_) {
    const Vector2d outside =
        (obstacle.local(point - obstacle.center).cwiseAbs() - obstacle.half).cwiseMax(0.);
    nearest = std::min(nearest, outside.norm() - obstacle.round);
  }
  return std::max(nearest, 0.);
}

bool discsOverlap(const Vector2d& first, const Vector2d& second, double distance,
                  Overlap& overlap) {
  const Vector2d d = first - second;
  const double squared = d.squaredNorm();
  if (squared >= distance * distance) return false;
  const double between = std::sqrt(squared);
  overlap.normal = between > 1e-9 ? Vector2d{d / between} : Vector2d{1, 0};
  overlap.depth = distance - between;
  return true;
}

}  // namespace gt
