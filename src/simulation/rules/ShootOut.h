#pragma once
#include "base/Enum.h"
#include "representations/infrastructure/Player.h"

namespace gt {

/// Counts a penalty shoot-out: the teams shoot in turn, until one can no longer be caught up with.
/// If they are even after `shots` each, they continue pair by pair.
class ShootOut {
 public:
  ShootOut(int shots, TeamColor first) : shots_{shots}, first_{first} {}

  /// The team that has the next shot.
  TeamColor team() const { return taken_ % 2 == 0 ? first_ : opponent(first_); }
  /// The number of the next shot of that team, from 1.
  int number() const { return taken_ / 2 + 1; }
  int goals(TeamColor team) const { return goals_[team]; }

  void count(bool goal) {
    goals_[team()] += goal;
    ++taken_;
  }
  /// Whether the shoot-out is decided, or ended as a draw after four times `shots` for each team.
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
