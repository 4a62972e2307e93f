#pragma once
#include <cstdint>
#include <string>
#include <string_view>
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

  bool operator==(const BallLabel&) const = default;
};

/// Reads labels from a table with the columns picture, time, class, x, y, r. The name is for
/// errors.
Result<std::vector<BallLabel>> parseLabels(std::string_view text, const std::string& name);
Result<std::vector<BallLabel>> readLabels(const std::string& file);
/// The same table; reading it gives the same labels, bit for bit.
std::string labelTable(const std::vector<BallLabel>& labels);

}  // namespace gt
