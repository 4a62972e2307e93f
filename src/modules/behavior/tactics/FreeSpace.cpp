#include "representations/modeling/ObstaclesModel.h"

#include <algorithm>

namespace gt {
namespace {

constexpr double sectorWidth = 2 * pi / ObstaclesModel::numberOfSectors;

}  // namespace

int ObstaclesModel::sectorOf(double angle) {
  const int sector = static_cast<int>((normalize(angle) + pi) / sectorWidth);
  return std::clamp(sector, 0, numberOfSectors - 1);
}

double ObstaclesModel::middleOf(int sector) {
  return (sector + 0.5) * sectorWidth - pi;
}

void ObstaclesModel::enter(const Vector2d& place, bool obstacle, Time seen) {
  Sector& known = sectors[static_cast<std::size_t>(sectorOf(place))];
  const bool yields =
      known.obstacle != obstacle
          ? obstacle || known.lastSeen == never()
          : known.lastSeen == never() || place.squaredNorm() < known.representative.squaredNorm();
  if (yields) known = {place, obstacle, seen};
}

std::optional<Vector2d> ObstaclesModel::nearest(AngleRange range) const {
  std::optional<Vector2d> best;
  double distance = farAway;
  for (const Sector& sector : sectors) {
    if (!sector.obstacle || sector.representative.norm() >= distance) continue;
    if (std::abs(normalize(angleOf(sector.representative) - range.middle)) > range.width / 2)
      continue;
    best = sector.representative;
    distance = best->norm();
  }
  return best;
}

double ObstaclesModel::corridor(double direction, double width, const Vector2d& from) const {
  const Vector2d along = gt::direction(direction);
  double free = farAway;
  for (const Sector& sector : sectors) {
    if (!sector.obstacle) continue;
    const Vector2d to = sector.representative - from;
    const double aside = along.x() * to.y() - along.y() * to.x(), ahead = along.dot(to);
    if (std::abs(aside) < width / 2 && ahead > 0) free = std::min(free, ahead);
  }
  return free;
}

std::optional<double> ObstaclesModel::freeDirection(double wanted, double width, double length,
                                                    double most, const Vector2d& from) const {
  for (double off = 0; off <= most; off += sectorWidth / 2)
    for (const double side : {1., -1.})
      if (corridor(wanted + side * off, width, from) >= length)
        return normalize(wanted + side * off);
  return std::nullopt;
}

std::optional<AngleRange> ObstaclesModel::freeGoalPart(const Vector2d& from,
                                                       const Vector2d& leftPost,
                                                       const Vector2d& rightPost,
                                                       double gap) const {
  const Vector2d left = leftPost - from, right = rightPost - from;
  const double span = normalize(angleOf(left) - angleOf(right));
  if (span <= 0) return std::nullopt;
  // What stands in the goal or behind its line does not block; neither do posts and walls at it.
  const Vector2d line = left - right, inwards = Vector2d{line.y(), -line.x()}.normalized();
  const double lineAhead = inwards.dot(left);
  constexpr double atLine = 100;  // mm
  constexpr int steps = 60;
  std::array<bool, steps> blocked{};
  for (const Sector& sector : sectors) {
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

double ObstaclesModel::kickAngle(const Vector2d& from, const Vector2d& leftPost,
                                 const Vector2d& rightPost, double gap, double length) const {
  if (const auto part = freeGoalPart(from, leftPost, rightPost, gap)) return part->middle;
  const double wanted = angleOf((leftPost + rightPost) / 2 - from);
  return freeDirection(wanted, gap, length, pi / 2, from).value_or(wanted);
}

}  // namespace gt
