#include "modules/modeling/selflocator/ParticleSet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "modules/modeling/selflocator/FastMath.h"

namespace gt {
namespace {

constexpr int cells = 10;

/// Numbers of particles in cells; the dimension of the rotation is circular.
struct Grid {
  std::array<std::int16_t, cells * cells * cells> counts{};

  static constexpr std::size_t index(int x, int y, int angle) {
    return static_cast<std::size_t>((x * cells + y) * cells + angle);
  }
  /// Each cell's count becomes the sum over a cube of two cells along each axis.
  void sumCubes() {
    const auto add = [](std::int16_t& to, std::int16_t count) {
      to = static_cast<std::int16_t>(to + count);
    };
    for (std::size_t row = 0; row < counts.size(); row += cells) {
      const std::int16_t first = counts[row];
      for (std::size_t i = row; i + 1 < row + cells; ++i) add(counts[i], counts[i + 1]);
      add(counts[row + cells - 1], first);
    }
    for (int x = 0; x < cells; ++x)
      for (std::size_t i = index(x, 0, 0); i < index(x, cells - 1, 0); ++i)
        add(counts[i], counts[i + cells]);
    for (std::size_t i = 0; i < index(cells - 1, 0, 0); ++i)
      add(counts[i], counts[i + cells * cells]);
  }
};

}  // namespace

Pose2D randomPose(const FieldDimensions& field, Random& random) {
  const double x = field.xGroundline * random.symmetric();
  const double y = field.ySideline * random.symmetric();
  return {pi * random.symmetric(), x, y};
}

template <typename Work>
void ParticleSet::forEachColumn(Work&& work) {
  for (std::vector<float>* column : {&x, &y, &cosine, &sine, &probability}) work(*column);
  for (const Likelihood kind : kinds_) work(likelihood[kind]);
}

void ParticleSet::resize(std::size_t size, const FieldDimensions& field, double probabilityOfNew,
                         Random& random) {
  const std::size_t before = this->size();
  if (size == before) return;
  forEachColumn([&](std::vector<float>& column) { column.resize(size); });
  noise_.resize(6 * size + 3);
  buffer_.resize(size);
  source_.resize(size);
  for (auto* column : {&cellX_, &cellY_, &cellAngle_}) column->resize(size);
  EnumArray<Likelihood, float> with;
  with.values.fill(static_cast<float>(probabilityOfNew));
  for (std::size_t i = before; i < size; ++i) replace(i, randomPose(field, random), with);
}

Pose2D ParticleSet::pose(std::size_t i) const {
  return {std::atan2(static_cast<double>(sine[i]), static_cast<double>(cosine[i])), x[i], y[i]};
}

void ParticleSet::replace(std::size_t i, const Pose2D& pose,
                          const EnumArray<Likelihood, float>& with) {
  x[i] = static_cast<float>(pose.translation.x());
  y[i] = static_cast<float>(pose.translation.y());
  cosine[i] = static_cast<float>(std::cos(pose.rotation));
  sine[i] = static_cast<float>(std::sin(pose.rotation));
  probability[i] = 1;
  for (const Likelihood kind : kinds_) {
    likelihood[kind][i] = with[kind];
    probability[i] *= with[kind];
  }
}

/// Fills columns with the report's random(-1...1), three numbers of 21 bits from each draw.
void ParticleSet::drawNoise(std::size_t columns, Random& random) {
  constexpr std::uint64_t mask = (1 << 21) - 1;
  constexpr float scale = 0x1p-20f;
  float* to = noise_.data();
  const float* const end = to + columns * size();
  for (; to < end; to += 3) {
    const std::uint64_t bits = random();
    for (int k = 0; k < 3; ++k)
      to[k] = static_cast<float>(static_cast<std::int32_t>(bits >> (21 * k) & mask)) * scale - 1;
  }
}

void ParticleSet::move(const Pose2D& step, const MotionModel& model, bool search,
                       const FieldDimensions& field, Random& random) {
  const double walked = step.translation.norm();
  const auto stepX = static_cast<float>(step.translation.x());
  const auto stepY = static_cast<float>(step.translation.y());
  const auto turnCosine = static_cast<float>(std::cos(step.rotation));
  const auto turnSine = static_cast<float>(std::sin(step.rotation));
  const auto errorX = static_cast<float>(model.forwardError * walked);
  const auto errorY = static_cast<float>(model.sidewardError * walked);
  const auto errorAngle = static_cast<float>(model.turnErrorByDistance * walked +
                                             model.turnErrorByAngle * std::abs(step.rotation));
  const auto far = static_cast<float>(search ? model.searchDistance : 0);
  const auto wide = static_cast<float>(search ? model.searchAngle : 0);
  const auto limitX = static_cast<float>(std::max(field.xGoalBack, field.xGroundline));
  const auto limitY = static_cast<float>(field.ySideline);

  drawNoise(search ? 6 : 3, random);
  const std::size_t n = size();
  const float* __restrict const noise = noise_.data();
  const float* __restrict const searching = noise_.data() + (search ? 3 * n : 0);
  const float* __restrict const p = probability.data();
  float* __restrict const xs = x.data();
  float* __restrict const ys = y.data();
  float* __restrict const cs = cosine.data();
  float* __restrict const ss = sine.data();
  for (std::size_t i = 0; i < n; ++i) {
    const float c = cs[i], s = ss[i], doubt = 1 - p[i];
    const float dx = stepX + errorX * noise[i], dy = stepY + errorY * noise[n + i];
    const float newX = xs[i] + c * dx - s * dy + far * doubt * searching[i];
    const float newY = ys[i] + s * dx + c * dy + far * doubt * searching[n + i];
    xs[i] = std::min(std::max(newX, -limitX), limitX);
    ys[i] = std::min(std::max(newY, -limitY), limitY);
    // A small turn by the tangent of its half: exactly a rotation, nearly by that angle.
    const float half = 0.5f * (errorAngle * noise[2 * n + i] + wide * doubt * searching[2 * n + i]);
    const float t = half + half * half * half / 3;
    const float tc = (1 - t * t) / (1 + t * t), ts = 2 * t / (1 + t * t);
    const float rc = turnCosine * tc - turnSine * ts, rs = turnSine * tc + turnCosine * ts;
    const float newC = c * rc - s * rs, newS = s * rc + c * rs;
    const float toUnit = 1.5f - 0.5f * (newC * newC + newS * newS);
    cs[i] = newC * toUnit;
    ss[i] = newS * toUnit;
  }
}

void ParticleSet::multiplyLikelihoods() {
  probability = likelihood[kinds_.front()];
  for (std::size_t k = 1; k < kinds_.size(); ++k) {
    const std::vector<float>& factor = likelihood[kinds_[k]];
    for (std::size_t i = 0; i < size(); ++i) probability[i] *= factor[i];
  }
}

void ParticleSet::resample(Random& random) {
  double sum = 0;
  for (const float p : probability) sum += p;
  if (sum <= 0) return;
  const double step = sum / static_cast<double>(size());
  // Equal steps through the sum of probabilities: the least variance that copying can have.
  double next = step * random.uniform(), reached = 0;
  std::size_t filled = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    reached += probability[i];
    for (; next < reached && filled < size(); next += step)
      source_[filled++] = static_cast<std::int32_t>(i);
  }
  while (filled < size()) source_[filled++] = static_cast<std::int32_t>(size() - 1);
  forEachColumn([&](std::vector<float>& column) {
    for (std::size_t i = 0; i < column.size(); ++i)
      buffer_[i] = column[static_cast<std::size_t>(source_[i])];
    column.swap(buffer_);
  });
}

