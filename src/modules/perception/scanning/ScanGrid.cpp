#include "modules/perception/scanning/ScanGrid.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

/// Shrinks [low, high] to where base + t * direction lies in [0, size]; returns whether the ends
/// were moved.
void clip(double base, double direction, double size, double& low, double& high, bool& lowMoved,
          bool& highMoved) {
  if (std::abs(direction) < 1e-9) {
    if (base < 0 || base >= size) high = low - 1;
    return;
  }
  double first = (0 - base) / direction, last = (size - base) / direction;
  if (first > last) std::swap(first, last);
  if (first > low) {
    low = first;
    lowMoved = true;
  }
  if (last < high) {
    high = last;
    highMoved = true;
  }
}

}  // namespace

int stepsInImage(const CameraInfo& info, const Vector2d& start, const Vector2d& step) {
  constexpr double rounded = 0.01;  // pixels, by which a walk may be off at its end
  if (!info.contains(start.x(), start.y())) return 0;
  double last = info.width + info.height;  // no line in the image is longer
  const auto limit = [&](double from, double by, double size) {
    if (by > 0) last = std::min(last, (size - rounded - from) / by);
    if (by < 0) last = std::min(last, (rounded - from) / by);
  };
  limit(start.x(), step.x(), info.width);
  limit(start.y(), step.y(), info.height);
  return 1 + static_cast<int>(std::max(0., last));
}

ScanLine clippedLine(const CameraInfo& info, const Vector2d& base, const Vector2d& direction,
                     double low, double high) {
  ScanLine line;
  clip(base.x(), direction.x(), info.width, low, high, line.fromBorder, line.toBorder);
  clip(base.y(), direction.y(), info.height, low, high, line.fromBorder, line.toBorder);
  if (!(low < high)) return line;
  // One step is one pixel along the axis that the line is closer to; steps meet pixel centers.
  const int major = std::abs(direction.x()) > std::abs(direction.y()) ? 0 : 1;
  const double forward = direction[major] > 0 ? 1 : -1;
  line.step = direction / std::abs(direction[major]);
  const double from = base[major] + low * direction[major];
  const double to = base[major] + high * direction[major];
  const double first = forward > 0 ? std::ceil(from - 0.5) + 0.5 : std::floor(from + 0.5) - 0.5;
  const double last = forward > 0 ? std::floor(to - 0.5) + 0.5 : std::ceil(to + 0.5) - 0.5;
  line.start = base + direction * ((first - base[major]) / direction[major]);
  line.start[major] = first;
  line.length = std::max(0, static_cast<int>((last - first) * forward + 1.5));
  // Rounding must not lead across the border along the other axis.
  const auto inside = [&](int i) {
    const Vector2d p = line.at(i);
    return info.contains(p.x(), p.y());
  };
  while (line.length > 0 && !inside(line.length - 1)) --line.length;
  while (line.length > 0 && !inside(0)) {
    line.start += line.step;
    --line.length;
  }
  return line;
}

void ScanGrid::build(const CameraInfo& info, const Horizon& horizon, const GridSpacing& spacing) {
  lines_.clear();
  const double diagonal = std::hypot(info.width, info.height);
  const Vector2d center = horizon.fromImage({info.width / 2.0, info.height / 2.0});
  const int n = static_cast<int>(diagonal / (2 * spacing.dense));
  for (int k = -n; k <= n; ++k) {
    const double u = center.x() + k * spacing.dense;
    const double own = spacing.dense * (k % 4 == 0 ? 4 : k % 2 == 0 ? 2 : 1);
    const bool whole = k % 4 == 0;
    const double low = whole ? -1e6 : -own * spacing.reachUp;
    const double high = whole ? 1e6 : own * spacing.reachDown;
    ScanLine line = clippedLine(info, horizon.toPicture(u, 0), horizon.down, low, high);
    line.u = u;
    line.whole = whole;
    if (line.length >= 4) lines_.push_back(line);
  }
  // Rows get rarer where a pixel is less of the ground.
  rows_.clear();
  double way = 1;
  for (double v = 5 * spacing.dense; v < diagonal; v *= 1.7, way = -way) {
    const ScanLine row = clippedLine(info, horizon.toPicture(center.x(), v), way * horizon.along,
                                     -diagonal, diagonal);
    if (row.length >= 4) rows_.push_back(row);
  }
}

}  // namespace gt
