#pragma once
#include <optional>

#include "match/PlayFigures.h"
#include "match/PlayMoment.h"

namespace gt {

/// Measures the results of kicks, and how soon robots kick.
class KickWatch {
 public:
  /// `deceleration` of the rolling ball in mm/s^2.
  KickWatch(const FieldDimensions& field, double deceleration)
      : field_{field}, deceleration_{deceleration} {}

  void see(const PlayMoment& moment);
  /// A team has scored.
  void goal(TeamColor team);
  /// The game is interrupted, or the ball was put somewhere by hand.
  void interrupt();

  /// `minutes` of the whole match.
  void report(double minutes, PlayFigures& figures) const;

 private:
  /// A kick, from its beginning to the next touch of the ball.
  struct Kick {
    std::size_t robot;
    TeamColor team;
    Time began;
    Vector2d from = Vector2d::Zero();  ///< where the ball lay (mm, on the field)
    std::optional<Vector2d> planned;   ///< motion of the ball that the robot wants (mm)
    Time lastTouch = never();          ///< by the kicker
    bool free = false;                 ///< The ball has left the kicker.
    bool onGoal = false;               ///< whether it rolls into the goal after that touch
  };
  /// The time (s) since another robot has touched the ball, by what happened in it.
  struct Approach {
    bool known = false;                      ///< Another robot has touched it.
    double rolls = 0, comes = 0, lines = 0;  ///< The robot is not at the ball, or it is.
  };
  struct Record {
    bool kicked = false;  ///< in the last moment
    Approach approach;
  };
  struct TeamRecord {
    int kicks = 0;
    PlayShare hits, onGoal, back, ownTouch, passes, saved;
    std::vector<double> ways;                   ///< Distances that balls moved, mm
    std::vector<double> ofPlanned, offPlanned;  ///< % of the planned distance; degrees off it
    std::vector<double> afterTouch, rolls, comes, lines;
  };

  void watchApproaches(const PlayMoment& moment);
  void followKick(const PlayMoment& moment);
  void begin(const PlayMoment& moment, std::size_t robot);
  /// The ball leaves the kicker, which has hit it.
  void leave();
  void end(const Vector2d& ball, bool own, bool pass);
  /// Compares the motion of the ball (mm, on the field) with the one that was planned.
  void comparePlan(const Vector2d& way);
  TeamRecord& of(TeamColor team) { return teams_[indexOf(team)]; }

  FieldDimensions field_;
  double deceleration_;
  std::vector<Record> robots_;
  std::optional<Kick> kick_;  ///< the last one that began
  PerTeam<TeamRecord> teams_;
  BallState ball_;  ///< in the last moment
  Time time_ = never();
  double elapsed_ = 0;  ///< s, since the moment before
};

}  // namespace gt
