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

/// How a goal came about: the goalie pushed in a ball that was not on its way in; the ball lay
/// beside a goalie that did not see it; or it lay beside one that saw it; or it was shot, whether
/// or not the goalie touched it then.
enum class GoalCause { touched, unseen, beside, shot };

/// How teams play: where the ball's time goes, what becomes of kicks and shots, who goes to the
/// ball and whether it sees it, how goals come about, who breaks which rule. What experiments
/// measure, match.json holds and the report page shows.
class PlayWatch {
 public:
  /// `deceleration` of the rolling ball in mm/s^2.
  PlayWatch(const FieldDimensions& field, double deceleration)
      : field_{field},
        deceleration_{deceleration},
        ledger_{field},
        kicks_{field, deceleration},
        shots_{field, deceleration} {}

  /// A tick of the running game. The robots' speeds are found here.
  void see(const PlayMoment& moment);
  /// What the referee saw or did.
  void note(const GameEvent& event);

  const std::vector<ShotSummary>& shots() const { return shots_.shots(); }
  /// All figures of a match of so many minutes. Names of a team's begin with its color.
  std::vector<PlayFigure> figures(double minutes) const;

 private:
  struct RobotRecord {
    TeamColor team = TeamColor::red;
    DynamicRole role = DynamicRole::defensiveSupporter, before = role;
    Time changed = never();
    /// For how long the ball has been lying beside it, and that unseen (s).
    double ballBeside = 0, besideUnseen = 0;
    Time leftBall = never(), missedBall = never();  ///< when that had been so for long
    Vector2d position = Vector2d::Zero(), speed = Vector2d::Zero();
  };
  struct TeamRecord {
    PlayShare twoStrikers, noStriker, unseen, rolesKept;
    EnumArray<GoalCause, int> letIn;
    EnumArray<Penalty, int> penalties;
    double inOwnArea = 0;  ///< s, of all field players together
    int goals = 0;
    RunningStatistics strikerSpeed;  ///< mm/s, far from the ball
    Time shot = never();             ///< when a ball was on its way into its goal
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
