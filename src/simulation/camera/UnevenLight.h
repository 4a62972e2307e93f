#pragma once
#include <cstdint>
#include <vector>

#include "simulation/camera/CameraView.h"

namespace gt {

/// Light that differs over the field, as below rows of lamps at the ceiling. The light is computed
/// at points of the image, 16 pixels apart, and interpolated between them.
class UnevenLight {
 public:
  /// Relative brightness at a place on the field (mm): -1 to 1, 0 on average.
  static double at(const Vector2d& place);

  /// Sets the view of the next calls of `row`. Places are brighter or darker by at most `share`.
  /// Rays that do not meet the ground within 3 m get the light of the field 3 m ahead.
  void set(const CameraView& view, double share);
  /// Writes the light of the pixels of a row, and of more up to a multiple of 16. The average light
  /// is 1 << 14.
  void row(int y, std::int16_t* light) const;

 private:
  int columns_ = 0;
  std::vector<std::int16_t> points_;  ///< Row by row.
};

}  // namespace gt
