#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"

namespace gt {

/// What a person sees of lines and goal in one image of a log. Pixels.
struct FieldLabel {
  std::int64_t time = 0;  ///< ms, to find a label for the wrong log.
  /// Along the middle of each line; not all of a line need be labeled.
  std::vector<std::vector<Vector2d>> lines;
  std::optional<Vector2d> leftPost, rightPost;  ///< Where the goal's posts meet the ground.

  /// How far a point of the image is from the nearest labeled line; infinite if there is none.
  double distance(const Vector2d& point) const;
};

/// Reads labels from a table with the columns image, time, what, x, y. What is `none`,
/// `leftPost`, `rightPost`, or `line` with a number; points of the same line are joined in the
/// file's order.
Result<std::map<int, FieldLabel>> readFieldLabels(const std::string& file);

}  // namespace gt
