#include "modules/behavior/tactics/PlayValues.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gt {
namespace {

/// The four points of the grid around a ball, with their weights.
struct Around {
  std::array<std::size_t, 4> points{};
  std::array<double, 4> weights{};

  template <typename T>
  T mean(const std::vector<T>& values) const {
    T sum = values[points[0]] * weights[0];
    for (std::size_t i = 1; i < points.size(); ++i) sum += values[points[i]] * weights[i];
    return sum;
  }
};

/// Returns whether the lists fit the grid. Safe on any input.
bool isSound(const PlayValues& values) {
  return !values.empty() && values.check();
}

Around around(const PlayValues& values, const Vector2d& ball, const Vector2d& corner) {
  const auto onAxis = [](double share, int count) {
    const double at = share > 0 ? std::min(share, 1.) * (count - 1) : 0;  // also if it is no number
    const int first = std::min(static_cast<int>(at), count - 2);
    return std::pair{first, at - first};
  };
  const auto [column, right] = onAxis((ball.x() / corner.x() + 1) / 2, values.columns);
  const auto [row, up] = onAxis(std::abs(ball.y()) / corner.y(), values.rows);
  Around found;
  for (const int i : {0, 1})
    for (const int j : {0, 1}) {
      const auto k = static_cast<std::size_t>(2 * i + j);
      found.points[k] = static_cast<std::size_t>((column + i) * values.rows + row + j);
      found.weights[k] = (i ? right : 1 - right) * (j ? up : 1 - up);
    }
  return found;
}

Vector2d place(const PlayValues& values, const std::vector<Vector2d>& places, const Vector2d& ball,
               const Vector2d& corner) {
  if (!isSound(values)) return Vector2d::Zero();
  Vector2d found = around(values, ball, corner).mean(places);
  if (ball.y() < 0) found.y() = -found.y();
  return found;
}

}  // namespace

Result<void> PlayValues::check() const {
  if (empty()) return {};
  if (columns < 2 || rows < 2)
    return Error{.field = "columns", .what = "a grid has at least 2 x 2 points"};
  const auto points = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  const std::pair<const char*, std::size_t> lists[] = {{"ours", ours.size()},
                                                       {"theirs", theirs.size()},
                                                       {"ahead", ahead.size()},
                                                       {"behind", behind.size()}};
  for (const auto& [name, size] : lists)
    if (size != points)
      return Error{.field = name,
                   .what = "has " + std::to_string(size) + " elements; the grid has " +
                           std::to_string(points)};
  return {};
}

double PlayValues::worth(const Vector2d& ball, double lead, const Vector2d& corner) const {
  if (!isSound(*this)) return 0;
  const Around points = around(*this, ball, corner);
  const double share = 1 / (1 + std::exp(-lead / nearer));
  return share * points.mean(ours) + (1 - share) * points.mean(theirs);
}

Vector2d PlayValues::placeAhead(const Vector2d& ball, const Vector2d& corner) const {
  return place(*this, ahead, ball, corner);
}

Vector2d PlayValues::placeBehind(const Vector2d& ball, const Vector2d& corner) const {
  return place(*this, behind, ball, corner);
}

}  // namespace gt
