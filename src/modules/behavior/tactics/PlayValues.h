#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"
#include "streams/Reflection.h"

namespace gt {

/// Values that a team has learned from matches: the worth of a ball and the best places of
/// supporters, at the points of a grid over the field (`python/gt2003/values.py`). The grid covers
/// the left half; the right half mirrors it. Configuration, from `values.cfg`. If empty, the team
/// plays only by the rules of its behavior.
struct PlayValues {
  int columns = 0, rows = 0;
  double nearer = 200;
  std::vector<double> ours, theirs;
  std::vector<Vector2d> ahead, behind;

  static constexpr auto fields() {
    using P = PlayValues;
    return Fields{
        field<&P::columns>("number of columns from the own ground line to the opponent's",
                           {0, 100}),
        field<&P::rows>("number of rows from the middle to the left side line", {0, 100}),
        field<&P::nearer>(Unit::mm,
                          "lead in distance to the ball that multiplies the odds of having it by e",
                          {1, 5000}),
        field<&P::ours>("worth of a ball that the own team has, -1 to 1, column by column"),
        field<&P::theirs>("worth of a ball that the opponents have, -1 to 1, column by column"),
        field<&P::ahead>(Unit::mm, "place of the supporter that stands ahead of the other one"),
        field<&P::behind>(Unit::mm, "place of the supporter that stands behind the other one")};
  }

  bool empty() const { return columns == 0; }
  /// Returns an error if a list does not fit the grid.
  Result<void> check() const;

  /// The worth of a ball at a position on the field (mm), to which some player of the own team is
  /// nearer than any opponent by `lead` (mm). `corner` is the field's corner at the left of the
  /// opponent's goal (mm).
  double worth(const Vector2d& ball, double lead, const Vector2d& corner) const;
  /// The best places of the supporters ahead and behind for a position of the ball (mm, on the
  /// field).
  Vector2d placeAhead(const Vector2d& ball, const Vector2d& corner) const;
  Vector2d placeBehind(const Vector2d& ball, const Vector2d& corner) const;
};

}  // namespace gt
