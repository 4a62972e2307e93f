#pragma once
#include "base/Enum.h"
#include "match/PlayFigures.h"
#include "match/PlayMoment.h"

namespace gt {

/// What the ball's time is spent on. It lies or rolls slowly unless said otherwise; near is within
/// `atBall`.
enum class BallUse {
  kicked,    ///< A robot near it performs a kick.
  rolls,     ///< It rolls, and nobody is near.
  pushed,    ///< It rolls among robots.
  duel,      ///< Field players of both teams are near.
  goalie,    ///< Only goalies are near.
  searched,  ///< Only robots are near that have not seen it for a second.
  linedUp,   ///< A robot is near that sees it.
  comes,     ///< Nobody is near, and somebody comes.
  left       ///< Nobody is near, and nobody comes.
};

/// Where the ball's time goes, who has it, and where it is.
class BallLedger {
 public:
  explicit BallLedger(const FieldDimensions& field) : field_{field} {}

  void see(const PlayMoment& moment);
  void report(PlayFigures& figures) const;

  /// What a moment is spent on.
  static BallUse useOf(const PlayMoment& moment);

 private:
  FieldDimensions field_;
  EnumArray<BallUse, int> uses_;
  PlayShare idle_, atBorder_;
  PerTeam<PlayShare> possession_, territory_;
};

}  // namespace gt
