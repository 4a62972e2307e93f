#pragma once
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"

namespace gt {

/// How much of the ball a person sees in an image: all of it and sharply, some of it or blurred,
/// nothing.
enum class BallView { whole, partial, none };

/// What a person sees in one image of a log.
struct BallLabel {
  int picture = 0;
  std::int64_t time = 0;  ///< ms, to find a label for the wrong log.
  BallView view = BallView::none;
  Vector2d center = Vector2d::Zero();  ///< Pixels.
  double radius = 0;                   ///< Pixels.
};

/// Reads labels from a table with the columns image, time, class, x, y, r.
Result<std::vector<BallLabel>> readLabels(const std::string& file);

}  // namespace gt
