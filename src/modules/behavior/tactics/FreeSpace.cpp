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

std::optional<AngleRange> freeGoalPart(const ObstaclesModel& obstacles, const Vector2d& from,
                                       const Vector2d& leftPost, const Vector2d& rightPost,
                                       double gap) {
  const Vector2d left = leftPost - from, right = rightPost - from;
  const double span = normalize(angleOf(left) - angleOf(right));
  if (span <= 0) return std::nullopt;
  // What stands in the goal or behind its line does not block; neither do posts and walls at it.
  const Vector2d line = left - right, inwards = Vector2d{line.y(), -line.x()}.normalized();
  const double lineAhead = inwards.dot(left);
  constexpr double atLine = 100;  // mm
  constexpr int steps = 60;
  std::array<bool, steps> blocked{};
  for (const ObstaclesModel::Sector& sector : obstacles.sectors) {
    const Vector2d to = sector.representative - from;
    if (!sector.obstacle || inwards.dot(to) > lineAhead - atLine || inwards.dot(to) <= 0) continue;
    const double half = std::asin(std::min(1., gap / 2 / std::max(to.norm(), 1.)));
    const double middle = normalize(angleOf(to) - angleOf(right));
    for (int i = 0; i < steps; ++i)
      if (std::abs((i + 0.5) / steps * span - middle) < half)
        blocked[static_cast<std::size_t>(i)] = true;
  }
  int best = 0, bestEnd = 0, length = 0;
  for (int i = 0; i < steps; ++i) {
    length = blocked[static_cast<std::size_t>(i)] ? 0 : length + 1;
    if (length > best) best = length, bestEnd = i + 1;
  }
  if (best == 0) return std::nullopt;
  const double step = span / steps;
  return AngleRange{normalize(angleOf(right) + (bestEnd - best / 2.) * step), best * step};
}

}  // namespace gt
