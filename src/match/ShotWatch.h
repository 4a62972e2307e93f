#pragma once
#include <optional>
#include <string>

#include "match/PlayFigures.h"
#include "match/PlayMoment.h"

namespace gt {

/// Follows each ball that rolls to a goal, and the goalie's reaction.
class ShotWatch {
 public:
  /// `deceleration` of the rolling ball in mm/s^2.
  ShotWatch(const FieldDimensions& field, double deceleration)
      : field_{field}, deceleration_{deceleration} {}

  void see(const PlayMoment& moment);
  /// A team has scored.
  void goal(TeamColor team);
  /// The game is interrupted, or the ball was put somewhere by hand.
  void interrupt();

  const std::vector<ShotSummary>& shots() const { return shots_; }
  void report(PlayFigures& figures) const;

 private:
  struct Running {
    ShotSummary shot;
    Vector2d goalie = Vector2d::Zero();  ///< position of the goalie at first (mm, on the field)
    std::string action;                  ///< special action that the goalie performed then
    Time lastTouch = never();            ///< when the ball was touched last before
    Time ended = never();                ///< when it was stopped; it may go in nevertheless
  };

  void begin(const PlayMoment& moment, TeamColor shooter);
  void follow(const PlayMoment& moment, Running& running);
  void close();

  FieldDimensions field_;
  double deceleration_;
  std::optional<Running> running_;
  std::vector<ShotSummary> shots_;
};

}  // namespace gt
