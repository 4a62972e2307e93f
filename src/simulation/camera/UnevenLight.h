#pragma once
#include <cstdint>
#include <vector>

#include "simulation/camera/CameraView.h"

namespace gt {

/// Light that differs over the field, as below rows of lamps at the ceiling. It is computed at
/// points of the image, 16 pixels apart, and interpolated between them.
class UnevenLight {
 public:
  /// How much brighter than on average a place on the field is (mm): -1 to 1.
  static double at(const Vector2d& place);

  /// Sets what the next rows see; places differ by at most `share`. Rays that meet the ground
  /// nowhere, or farther away, see the light 3 m ahead.
  void set(const CameraView& view, double share);
  /// The light of the pixels of a row, and of more up to a multiple of 16: 1 << 14 where it is as
  /// on average.
  void row(int y, std::int16_t* light) const;

 private:
  int columns_ = 0;
  std::vector<std::int16_t> points_;  ///< Row by row.
};

}  // namespace gt
