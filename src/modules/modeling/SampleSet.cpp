#include "modules/modeling/SampleSet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modules/modeling/Bearings.h"

namespace gt {
namespace {

constexpr int cells = 10;

/// The place of a value in [-limit, limit] among the cells.
int cellOf(double value, double limit) {
  return std::clamp(static_cast<int>((value / limit + 1) * (cells / 2)), 0, cells - 1);
}

/// Numbers of samples in cells; the rotation is a circle.
struct Grid {
  std::array<int, cells * cells * cells> counts{};

  static constexpr std::size_t index(int x, int y, int angle) {
    return static_cast<std::size_t>((x * cells + y) * cells + angle);
  }
  static std::array<int, 3> cell(const Sample& sample, const FieldDimensions& field) {
    return {cellOf(sample.position.x(), field.xGoalBack),
            cellOf(sample.position.y(), field.ySideline),
            cellOf(fastAtan2(sample.heading.y(), sample.heading.x()), pi)};
  }
  /// Each cell's count becomes the sum over a cube of two cells along each axis.
  void sumCubes() {
    for (int row = 0; row < cells * cells; ++row) {
      int* line = counts.data() + row * cells;
      const int first = line[0];
      for (int i = 0; i + 1 < cells; ++i) line[i] += line[i + 1];
      line[cells - 1] += first;
    }
    for (int x = 0; x < cells; ++x)
      for (std::size_t i = index(x, 0, 0); i < index(x, cells - 1, 0); ++i)
        counts[i] += counts[i + cells];
    for (std::size_t i = 0; i < index(cells - 1, 0, 0); ++i) counts[i] += counts[i + cells * cells];
  }
};

}  // namespace

void Sample::turn(double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  heading = {c * heading.x() - s * heading.y(), s * heading.x() + c * heading.y()};
  heading /= heading.norm();
}

Pose2D randomPose(const FieldDimensions& field, Random& random) {
  const double x = field.xGroundline * random.symmetric();
  const double y = field.ySideline * random.symmetric();
  return {pi * random.symmetric(), x, y};
}

void resample(std::vector<Sample>& samples, std::vector<Sample>& buffer, Random& random) {
  double sum = 0;
  for (const Sample& sample : samples) sum += sample.probability;
  if (sum <= 0) return;
  const double step = sum / static_cast<double>(samples.size());
  buffer.resize(samples.size());
  // Equal steps through the sum of probabilities: the least variance that copying can have.
  double next = step * random.uniform(), reached = 0;
  std::size_t filled = 0;
  for (const Sample& sample : samples) {
    reached += sample.probability;
    for (; next < reached && filled < buffer.size(); next += step) buffer[filled++] = sample;
  }
  while (filled < buffer.size()) buffer[filled++] = samples.back();
  samples.swap(buffer);
}

Cluster largestCluster(const std::vector<Sample>& samples, const FieldDimensions& field) {
  Grid grid;
  for (const Sample& sample : samples) {
    const auto [x, y, angle] = Grid::cell(sample, field);
    ++grid.counts[Grid::index(x, y, angle)];
  }
  grid.sumCubes();
  const auto best = static_cast<int>(std::max_element(grid.counts.begin(), grid.counts.end()) -
                                     grid.counts.begin());
  const int bestX = best / (cells * cells), bestY = best / cells % cells, bestAngle = best % cells;

  Cluster cluster;
  Vector2d position = Vector2d::Zero(), heading = Vector2d::Zero();
  double probability = 0;
  for (const Sample& sample : samples) {
    const auto [x, y, angle] = Grid::cell(sample, field);
    if (x < bestX || x > bestX + 1 || y < bestY || y > bestY + 1) continue;
    if (angle != bestAngle && angle != (bestAngle + 1) % cells) continue;
    position += sample.position;
    heading += sample.heading;
    probability += sample.probability;
    ++cluster.size;
  }
  if (cluster.size == 0) return cluster;
  cluster.pose = {std::atan2(heading.y(), heading.x()), position / cluster.size};
  cluster.validity = probability / static_cast<double>(samples.size());
  return cluster;
}

}  // namespace gt
