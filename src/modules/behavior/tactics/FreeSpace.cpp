#include "modules/behavior/tactics/FreeSpace.h"

#include <algorithm>

namespace gt {

double corridor(const ObstaclesModel& obstacles, double direction, double width,
                const Vector2d& from) {
  const Vector2d along = gt::direction(direction);
  double free = ObstaclesModel::farAway;
  for (const ObstaclesModel::Sector& sector : obstacles.sectors) {
    if (!sector.obstacle) continue;
    const Vector2d to = sector.representative - from;
    const double aside = along.x() * to.y() - along.y() * to.x(), ahead = along.dot(to);
    if (std::abs(aside) < width / 2 && ahead > 0) free = std::min(free, ahead);
  }
  return free;
}

std::optional<double> freeDirection(const ObstaclesModel& obstacles, double wanted, double width,
                                    double length, double most, const Vector2d& from) {
  for (double off = 0; off <= most; off += ObstaclesModel::sectorWidth / 2)
    for (const double side : {1., -1.})
      if (corridor(obstacles, wanted + side * off, width, from) >= length)
        return normalize(wanted + side * off);
  return std::nullopt;
}

double nearestObstacle(const ObstaclesModel& obstacles, double middle, double halfRange) {
  double nearest = ObstaclesModel::farAway;
  for (const ObstaclesModel::Sector& sector : obstacles.sectors)
    if (sector.obstacle &&
        std::abs(normalize(angleOf(sector.representative) - middle)) <= halfRange)
      nearest = std::min(nearest, sector.representative.norm());
  return nearest;
}

}  // namespace gt
