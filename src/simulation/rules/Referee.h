#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "base/Enum.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"
#include "simulation/parameters/GameParameters.h"
#include "simulation/parameters/RuleParameters.h"
#include "simulation/rules/Fouls.h"
#include "simulation/rules/GameController.h"
#include "simulation/rules/GameEvent.h"
#include "simulation/rules/ShootOut.h"
#include "simulation/world/World.h"

namespace gt {

/// Leads the game by the rules of 2003 (facts, 2.2): initial, ready, set, playing; goals,
/// kick-offs, halves, balls that are stuck, penalties, and the penalty shoot-out. The clock runs
/// from the first whistle on and does not stop; the teams keep their goals for both halves. In the
/// second half the other team kicks off. A goal is an own goal if a defender touched the ball last,
/// unless it only deflected a shot on goal.
///
/// A penalized robot stands beside the field, and comes back at the halfway line, on the side away
/// from the ball; for a kick-off all come back. Once a game controller has sent a message, the
/// referee only follows the game controller.
class Referee {
 public:
  Referee(const GameParameters& parameters, const RuleParameters& rules,
          const FieldDimensions& field, const std::vector<Player>& players);

  /// Looks at the world after a tick, and puts the ball and badly placed robots by hand.
  void update(World& world);
  /// Applies a message of a game controller.
  void follow(const GameControllerMessage& message, World& world);
  /// Whether a game controller leads the game.
  bool led() const { return led_; }

  const GameControlData& dataFor(std::size_t robot) const { return data_[robot]; }
  GameState state() const { return state_; }
  /// Whether the game and the time in which robots leave the field have ended. A game controller
  /// finishes each half and may take that back: only the end of the second half counts, and only
  /// `undoMs` later.
  bool over(Time now) const {
    if (state_ != GameState::finished || (led_ && half_ == 1)) return false;
    const std::int64_t leaving = toMs(parameters_.leaveTime);
    return now - stateSince_ >= (led_ ? std::max(leaving, undoMs) : leaving);
  }
  int half() const { return half_; }
  int score(TeamColor team) const { return score_[team]; }
  TeamColor kickOff() const { return kickOff_; }
  Penalty penalty(std::size_t robot) const { return penalties_[robot]; }
  /// The shoot-out, once it has begun.
  const std::optional<ShootOut>& shootOut() const { return shootOut_; }
  /// Time left in this half, or for this shot of the shoot-out (ms).
  std::int64_t timeLeft(Time now) const;
  const std::vector<GameEvent>& events() const { return events_; }

  const GameParameters& parameters() const { return parameters_; }
  const RuleParameters& rules() const { return fouls_.rules(); }
  /// Changes the parameters or rules from now on.
  void change(const GameParameters& parameters) { parameters_ = parameters; }
  void change(const RuleParameters& rules) { fouls_.change(rules); }

  /// Sets the state, as a person decides. In ready all penalties are lifted (report J.2.6).
  void order(GameState state, World& world);
  void setKickOff(TeamColor team) { kickOff_ = team; }
  void setScore(TeamColor team, int goals, Time now);
  /// Notifies a robot of a penalty, or of its end, and leaves it where it is.
  void setPenalty(std::size_t robot, Penalty penalty, Time now);
  /// Takes a robot off the field for as long as the rules demand.
  void penalize(World& world, std::size_t robot, Penalty penalty);
  /// Ends a robot's penalty and puts it back on the field.
  void giveBack(World& world, std::size_t robot);
  void startShootOut(World& world);

 private:
  static constexpr std::size_t nobody = ~std::size_t{0};
  /// Time within which a game controller may take the end of a half back.
  static constexpr std::int64_t undoMs = 10'000;
  /// The ball is in the goal when it is between the posts and behind the line as a whole.
  enum class BallPlace { onField, inGoal, out };

  static std::int64_t toMs(double seconds) { return std::llround(1000 * seconds); }

  void changeState(GameState state, Time now);
  void beginReady(World& world);
  void updateReady(World& world);
  void updatePlaying(World& world);
  BallPlace ballPlace(const World& world) const;
  void updateShot(World& world);
  void beginShot(World& world);
  void endShot(World& world, bool goal);
  /// Sets the score of an event of the shoot-out to that of the shoot-out.
  void setShots(GameEvent& event) const;
  void penalizeFouls(World& world);
  void giveBackWhoseTimeIsOver(World& world);
  bool standing(const World& world);
  void placeForKickOff(World& world);
  bool wellPlaced(World& world, std::size_t robot, bool inCircle) const;
  Pose2D kickOffPose(std::size_t robot) const;
  bool free(const World& world, const Vector2d& position, std::size_t except) const;
  /// Puts a robot at its place, or beside it so that there is room between it and the others.
  void placeRobot(World& world, std::size_t robot, const Pose2D& wanted);
  void putAway(World& world, std::size_t robot);
  void countGoal(World& world);
  void watchShots(const World& world);
  void watchStuckBall(World& world);
  void endHalf(World& world);
  void finish(World& world);
  GameEvent& record(const World& world, GameEventType type, TeamColor team, int number = 0);
  void notifyRobots(Time now);

  GameParameters parameters_;
  FieldDimensions field_;
  std::vector<Player> players_;
  FoulWatch fouls_;
  std::vector<GameControlData> data_;
  std::vector<Penalty> penalties_;
  std::vector<bool> away_;    ///< Beside the field.
  std::vector<Time> backAt_;  ///< End of the penalty; never() if the referee does not decide it.
  GameState state_ = GameState::initial;
  Time stateSince_;
  Time halfStarted_;
  bool clockRuns_ = false;
  bool kickedOff_ = false;  ///< The ball was played since the kick-off.
  int half_ = 1;
  TeamColor kickOff_;
  EnumArray<TeamColor, int> score_;
  std::optional<ShootOut> shootOut_;
  std::size_t shooter_ = nobody, keeper_ = nobody;
  bool led_ = false;
  std::int64_t ledTimeLeft_ = 0;  ///< Time left (ms) at `ledAt_`, as the game controller reported.
  Time ledAt_;
  std::vector<GameEvent> events_;
  struct Shot {
    int robot = -1;
    Time time = never();
  } shot_;  ///< The last shot towards the other team's goal, and the robot that made it.
  std::vector<RobotBody> lastSeen_;  ///< Each robot when it moved last.
  Time movedAt_;
  Vector2d ballReference_ = Vector2d::Zero();
  Time ballMovedAt_;
};

}  // namespace gt
