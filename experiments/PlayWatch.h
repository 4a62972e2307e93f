#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "base/Enum.h"
#include "base/Geometry.h"
#include "base/Time.h"
#include "measure/Tally.h"
#include "representations/behavior/TeamMessage.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "simulation/world/World.h"

namespace gt {

/// A tick of a match while the game runs, from the truth.
struct PlayMoment {
  struct Robot {
    TeamColor team = TeamColor::red;
    Vector2d position = Vector2d::Zero();  ///< mm, on the field
    bool plays = true;                     ///< It is not penalized.
    bool kicks = false;                    ///< It performs a kick.
    DynamicRole role = DynamicRole::defensiveSupporter;
    double ballUnseen = 0;  ///< ms, since its camera saw the ball
  };
  Time time;
  BallState ball;
  std::vector<Robot> robots;
};

/// How a goal came about: the goalie pushed in a ball that was not on its way in; the ball lay
/// beside a goalie that left it there; or it was shot, whether or not the goalie touched it then.
enum class GoalCause { touched, beside, shot };

/// How teams play: what becomes of their kicks and how soon they come, who goes to the ball,
/// whether they see it, how goals come about. Names begin with the team's color.
class PlayWatch {
 public:
  /// `deceleration` of the rolling ball in mm/s^2.
  PlayWatch(const FieldDimensions& field, double deceleration)
      : field_{field}, deceleration_{deceleration} {}

  void see(const PlayMoment& moment);
  /// A team has scored.
  void goal(TeamColor team);
  /// The game is interrupted, or the ball was put somewhere by hand.
  void interrupt();

  const Tally& tally() const { return tally_; }
  int kicks(TeamColor team) const { return kicks_[static_cast<std::size_t>(team)]; }
  /// How many goals a team let in.
  int letIn(TeamColor team, GoalCause cause) const {
    return letIn_[static_cast<std::size_t>(team)][cause];
  }
  /// How long field players of a team were in their own penalty area, in s, all together.
  double inOwnArea(TeamColor team) const { return inOwnArea_[static_cast<std::size_t>(team)]; }

 private:
  /// A kick, from its beginning to the next touch of the ball.
  struct Kick {
    std::size_t robot;
    Time began;
    Vector2d from = Vector2d::Zero();  ///< where the ball lay
    Time lastTouch = never();          ///< by the kicker
    bool free = false;                 ///< The ball has left the kicker.
    bool onGoal = false;               ///< as the kicker's last touch had it roll
  };
  struct RobotRecord {
    bool kicked = false;  ///< in the last moment
    DynamicRole role = DynamicRole::defensiveSupporter, before = role;
    Time changed = never();
    Time touched = never();   ///< the ball, since the last interruption
    double ballBeside = 0;    ///< for how long the ball has been lying beside it (s)
    Time leftBall = never();  ///< when the ball had been lying beside it for long
  };

  void watchKick(const PlayMoment& moment);
  void beginKick(const PlayMoment& moment, std::size_t robot);
  void watchRoles(const PlayMoment& moment);
  void watchAreas(const PlayMoment& moment);
  void watchGoalies(const PlayMoment& moment);
  GoalCause causeOf(TeamColor letIn) const;
  /// The ball leaves the kicker, which has hit it.
  void leave();
  void end(bool own);
  bool rollsIntoGoal(const BallState& ball, TeamColor shooter) const;

  FieldDimensions field_;
  double deceleration_;
  std::vector<RobotRecord> robots_;
  std::optional<Kick> kick_;  ///< the last one that began
  std::vector<TeamColor> teams_;
  std::array<int, 2> kicks_{};
  std::array<EnumArray<GoalCause, int>, 2> letIn_;
  std::array<double, 2> inOwnArea_{};
  std::array<Time, 2> shot_{never(), never()};  ///< when a ball was on its way into a team's goal
  BallState ball_;                              ///< in the last moment
  Time time_ = never();
  Tally tally_;
};

}  // namespace gt
