#include "modules/behavior/potentialfields/FieldPilot.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <queue>
#include <utility>

namespace gt {
namespace {

/// Number of steps of the path in which progress is checked: a path without progress is stuck.
constexpr std::size_t watchedSteps = 15;
/// Least progress, as a share of these steps' length.
constexpr double leastProgress = 0.2;
/// Weight of the previous step's direction in that of a step. Without it the path would oscillate
/// where a repulsion ends.
constexpr double inertia = 0.5;

/// A rectangle of cells on the field that contains all objects.
struct Grid {
  Vector2d origin = Vector2d::Zero();
  double cell = 1;
  int width = 0, height = 0;

  Grid(const PotentialScene& scene, const Vector2d& from, double size) : cell{size} {
    Vector2d low = from, high = from;
    for (const auto& shapes : scene.objects.values)
      for (const PotentialShape& shape : shapes)
        for (const Vector2d& point : shape.points) {
          low = low.cwiseMin(point);
          high = high.cwiseMax(point);
        }
    constexpr double margin = 400;  // mm: a way round what is at the end
    origin = low - Vector2d{margin, margin};
    width = static_cast<int>((high.x() - low.x() + 2 * margin) / cell) + 1;
    height = static_cast<int>((high.y() - low.y() + 2 * margin) / cell) + 1;
  }
  int of(const Vector2d& place) const {
    const Vector2d at = (place - origin) / cell;
    return static_cast<int>(at.y()) * width + static_cast<int>(at.x());
  }
  Vector2d middle(int index) const {
    return origin + cell * Vector2d{index % width + 0.5, index / width + 0.5};
  }
  std::size_t cells() const { return static_cast<std::size_t>(width * height); }
};

}  // namespace

Vector2d FieldPilot::update(const PotentialField& field, PotentialScene scene, const Vector2d& from,
                            const Parameters& parameters) {
  field_ = field;
  scene_ = std::move(scene);
  parameters_ = parameters;
  walkAhead(from);
  leavesMinimum_ = !arrives_ && parameters_.repulsionCost > 0 && reachable();
  if (leavesMinimum_) planByWave(from);
  return onPath();
}

PotentialField FieldPilot::part(PotentialEffect effect) const {
  PotentialField part;
  std::ranges::copy_if(field_.rules, std::back_inserter(part.rules),
                       [&](const PotentialRule& rule) { return rule.effect == effect; });
  return part;
}

bool FieldPilot::reachable() const {
  double attraction = 0;
  for (const PotentialRule& rule : part(PotentialEffect::attract).rules)
    attraction = std::max(attraction, rule.strength);
  return std::ranges::all_of(part(PotentialEffect::repel).rules, [&](const PotentialRule& rule) {
    return scene_.strength(rule, scene_.target()) < attraction;
  });
}

void FieldPilot::walkAhead(const Vector2d& from) {
  const Vector2d target = scene_.target();
  path_ = {from};
  arrives_ = false;
  const auto most = static_cast<std::size_t>(parameters_.longest / parameters_.step);
  while (path_.size() <= most) {
    const Vector2d at = path_.back();
    arrives_ = (target - at).norm() <= parameters_.arrival;
    if (arrives_) return;
    const Vector2d force = scene_.force(field_, at);
    const double strength = force.norm();
    if (strength < 1e-6) return;
    Vector2d way = (1 - inertia) / strength * force;
    if (path_.size() > 1) way += inertia / parameters_.step * (at - path_[path_.size() - 2]);
    path_.push_back(at + parameters_.step / std::max(way.norm(), 1e-6) * way);
    if (path_.size() > watchedSteps &&
        (path_.back() - path_[path_.size() - 1 - watchedSteps]).norm() <
            leastProgress * parameters_.step * static_cast<double>(watchedSteps))
      return;
  }
}

// Dijkstra's algorithm from the target, which yields for each cell the next one on the path to the
// target.
void FieldPilot::planByWave(const Vector2d& from) {
  const Grid grid{scene_, from, parameters_.cell};
  const PotentialField repulsion = part(PotentialEffect::repel);
  constexpr double unknown = -1, far = std::numeric_limits<double>::max();
  std::vector<double> costs(grid.cells(), unknown), distances(grid.cells(), far);
  std::vector<int> next(grid.cells(), -1);
  const auto cost = [&](int cell) {
    double& known = costs[static_cast<std::size_t>(cell)];
    if (known == unknown) {
      double sum = 0;  // forces from both sides add here, in place of compensating each other
      for (const PotentialRule& rule : repulsion.rules)
        sum += scene_.strength(rule, grid.middle(cell));
      known = 1 + parameters_.repulsionCost * sum;
    }
    return known;
  };
  using Entry = std::pair<double, int>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> wave;
  const int start = grid.of(from), target = grid.of(scene_.target());
  distances[static_cast<std::size_t>(target)] = 0;
  wave.emplace(0, target);
  while (!wave.empty()) {
    const auto [distance, cell] = wave.top();
    wave.pop();
    if (cell == start) break;
    if (distance > distances[static_cast<std::size_t>(cell)]) continue;
    const int x = cell % grid.width, y = cell / grid.width;
    for (int dy = -1; dy <= 1; ++dy)
      for (int dx = -1; dx <= 1; ++dx) {
        if ((dx == 0 && dy == 0) || x + dx < 0 || x + dx >= grid.width || y + dy < 0 ||
            y + dy >= grid.height)
          continue;
        const int other = cell + dy * grid.width + dx;
        const double there = distance + std::hypot(dx, dy) * (cost(cell) + cost(other)) / 2;
        if (there >= distances[static_cast<std::size_t>(other)]) continue;
        distances[static_cast<std::size_t>(other)] = there;
        next[static_cast<std::size_t>(other)] = cell;
        wave.emplace(there, other);
      }
  }
  path_ = {from};
  for (int cell = next[static_cast<std::size_t>(start)]; cell >= 0 && cell != target;
       cell = next[static_cast<std::size_t>(cell)])
    path_.push_back(grid.middle(cell));
  path_.push_back(scene_.target());
  arrives_ = true;
}

Vector2d FieldPilot::onPath() const {
  const Vector2d& from = path_.front();
  Vector2d way = Vector2d::Zero();
  for (const Vector2d& point : path_) {
    way = point - from;
    if (way.norm() >= parameters_.lookAhead) break;
  }
  const double distance = way.norm();
  if (distance == 0) return Vector2d::Zero();
  // On a planned path the forces may be balanced: the target alone decides on the speed.
  const double strength = (leavesMinimum_ ? scene_.force(part(PotentialEffect::attract), from)
                                          : scene_.force(field_, from))
                              .norm();
  return strength / distance * way;
}

void FieldPilot::draw(Canvas& canvas, const FieldDimensions& field) const {
  constexpr double grid = 150, longestArrow = 110;  // mm
  const Color arrows{120, 120, 120}, path{220, 30, 30};
  const auto columns = static_cast<int>(2 * field.xGroundline / grid),
             rows = static_cast<int>(2 * field.ySideline / grid);
  for (int column = 0; column < columns; ++column)
    for (int row = 0; row < rows; ++row) {
      const Vector2d at{(column + 0.5) * grid - field.xGroundline,
                        (row + 0.5) * grid - field.ySideline};
      const Vector2d force = scene_.force(field_, at);
      const double strength = force.norm();
      if (strength < 1e-6) continue;
      const Vector2d half = force / strength * longestArrow * std::min(1., strength) / 2;
      canvas.arrow(at - half, at + half, arrows, 4);
    }
  canvas.path(path_, path, 10);
  canvas.cross(scene_.target(), 60, path, 15);
}

}  // namespace gt
