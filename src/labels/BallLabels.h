#pragma once
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"

namespace gt {

/// How much of the ball a person sees in an image. whole: completely and sharply; partial: a part
/// of it, or blurred; none: not at all.
enum class BallView { whole, partial, none };

/// A person's label of the ball in one image of a log.
struct BallLabel {
  int picture = 0;
  std::int64_t time = 0;  ///< Time (ms) of the image, to detect labels of another log.
  BallView view = BallView::none;
  Vector2d center = Vector2d::Zero();  ///< Pixels.
  double radius = 0;                   ///< Pixels.

  bool operator==(const BallLabel&) const = default;
};

/// Parses labels from a table with the columns picture, time, class, x, y, r. The name is used in
/// errors.
Result<std::vector<BallLabel>> parseLabels(std::string_view text, const std::string& name);
Result<std::vector<BallLabel>> readLabels(const std::string& file);
/// Formats labels as a table. Reading it yields the same labels, bit for bit.
std::string labelTable(const std::vector<BallLabel>& labels);

}  // namespace gt
