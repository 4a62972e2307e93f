#pragma once
#include "base/Enum.h"
#include "match/PlayFigures.h"
#include "match/PlayMoment.h"

namespace gt {

/// Classes of moments of a match by what happens to the ball. Unless stated otherwise, the ball
/// lies or rolls slowly. "Near" means within `atBall`.
enum class BallUse {
  kicked,    ///< A robot near it performs a kick.
  rolls,     ///< It rolls, and no robot is near.
  pushed,    ///< It rolls among robots.
  duel,      ///< Field players of both teams are near.
  goalie,    ///< Only goalies are near.
  searched,  ///< Only robots are near that have not seen it for a second.
  linedUp,   ///< A robot is near that sees it.
  comes,     ///< No robot is near, and one comes.
  left       ///< No robot is near, and none comes.
};

/// Counts what the ball's time is spent on, which team has the ball, and in which half it is.
class BallLedger {
 public:
  explicit BallLedger(const FieldDimensions& field) : field_{field} {}

  void see(const PlayMoment& moment);
  void report(PlayFigures& figures) const;

  /// The class of a moment.
  static BallUse useOf(const PlayMoment& moment);

 private:
  FieldDimensions field_;
  EnumArray<BallUse, int> uses_;
  PlayShare idle_, atBorder_;
  PerTeam<PlayShare> possession_, territory_;
};

}  // namespace gt