EnumArray<Likelihood, float> ParticleSet::meanLikelihoods() const {
  EnumArray<Likelihood, float> means;
  means.values.fill(1);
  for (const Likelihood kind : kinds_) {
    double sum = 0;
    for (const float p : likelihood[kind]) sum += p;
    means[kind] = static_cast<float>(sum / static_cast<double>(size()));
  }
  return means;
}

void ParticleSet::assignCells(const FieldDimensions& field) {
  constexpr float half = cells / 2;
  const auto scaleX = half / static_cast<float>(std::max(field.xGoalBack, field.xGroundline));
  const auto scaleY = half / static_cast<float>(field.ySideline);
  constexpr float scaleAngle = half / static_cast<float>(pi);
  const auto cell = [](float scaled) {
    return std::min(std::max(static_cast<std::int32_t>(scaled + half), 0), cells - 1);
  };
  for (std::size_t i = 0; i < size(); ++i) {
    cellX_[i] = cell(x[i] * scaleX);
    cellY_[i] = cell(y[i] * scaleY);
    cellAngle_[i] = cell(fastAtan2(sine[i], cosine[i]) * scaleAngle);
  }
}

Cluster ParticleSet::largestCluster(const FieldDimensions& field) {
  assignCells(field);
  Grid grid;
  for (std::size_t i = 0; i < size(); ++i)
    ++grid.counts[Grid::index(cellX_[i], cellY_[i], cellAngle_[i])];
  grid.sumCubes();
  std::int16_t most = 0;
  for (const std::int16_t count : grid.counts) most = std::max(most, count);
  const auto best = static_cast<int>(std::find(grid.counts.begin(), grid.counts.end(), most) -
                                     grid.counts.begin());
  const int bestX = best / (cells * cells), bestY = best / cells % cells, bestAngle = best % cells;

  Cluster cluster;
  Vector2d position = Vector2d::Zero(), heading = Vector2d::Zero();
  double sum = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    if (cellX_[i] < bestX || cellX_[i] > bestX + 1) continue;
    if (cellY_[i] < bestY || cellY_[i] > bestY + 1) continue;
    if (cellAngle_[i] != bestAngle && cellAngle_[i] != (bestAngle + 1) % cells) continue;
    position += Vector2d{x[i], y[i]};
    heading += Vector2d{cosine[i], sine[i]};
    sum += probability[i];
    ++cluster.size;
  }
  if (cluster.size == 0) return cluster;
  cluster.pose = {std::atan2(heading.y(), heading.x()), position / cluster.size};
  cluster.validity = sum / static_cast<double>(size());
  return cluster;
}

}  // namespace gt
