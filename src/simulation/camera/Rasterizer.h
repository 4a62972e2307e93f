#pragma once
#include <cstdint>
#include <vector>

#include "simulation/camera/CameraScene.h"
#include "simulation/camera/Projection.h"

namespace gt {

/// Fills convex polygons of one color into an image with a depth for each pixel. A pixel belongs
/// to a polygon if its center lies inside; neighbors that share an edge share no pixel and leave
/// none out.
class Rasterizer {
 public:
  /// Starts an image; `withGeoms` also notes which geom each pixel shows.
  void begin(int width, int height, PackedColor background, bool withGeoms);

  /// Sets the geom of the next polygons. With depth, nearer pixels hide it; without, it is painted
  /// over everything.
  void setSurface(int geom, bool hasDepth) {
    geom_ = geom;
    hasDepth_ = hasDepth;
  }
  /// Fills a polygon; `points` must have room for `ScreenPoint::spare` more.
  void fill(ScreenPoint* points, int count, const ScreenPlane& plane, PackedColor color);

  int width() const { return width_; }
  int height() const { return height_; }
  const PackedColor* row(int y) const { return &colors_[offset(y)]; }
  PackedColor* row(int y) { return &colors_[offset(y)]; }
  /// The geoms of a row, -1 for the background; only after `begin` with `withGeoms`.
  const std::int32_t* geomRow(int y) const { return &geoms_[offset(y)]; }

 private:
  void addEdges(const ScreenPoint* points, int count, bool clockwise);
  template <bool hasDepth, bool withGeoms>
  void fillRows(int first, int end, const ScreenPlane& plane, PackedColor color);
  std::size_t offset(int y) const { return static_cast<std::size_t>(y * stride_); }

  int width_ = 0, height_ = 0, stride_ = 0;
  int geom_ = -1;
  bool hasDepth_ = true, withGeoms_ = false;
  std::vector<PackedColor> colors_;
  std::vector<float> inverseDepth_;
  std::vector<std::int32_t> geoms_;
  std::vector<float> left_, right_;  ///< The outline, by row of the image.
};

}  // namespace gt
