#pragma once
#include <algorithm>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"

namespace gt {

/// A rectangle around something in an image, by two opposite corners. Pixels.
struct BoxLabel {
  Vector2d from = Vector2d::Zero(), to = Vector2d::Zero();

  double left() const { return std::min(from.x(), to.x()); }
  double right() const { return std::max(from.x(), to.x()); }
  double top() const { return std::min(from.y(), to.y()); }
  double bottom() const { return std::max(from.y(), to.y()); }
  bool operator==(const BoxLabel&) const = default;
};

/// What a rectangle is around.
struct BoxName {
  enum class Kind { flag, goal, player };

  Kind kind = Kind::flag;
  int which = 0;   ///< The ordinal of the FlagType, GoalColor, or TeamColor.
  int number = 0;  ///< Players of a team in one image have different numbers.

  auto operator<=>(const BoxName&) const = default;
  /// Such as flag.pinkAboveYellow, goal.skyblue, player.red1.
  std::string text() const;
  static std::optional<BoxName> parse(std::string_view text);
};

/// What a person sees of lines, goals, flags and players in one image of a log. Pixels.
struct FieldLabel {
  std::int64_t time = 0;  ///< ms, to find a label for the wrong log.
  /// Along the middle of each line; not all of a line need be labeled.
  std::vector<std::vector<Vector2d>> lines{};
  std::optional<Vector2d> leftPost{}, rightPost{};  ///< Where the goal's posts meet the ground.
  std::map<BoxName, BoxLabel> boxes{};              ///< Around all of it, down to the ground.

  bool operator==(const FieldLabel&) const = default;

  /// How far a point of the image is from the nearest labeled line; infinite if there is none.
  double distance(const Vector2d& point) const;
};

/// Reads labels from a table with the columns picture, time, what, x, y. What is `none`,
/// `leftPost`, `rightPost`, `line` with a number, or a box's name; points of the same line are
/// joined in the file's order, a box has two rows. The name is for errors.
Result<std::map<int, FieldLabel>> parseFieldLabels(std::string_view text, const std::string& name);
Result<std::map<int, FieldLabel>> readFieldLabels(const std::string& file);
/// The same table; reading it gives the same labels, bit for bit, but for lines without points.
std::string fieldLabelTable(const std::map<int, FieldLabel>& labels);

}  // namespace gt
