#include "modules/perception/calibration/CheckerboardFinder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

namespace gt {
namespace {

constexpr int reach = 4;          // Pixels: radius of the ring around a corner.
constexpr double minShare = 0.3;  // Of the best corner's response.
constexpr int minResponse = 150;  // On the ring, of the y channel.
constexpr double mostOff = 0.35;  // Of a square's edge: how far a corner lies from where it should.

// Sixteen places on a ring of that radius.
constexpr std::array<std::array<int, 2>, 16> ring{{{0, 4},
                                                   {2, 4},
                                                   {3, 3},
                                                   {4, 2},
                                                   {4, 0},
                                                   {4, -2},
                                                   {3, -3},
                                                   {2, -4},
                                                   {0, -4},
                                                   {-2, -4},
                                                   {-3, -3},
                                                   {-4, -2},
                                                   {-4, 0},
                                                   {-4, 2},
                                                   {-3, 3},
                                                   {-2, 4}}};

}  // namespace

bool CheckerboardFinder::find(const Image& image, const Horizon& horizon, const Checkerboard& board,
                              std::vector<Vector2d>& corners) {
  corners.clear();
  candidates_.clear();
  measure(image);
  collect(image);
  const auto count = static_cast<std::size_t>(board.columns) * static_cast<std::size_t>(board.rows);
  if (candidates_.size() < count || !grow(horizon) || places_.size() != count) return false;
  int left = 0, top = 0;
  for (const Place& place : places_) {
    left = std::min(left, place.column);
    top = std::min(top, place.row);
  }
  corners.resize(count);
  for (const Place& place : places_) {
    const int column = place.column - left, row = place.row - top;
    // As many corners as there should be, but in another shape.
    if (column >= board.columns || row >= board.rows) return false;
    corners[static_cast<std::size_t>(row * board.columns + column)] =
        refine(image, candidates_[place.candidate]);
  }
  return true;
}

// At a corner, opposite places of the ring are alike and differ from those a quarter turn further.
// At edges, opposite places differ; at lines, places differ from the middle.
void CheckerboardFinder::measure(const Image& image) {
  const int width = image.info.width, height = image.info.height;
  response_.assign(image.area(), 0);
  for (int y = reach; y < height - reach; ++y)
    for (int x = reach; x < width - reach; ++x) {
      const auto at = [&](std::size_t i) {
        return static_cast<int>(image.at(x + ring[i][0], y + ring[i][1]).y);
      };
      int sum = 0, difference = 0, total = 0;
      for (std::size_t i = 0; i < 4; ++i)
        sum += std::abs(at(i) + at(i + 8) - at(i + 4) - at(i + 12));
      for (std::size_t i = 0; i < 8; ++i) difference += std::abs(at(i) - at(i + 8));
      for (std::size_t i = 0; i < 16; ++i) total += at(i);
      int middle = 0;
      for (const auto& [dx, dy] : {std::pair{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}})
        middle += image.at(x + dx, y + dy).y;
      // 16 times the difference between the means of ring and middle.
      const int off = std::abs(total - 16 * middle / 5);
      response_[static_cast<std::size_t>(y * width + x)] = sum - difference - off;
    }
}

void CheckerboardFinder::collect(const Image& image) {
  constexpr int alone = 3;  // Pixels around a corner in which there is no other.
  constexpr std::size_t most = 1000;
  const int width = image.info.width, height = image.info.height;
  const auto at = [&](int x, int y) { return response_[static_cast<std::size_t>(y * width + x)]; };
  const int best = response_.empty() ? 0 : *std::max_element(response_.begin(), response_.end());
  const int least = std::max(minResponse, static_cast<int>(minShare * best));
  for (int y = reach; y < height - reach; ++y)
    for (int x = reach; x < width - reach && candidates_.size() < most; ++x) {
      const int own = at(x, y);
      if (own < least) continue;
      bool highest = true;
      for (int dy = -alone; dy <= alone && highest; ++dy)
        for (int dx = -alone; dx <= alone && highest; ++dx) {
          const int px = x + dx, py = y + dy;
          if (px < 0 || py < 0 || px >= width || py >= height) continue;
          // Of two that are the same the first one counts.
          const bool before = dy < 0 || (dy == 0 && dx < 0);
          highest = before ? at(px, py) < own : at(px, py) <= own;
        }
      if (highest) candidates_.emplace_back(x + 0.5, y + 0.5);
    }
}

// At a corner each gradient around it is perpendicular to the direction there.
Vector2d CheckerboardFinder::refine(const Image& image, Vector2d corner) {
  constexpr int iterations = 4;
  constexpr double sigma = 2;
  const Vector2d first = corner;
  for (int i = 0; i < iterations; ++i) {
    const int cx = static_cast<int>(corner.x()), cy = static_cast<int>(corner.y());
    Eigen::Matrix2d a = Eigen::Matrix2d::Zero();
    Vector2d b = Vector2d::Zero();
    for (int y = std::max(cy - reach, 1); y <= std::min(cy + reach, image.info.height - 2); ++y)
      for (int x = std::max(cx - reach, 1); x <= std::min(cx + reach, image.info.width - 2); ++x) {
        const Vector2d gradient{(image.at(x + 1, y).y - image.at(x - 1, y).y) / 2.0,
                                (image.at(x, y + 1).y - image.at(x, y - 1).y) / 2.0};
        const Vector2d p{x + 0.5, y + 0.5};
        const double weight = std::exp(-(p - corner).squaredNorm() / (2 * sigma * sigma));
        const Eigen::Matrix2d g = weight * gradient * gradient.transpose();
        a += g;
        b += g * p;
      }
    const double determinant = a.determinant();
    if (std::abs(determinant) < 1e-6) break;
    corner = Vector2d{a(1, 1) * b.x() - a(0, 1) * b.y(), a(0, 0) * b.y() - a(1, 0) * b.x()} /
             determinant;
    if ((corner - first).norm() > 2) return first;
  }
  return corner;
}

/// The candidate that lies at an offset, or null.
const Vector2d* CheckerboardFinder::nearest(const Vector2d& from, const Vector2d& offset) const {
  const Vector2d* best = nullptr;
  double least = mostOff * offset.norm();
  for (const Vector2d& candidate : candidates_) {
    const double off = (candidate - from - offset).norm();
    if (off >= least) continue;
    least = off;
    best = &candidate;
  }
  return best;
}

// Starts from the corner in the middle, with an estimate of where its neighbors on the right and
// below are.
bool CheckerboardFinder::grow(const Horizon& horizon) {
  Vector2d middle = Vector2d::Zero();
  for (const Vector2d& candidate : candidates_)
    middle += candidate / static_cast<double>(candidates_.size());
  const auto seed = static_cast<std::size_t>(
      std::min_element(candidates_.begin(), candidates_.end(),
                       [&](const Vector2d& a, const Vector2d& b) {
                         return (a - middle).squaredNorm() < (b - middle).squaredNorm();
                       }) -
      candidates_.begin());
  const auto neighbor = [&](const Vector2d& direction) {
    Vector2d best = Vector2d::Zero();
    for (const Vector2d& candidate : candidates_) {
      const Vector2d way = candidate - candidates_[seed];
      // Within 35 degrees, on either side.
      if (std::abs(way.dot(direction)) < 0.82 * way.norm() || way.norm() == 0) continue;
      if (best.norm() == 0 || way.norm() < best.norm())
        best = way.dot(direction) > 0 ? way : Vector2d{-way};
    }
    return best;
  };
  const Vector2d right = neighbor(horizon.along), down = neighbor(horizon.down);
  if (right.norm() == 0 || down.norm() == 0) return false;
  used_.assign(candidates_.size(), false);
  used_[seed] = true;
  places_.assign(1, Place{seed, 0, 0, right, down});
  for (std::size_t i = 0; i < places_.size(); ++i) {
    const Place place = places_[i];
    step(place, 1, 0);
    step(place, -1, 0);
    step(place, 0, 1);
    step(place, 0, -1);
  }
  return true;
}

// The offset to the next corner is about the same as to the last one.
void CheckerboardFinder::step(const Place& from, int columns, int rows) {
  const Vector2d& start = candidates_[from.candidate];
  const Vector2d* next = nearest(start, columns * from.right + rows * from.down);
  if (!next) return;
  const auto candidate = static_cast<std::size_t>(next - candidates_.data());
  if (used_[candidate]) return;
  used_[candidate] = true;
  Place place{candidate, from.column + columns, from.row + rows, from.right, from.down};
  if (columns != 0) place.right = columns * (*next - start);
  if (rows != 0) place.down = rows * (*next - start);
  places_.push_back(place);
}

}  // namespace gt
