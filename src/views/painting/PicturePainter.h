#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "debug/Drawing.h"
#include "representations/infrastructure/Image.h"

struct _cairo_surface;

namespace gt {

/// A camera picture in RGB, enlarged, on which debug drawings are painted with smooth edges (by
/// Cairo).
class PicturePainter {
 public:
  /// Converts a picture (YCbCr, full range as in JPEG) and enlarges it by a whole number: each
  /// pixel becomes a square. A picture with fewer pixels than it claims is black below them.
  explicit PicturePainter(const Image& image, int scale = 2);

  /// Paints the elements of a drawing in the order in which they were drawn. Points and sizes are
  /// pixels of the camera's picture, (0, 0) is the upper left corner of its first pixel; the width
  /// of the pen counts in pixels of the enlarged one. What lies outside or makes no sense (too few
  /// points, not finite) is left out.
  void paint(const Drawing& drawing);

  int width() const;   ///< Of the enlarged picture, in pixels.
  int height() const;  ///< Of the enlarged picture, in pixels.
  /// The enlarged picture, 3 bytes a pixel, row by row from the top.
  std::vector<std::uint8_t> rgb() const;

 private:
  struct Release {
    void operator()(_cairo_surface* surface) const;
  };

  std::unique_ptr<_cairo_surface, Release> surface_;
  double scale_;
};

}  // namespace gt
