#include "simulation/camera/Rasterizer.h"

#include <algorithm>

#include "base/WideInstructions.h"
#include "simulation/camera/Lanes.h"

namespace gt {
namespace {

/// The first pixel (row) whose center does not lie before a coordinate.
[[gnu::always_inline]] inline Ints pixelFrom(Floats places) {
  const Floats v = places - 0.5f;
  const auto i = __builtin_convertvector(v, Ints);
  return i - (v > __builtin_convertvector(i, Floats));  // minus what is -1 where it holds
}

/// The coordinates of four points.
struct Points {
  Floats x, y;

  [[gnu::always_inline]] explicit Points(const ScreenPoint* points) {
    const auto two = load<Floats>(points), more = load<Floats>(points + 2);
    x = Floats{two[0], two[2], more[0], more[2]};
    y = Floats{two[1], two[3], more[1], more[3]};
  }
};

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
  for (auto* side : {&left_, &right_}) side->resize(static_cast<std::size_t>(height + lanes));
}

void Rasterizer::fill(ScreenPoint* points, int count, const ScreenPlane& plane, PackedColor color) {
  // The first point again: it ends the last edge and fills the lanes behind it.
  for (int i = 0; i < ScreenPoint::spare; ++i) points[count + i] = points[0];
  auto low = load<Floats>(points), high = low;  // x, y, x, y
  for (int i = 2; i < count; i += 2) {
    const auto two = load<Floats>(points + i);
    low = least(low, two);
    high = most(high, two);
  }
  const float rightmost = std::max(high[0], high[2]);
  const Ints ends = pixelFrom(Floats{std::min(low[0], low[2]), std::min(low[1], low[3]), rightmost,
                                     std::max(high[1], high[3])});
  const int first = std::max(0, ends[1]), end = std::min(height_, ends[3]);
  if (first >= end || ends[0] >= std::min(width_, ends[2]) || rightmost < 0) return;
  withWideInstructions([&]() __attribute__((always_inline)) {
    addEdges(points, count, plane.clockwise);
    if (hasDepth_)
      withGeoms_ ? fillRows<true, true>(first, end, plane, color)
                 : fillRows<true, false>(first, end, plane, color);
    else
      withGeoms_ ? fillRows<false, true>(first, end, plane, color)
                 : fillRows<false, false>(first, end, plane, color);
  });
}

[[gnu::always_inline]] inline void Rasterizer::addEdges(const ScreenPoint* points, int count,
                                                        bool clockwise) {
  float *const left = left_.data(), *const right = right_.data();
  for (int i = 0; i < count; i += lanes) {
    const Points a{points + i}, b{points + i + 1};
    // Always from above, so that neighbors agree on the points of their common edge.
    const Ints down = a.y < b.y;
    const Floats x = down ? a.x : b.x, y = down ? a.y : b.y;
    const Floats lowerX = down ? b.x : a.x, lowerY = down ? b.y : a.y;
    const Floats slopes = (lowerX - x) / (lowerY - y);
    const Ints upperRows = pixelFrom(y), from = upperRows > 0 ? upperRows : Ints{};
    const Ints to = pixelFrom(lowerY);
    const Floats rows = __builtin_convertvector(from, Floats) + 0.5f - y;
    for (int k = 0; k < std::min(lanes, count - i); ++k) {
      float* const side = (down[k] != 0) == clockwise ? right : left;
      const int end = std::min(height_, to[k]);
      Floats row = rows[k] + Floats{0, 1, 2, 3};
      for (int at = from[k]; at < end; at += lanes, row += lanes) {
        const Ints mask = Ints{0, 1, 2, 3} < end - at;
        store(side + at, mask ? x[k] + row * slopes[k] : load<Floats>(side + at));
      }
    }
  }
}

template <bool hasDepth, bool withGeoms>
[[gnu::always_inline]] inline void Rasterizer::fillRows(int first, int end,
                                                        const ScreenPlane& plane,
                                                        PackedColor color) {
  const auto value = static_cast<std::int32_t>(color);
  const Ints lane = {0, 1, 2, 3}, colors = {value, value, value, value};
  const Ints everywhere = {-1, -1, -1, -1};
  const Ints geoms = {geom_, geom_, geom_, geom_};
  const auto columnFrom = [limit = all(static_cast<float>(width_))](const float* side) {
    return pixelFrom(most(Floats{}, least(load<Floats>(side), limit)));
  };
  const float *const left = left_.data(), *const right = right_.data();
  PackedColor* colorRow = colors_.data() + offset(first);
  float* inverseDepthRow = inverseDepth_.data() + offset(first);
  std::int32_t* geomRow = withGeoms ? geoms_.data() + offset(first) : nullptr;
  const int stride = stride_;
  for (int y = first; y < end; y += lanes) {
    // Of each row: its first pixel and the one behind its last, the inverse depth at its first
    // group of pixels and how it changes.
    const Ints from = columnFrom(left + y), to = columnFrom(right + y);
    const Floats center = __builtin_convertvector(lane + y, Floats) + 0.5f;
    const Floats scale = 1 / plane.distanceAt(center), perPixel = plane.perColumnAt(center) * scale;
    const Floats start = __builtin_convertvector(from & ~(lanes - 1), Floats) + 0.5f;
    const Floats depths = plane.firstColumnAt(center) * scale + perPixel * start;
    for (int k = 0; k < std::min(lanes, end - y);
         ++k, colorRow += stride, inverseDepthRow += stride, geomRow += withGeoms ? stride : 0) {
      const int begin = from[k], behind = to[k];
      if (begin >= behind) continue;
      const float z = depths[k], perX = perPixel[k];
      Floats inverseDepth = {z, z + perX, z + 2 * perX, z + 3 * perX};
      const float step = lanes * perX;
      const auto fillLanes = [&](int x, Ints mask) {
        if constexpr (hasDepth) {
          const auto old = load<Floats>(inverseDepthRow + x);
          mask &= inverseDepth > old;
          store(inverseDepthRow + x, mask ? inverseDepth : old);
        }
        store(colorRow + x, mask ? colors : load<Ints>(colorRow + x));
        if constexpr (withGeoms) store(geomRow + x, mask ? geoms : load<Ints>(geomRow + x));
        inverseDepth += step;
      };
      // Only the first and the last group of pixels may reach beyond the ends.
      int x = begin & ~(lanes - 1);
      const Ints column = lane + x;
      fillLanes(x, (column >= begin) & (column < behind));
      for (x += lanes; x + lanes <= behind; x += lanes) fillLanes(x, everywhere);
      if (x < behind) fillLanes(x, lane + x < behind);
    }
  }
}

}  // namespace gt
