#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Result.h"
#include "streams/Reflection.h"

namespace gt {

/// What a team has learned from matches: how much a ball at a place is worth, and where supporters
/// help most, at the points of a grid over the field (`python/gt2003/values.py`). The grid covers
/// the left half, which the right one mirrors. Configuration, from `values.cfg`; empty, the team
/// plays by the rules of its behavior alone.
struct PlayValues {
  int columns = 0, rows = 0;
  double nearer = 200;
  std::vector<double> ours, theirs;
  std::vector<Vector2d> ahead, behind;

  static constexpr auto fields() {
    using P = PlayValues;
    return Fields{
        field<&P::columns>("from the own ground line to the opponent's", {0, 100}),
        field<&P::rows>("from the middle to the left side line", {0, 100}),
        field<&P::nearer>(
            Unit::mm, "a team that is nearer by so much has the ball e times as likely", {1, 5000}),
        field<&P::ours>("worth of a ball that the own team has, -1 to 1, column by column"),
        field<&P::theirs>("worth of a ball that the opponents have, -1 to 1, column by column"),
        field<&P::ahead>(Unit::mm, "place of the supporter that stands ahead of the other"),
        field<&P::behind>(Unit::mm, "place of the other one")};
  }

  bool empty() const { return columns == 0; }
  /// Returns an error if a list does not fit the grid.
  Result<void> check() const;

  /// The worth of a ball at a place on the field, to which some player of the own team is nearer
  /// than any opponent by `lead` (mm). `corner` is the field's corner at the left of the
  /// opponent's goal.
  double worth(const Vector2d& ball, double lead, const Vector2d& corner) const;
  /// Where a supporter helps while the ball is at a place.
  Vector2d placeAhead(const Vector2d& ball, const Vector2d& corner) const;
  Vector2d placeBehind(const Vector2d& ball, const Vector2d& corner) const;
};

}  // namespace gt
