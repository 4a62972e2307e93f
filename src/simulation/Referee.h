#pragma once
#include <array>
#include <vector>

#include "base/Enum.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/GameControlData.h"
#include "representations/infrastructure/Player.h"
#include "simulation/World.h"

namespace gt {

enum class GameEventType { kickOff, goal, halfTime, stuckBall, ballOut, placedRobot, gameOver };

/// Something that the referee saw or did.
struct GameEvent {
  GameEventType type = GameEventType::kickOff;
  Time time;
  TeamColor team = TeamColor::red;
  int number = 0;
  bool ownGoal = false;
  Vector2d ballPosition = Vector2d::Zero();
  int scoreRed = 0;
  int scoreBlue = 0;

  static constexpr auto fields() {
    return std::tuple{
        field("type", &GameEvent::type),
        field("time", &GameEvent::time, "ms"),
        field("team", &GameEvent::team, "",
              "that kicks off, or scores, or whose robot was put by hand"),
        field(
            "number", &GameEvent::number, "",
            "goal: the player that touched the ball last, of the other team if it is an own goal; "
            "placedRobot: the player; 0 nobody"),
        field("ownGoal", &GameEvent::ownGoal),
        field("ballPosition", &GameEvent::ballPosition, "mm", "on the field"),
        field("scoreRed", &GameEvent::scoreRed),
        field("scoreBlue", &GameEvent::scoreBlue)};
  }
};
static_assert(complete<GameEvent>);

/// Leads the game by the rules of 2003 (facts, 2.2): initial, ready, set, playing; goals,
/// kick-offs, halves, and balls that are stuck. The clock runs from the first whistle on and does
/// not stop; the teams keep their goals for both halves. The other team than in the first half
/// kicks off in the second. A goal is an own goal if the defender who touched the ball last gave it
/// its way in; one that deflects a shot on goal does not.
class Referee {
 public:
  Referee(const GameParameters& parameters, const FieldDimensions& field,
          const std::vector<Player>& players);

  /// Looks at the world after a tick, and puts the ball and badly placed robots by hand.
  void update(World& world);

  const GameControlData& dataFor(std::size_t robot) const { return data_[robot]; }
  GameState state() const { return state_; }
  int half() const { return half_; }
  int score(TeamColor team) const { return score_[team]; }
  TeamColor kickOff() const { return kickOff_; }
  /// Time left in this half (ms).
  std::int64_t timeLeft(Time now) const;
  const std::vector<GameEvent>& events() const { return events_; }

  /// A person's decisions.
  void changeState(GameState state, Time now);
  void setKickOff(TeamColor team) { kickOff_ = team; }
  void setPenalty(std::size_t robot, Penalty penalty, Time now);

 private:
  void updateReady(World& world);
  void updatePlaying(World& world);
  bool standing(const World& world);
  void placeForKickOff(World& world);
  bool wellPlaced(const World& world, std::size_t robot, bool inCircle) const;
  Pose2D kickOffPose(std::size_t robot) const;
  bool free(const World& world, const Vector2d& position, std::size_t except) const;
  void placeRobot(World& world, std::size_t robot);
  void countGoal(World& world);
  void watchShots(const World& world);
  void watchStuckBall(World& world);
  void endHalf(World& world);
  void record(const World& world, GameEventType type, TeamColor team, int number = 0,
              bool ownGoal = false);
  void tellRobots(Time now);

  GameParameters parameters_;
  FieldDimensions field_;
  std::vector<Player> players_;
  std::vector<GameControlData> data_;
  std::vector<Penalty> penalties_;
  GameState state_ = GameState::initial;
  Time stateSince_;
  Time halfStarted_;
  bool clockRuns_ = false;
  int half_ = 1;
  TeamColor kickOff_;
  EnumArray<TeamColor, int> score_;
  std::vector<GameEvent> events_;
  struct Shot {
    int robot = -1;
    Time time = never();
  } shot_;  ///< The last ball on its way into the other team's goal, and whose it was.
  std::vector<Pose2D> lastPoses_;
  Time movedAt_;
  Vector2d ballReference_ = Vector2d::Zero();
  Time ballMovedAt_;
};

}  // namespace gt
