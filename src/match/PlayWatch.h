#pragma once
#include "base/Enum.h"
#include "base/Statistics.h"
#include "match/BallLedger.h"
#include "match/KickWatch.h"
#include "match/PlayFigures.h"
#include "match/PlayMoment.h"
#include "match/ShotWatch.h"
#include "simulation/rules/GameEvent.h"

namespace gt {

/// The cause of a goal: the goalie pushed in a ball that was not rolling into the goal (touched);
/// the ball lay beside a goalie that did not see it (unseen) or saw it (beside); or the ball was
/// shot, whether or not the goalie touched it then (shot).
enum class GoalCause { touched, unseen, beside, shot };

/// Measures how teams play: what the ball's time is spent on, the results of kicks and shots, which
/// robots go to the ball and whether they see it, the causes of goals, and the fouls. Experiments,
/// match.json and the report page use these figures.
class PlayWatch {
 public:
  /// `deceleration` of the rolling ball in mm/s^2.
  PlayWatch(const FieldDimensions& field, double deceleration)
      : field_{field},
        deceleration_{deceleration},
        ledger_{field},
        kicks_{field, deceleration},
        shots_{field, deceleration} {}

  /// Processes a tick of the running game. Computes the robots' speeds itself.
  void see(const PlayMoment& moment);
  /// Processes an event of the referee.
  void note(const GameEvent& event);

  const std::vector<ShotSummary>& shots() const { return shots_.shots(); }
  /// All figures of a match that took `minutes`. Names of a team's figures begin with its color.
  std::vector<PlayFigure> figures(double minutes) const;

 private:
  struct RobotRecord {
    TeamColor team = TeamColor::red;
    DynamicRole role = DynamicRole::defensiveSupporter, before = role;
    Time changed = never();
    /// Time for which the ball has been lying beside it, and lying there unseen (s).
    double ballBeside = 0, besideUnseen = 0;
    Time leftBall = never(), missedBall = never();  ///< when each last exceeded its limit
    Vector2d position = Vector2d::Zero(), speed = Vector2d::Zero();
  };
  struct TeamRecord {
    PlayShare twoStrikers, noStriker, unseen, rolesKept;
    EnumArray<GoalCause, int> letIn;
    EnumArray<Penalty, int> penalties;
    double inOwnArea = 0;  ///< s, of all field players together
    int goals = 0;
    RunningStatistics strikerSpeed;  ///< mm/s, far from the ball
    Time shot = never();             ///< when a ball last rolled towards its goal
  };

  void measureSpeeds();
  void watchRoles();
  void watchAreas();
  void watchGoalies();
  void goal(TeamColor team);
  void interrupt();
  GoalCause causeOf(TeamColor letIn) const;
  TeamRecord& of(TeamColor team) { return teams_[indexOf(team)]; }

  FieldDimensions field_;
  double deceleration_;
  BallLedger ledger_;
  KickWatch kicks_;
  ShotWatch shots_;
  PlayMoment moment_;  ///< the last one
  std::vector<RobotRecord> robots_;
  PerTeam<TeamRecord> teams_;
};

}  // namespace gt
