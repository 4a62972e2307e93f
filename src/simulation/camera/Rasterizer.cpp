#include "simulation/camera/Rasterizer.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

namespace gt {
namespace {

constexpr int lanes = 4;
using Floats = float __attribute__((vector_size(16)));
using Ints = std::int32_t __attribute__((vector_size(16)));

template <typename V, typename T>
V load(const T* from) {
  V v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
template <typename V, typename T>
void store(T* to, V v) {
  std::memcpy(to, &v, sizeof v);
}
/// In each lane a where the mask is set, otherwise b.
template <typename V>
V choose(Ints mask, V a, V b) {
  return std::bit_cast<V>((mask & std::bit_cast<Ints>(a)) | (~mask & std::bit_cast<Ints>(b)));
}

int ceiling(float v) {
  const int i = static_cast<int>(v);
  return i + (v > static_cast<float>(i));
}
/// The first pixel (row) whose center does not lie before a place.
int pixelFrom(float v) {
  return ceiling(v - 0.5f);
}

}  // namespace

void Rasterizer::begin(int width, int height, PackedColor background, bool withGeoms) {
  width_ = width;
  height_ = height;
  stride_ = (width + lanes - 1) / lanes * lanes;
  withGeoms_ = withGeoms;
  const std::size_t size = offset(height);
  colors_.assign(size, background);
  inverseDepth_.assign(size, 0.0f);
  if (withGeoms) geoms_.assign(size, -1);
  for (auto* values : {&left_, &right_, &rowInverseDepth_, &perPixel_})
    values->resize(static_cast<std::size_t>(height));
  for (auto* pixels : {&from_, &to_}) pixels->resize(static_cast<std::size_t>(height));
}

void Rasterizer::fill(const ScreenPoint* points, int count, const ScreenPlane& plane,
                      PackedColor color) {
  float top = points[0].y, bottom = top, leftmost = points[0].x, rightmost = leftmost;
  for (int i = 1; i < count; ++i) {
    top = std::min(top, points[i].y);
    bottom = std::max(bottom, points[i].y);
    leftmost = std::min(leftmost, points[i].x);
    rightmost = std::max(rightmost, points[i].x);
  }
  const int first = std::max(0, pixelFrom(top)), end = std::min(height_, pixelFrom(bottom));
  if (first >= end || pixelFrom(leftmost) >= std::min(width_, pixelFrom(rightmost)) ||
      rightmost < 0)
    return;
  for (int i = 0, j = count - 1; i < count; j = i++)
    addEdge(points[j], points[i], plane.clockwise, first, end);
  measureRows(first, end, plane);
  if (hasDepth_)
    withGeoms_ ? fillRows<true, true>(first, end, color) : fillRows<true, false>(first, end, color);
  else
    withGeoms_ ? fillRows<false, true>(first, end, color)
               : fillRows<false, false>(first, end, color);
}

void Rasterizer::addEdge(const ScreenPoint& a, const ScreenPoint& b, bool clockwise, int first,
                         int end) {
  const bool down = a.y < b.y;
  // Always from above, so that neighbors agree on the points of their common edge.
  const ScreenPoint& upper = down ? a : b;
  const ScreenPoint& lower = down ? b : a;
  const int from = std::max(first, pixelFrom(upper.y)), to = std::min(end, pixelFrom(lower.y));
  if (from >= to) return;
  const float slope = (lower.x - upper.x) / (lower.y - upper.y);
  float* const side = down == clockwise ? right_.data() : left_.data();
  float row = static_cast<float>(from) + 0.5f - upper.y;
  for (int y = from; y < to; ++y, ++row) side[y] = upper.x + row * slope;
}

// For all rows at once, so that the processor works on several of them at a time.
void Rasterizer::measureRows(int first, int end, const ScreenPlane& plane) {
  const float limit = static_cast<float>(width_);
  const auto bounded = [limit](float v) { return std::max(0.0f, std::min(v, limit)); };
  const auto n = static_cast<std::size_t>(end - first), skipped = static_cast<std::size_t>(first);
  const float *left = left_.data() + skipped, *right = right_.data() + skipped;
  int* __restrict from = from_.data();
  int* __restrict to = to_.data();
  float* __restrict inverseDepth = rowInverseDepth_.data();
  float* __restrict perPixel = perPixel_.data();
  for (std::size_t i = 0; i < n; ++i) {
    from[i] = pixelFrom(bounded(left[i]));
    to[i] = pixelFrom(bounded(right[i]));
    const float center = static_cast<float>(first + static_cast<int>(i)) + 0.5f;
    const float scale = 1 / plane.distanceAt(center);
    const int start = from[i] & ~(lanes - 1);
    perPixel[i] = plane.perColumnAt(center) * scale;
    inverseDepth[i] =
        plane.firstColumnAt(center) * scale + perPixel[i] * (static_cast<float>(start) + 0.5f);
  }
}

template <bool hasDepth, bool withGeoms>
void Rasterizer::fillRows(int first, int end, PackedColor color) {
  const auto value = static_cast<std::int32_t>(color);
  const Ints lane = {0, 1, 2, 3}, colors = {value, value, value, value};
  const Ints everywhere = {-1, -1, -1, -1};
  const Ints geoms = {geom_, geom_, geom_, geom_};
  for (int y = first; y < end; ++y) {
    const auto row = static_cast<std::size_t>(y - first);
    const int from = from_[row], to = to_[row];
    if (from >= to) continue;
    const float z = rowInverseDepth_[row], perX = perPixel_[row];
    Floats inverseDepth = {z, z + perX, z + 2 * perX, z + 3 * perX};
    const float step = lanes * perX;
    PackedColor* const colorRow = colors_.data() + offset(y);
    float* const inverseDepthRow = inverseDepth_.data() + offset(y);
    std::int32_t* const geomRow = withGeoms ? geoms_.data() + offset(y) : nullptr;
    const auto fillLanes = [&](int x, Ints mask) {
      if constexpr (hasDepth) {
        const auto old = load<Floats>(inverseDepthRow + x);
        mask &= inverseDepth > old;
        store(inverseDepthRow + x, choose(mask, inverseDepth, old));
      }
      store(colorRow + x, choose(mask, colors, load<Ints>(colorRow + x)));
      if constexpr (withGeoms) store(geomRow + x, choose(mask, geoms, load<Ints>(geomRow + x)));
      inverseDepth += step;
    };
    // Only the first and the last group of pixels may reach beyond the ends.
    int x = from & ~(lanes - 1);
    const Ints column = lane + x;
    fillLanes(x, (column >= from) & (column < to));
    for (x += lanes; x + lanes <= to; x += lanes) fillLanes(x, everywhere);
    if (x < to) fillLanes(x, lane + x < to);
  }
}

}  // namespace gt
