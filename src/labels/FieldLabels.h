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

/// The object that a rectangle encloses.
struct BoxName {
  enum class Kind { flag, goal, player };

  Kind kind = Kind::flag;
  int which = 0;   ///< The ordinal of the FlagType, GoalColor, or TeamColor.
  int number = 0;  ///< Players of a team in one image have different numbers.

  auto operator<=>(const BoxName&) const = default;
  /// For instance flag.pinkAboveYellow, goal.skyblue, player.red1.
  std::string text() const;
  static std::optional<BoxName> parse(std::string_view text);
};

/// A person's labels of lines, goals, flags and players in one image of a log, in pixels.
struct FieldLabel {
  std::int64_t time = 0;  ///< Time (ms) of the image, to detect labels of another log.
  /// Points along the center of each line; a part of a line may be unlabeled.
  std::vector<std::vector<Vector2d>> lines{};
  std::optional<Vector2d> leftPost{}, rightPost{};  ///< Points where the goal's posts meet the
                                                    ///< ground.
  std::map<BoxName, BoxLabel> boxes{};              ///< Enclose the whole object, down to the
                                                    ///< ground.

  bool operator==(const FieldLabel&) const = default;

  /// The distance (pixels) of a point in the image from the nearest labeled line; infinite if there
  /// is none.
  double distance(const Vector2d& point) const;
};

/// Parses labels from a table with the columns picture, time, what, x, y. The column what contains
/// `none`, `leftPost`, `rightPost`, `line` with a number, or a box's name. Points of the same line
/// are connected in the file's order; a box has two rows. The name is used in errors.
Result<std::map<int, FieldLabel>> parseFieldLabels(std::string_view text, const std::string& name);
Result<std::map<int, FieldLabel>> readFieldLabels(const std::string& file);
/// Formats labels as a table. Reading it yields the same labels, bit for bit, except for lines
/// without points.
std::string fieldLabelTable(const std::map<int, FieldLabel>& labels);

}  // namespace gt
