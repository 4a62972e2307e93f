#pragma once
#include "base/Enum.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// Counts a penalty shoot-out: the teams shoot in turn, until one cannot be caught up with any
/// more; after the shots that each team has, pair by pair.
class ShootOut {
 public:
  ShootOut(int shots, TeamColor first) : shots_{shots}, first_{first} {}

  /// Whose shot is next.
  TeamColor team() const { return taken_ % 2 == 0 ? first_ : opponent(first_); }
  /// From 1: which of its team's shots is next.
  int number() const { return taken_ / 2 + 1; }
  int goals(TeamColor team) const { return goals_[team]; }

  void count(bool goal) {
    goals_[team()] += goal;
    ++taken_;
  }
  /// Whether it is decided, or was given up as a draw after four times the shots.
  bool over() const {
    const int firstLeft = shots_ - (taken_ + 1) / 2, secondLeft = shots_ - taken_ / 2;
    const int lead = goals_[first_] - goals_[opponent(first_)];
    if (firstLeft >= 0 && secondLeft >= 0) return lead > secondLeft || -lead > firstLeft;
    return taken_ % 2 == 0 && (lead != 0 || taken_ >= 8 * shots_);
  }

 private:
  int shots_;
  TeamColor first_;
  int taken_ = 0;
  EnumArray<TeamColor, int> goals_;
};

}  // namespace gt
