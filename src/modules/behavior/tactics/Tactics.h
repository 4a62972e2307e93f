#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "modules/behavior/tactics/ButtonControl.h"
#include "modules/behavior/tactics/KickChoice.h"
#include "modules/behavior/tactics/RoleNegotiation.h"
#include "modules/behavior/tactics/RollingBall.h"
#include "streams/Reflection.h"

namespace gt {

/// Evaluates the state of the world before the options decide: where the ball is, which player of
/// the team goes to it, and where to play it (report 3.8.2).
class Tactics {
 public:
  struct Parameters {
    // The ball and the team.
    double ownBall = 600;
    double teammateWidth = 160;
    double obstacleMemory = 1200;
    double deceleration = 250;
    // Roles.
    double walkSpeed = 0.2;
    double turnSpeed = 0.0015;
    double wrongSide = 200;
    double unseenBall = 0.5;
    double longestUnseen = 10000;
    double blockedWay = 1000;
    double besideBall = 400;
    RoleNegotiation::Parameters roles;
    // The game without a game manager.
    double connected = 5000;
    ButtonControl::Parameters buttons;
    // How to play the ball.
    KickChoice::Parameters kick;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::ownBall>(
              Unit::ms,
              "time since the ball was seen during which the robot's own ball counts, then the "
              "team's",
              {0, 60000}),
          field<&P::teammateWidth>(
              Unit::mm, "width of a teammate as an obstacle, at the position that it sent",
              {0, 1000}),
          field<&P::obstacleMemory>(
              Unit::ms,
              "time since an obstacle was seen after which it does not count, as robots move",
              {0, 1e5}),
          field<&P::deceleration>(Unit::mmPerS2, "deceleration of a rolling ball", {0, 10000}),
          field<&P::walkSpeed>(
              Unit::mmPerMs, "walking speed assumed in the estimated time to the ball", {0.01, 1}),
          field<&P::turnSpeed>(Unit::radPerMs,
                               "turning speed assumed in the estimated time to the ball",
                               {1e-4, 0.01}),
          field<&P::wrongSide>(
              Unit::mmPerRad,
              "distance added in the estimated time to the ball for each rad around the ball to "
              "the place behind it",
              {0, 2000}),
          field<&P::unseenBall>(
              "increase of the estimated time to the ball per time since the ball was seen",
              {0, 10}),
          field<&P::longestUnseen>(
              Unit::ms,
              "greatest time since the ball was seen that counts in the estimated time to it",
              {0, 60000}),
          field<&P::blockedWay>(
              Unit::ms,
              "time added to the estimated time to the ball if the direct path is blocked",
              {0, 60000}),
          field<&P::besideBall>(
              Unit::mm, "distance from the ball below which obstacles do not block the path to it",
              {0, 5000}),
          field<&P::roles>(),
          field<&P::connected>(Unit::ms,
                               "time without a message after which a teammate is not connected",
                               {0, 60000}),
          field<&P::buttons>(),
          field<&P::kick>()};
    }
  };

  /// The parameters must outlive this.
  explicit Tactics(const Parameters& parameters)
      : p_{parameters},
        roles_{parameters.roles},
        buttons_{parameters.buttons},
        kick_{parameters.kick} {}

  /// Begins a cycle: adds the teammates that sent their positions to the obstacles, because the
  /// camera does not see behind the robot, and negotiates the role. The state of the world must
  /// outlive the cycle.
  void update(const WorldState& world);

  const WorldState& world() const { return *world_; }
  const ObstaclesModel& obstacles() const { return obstacles_; }

  /// The known ball relative to the robot (mm): its own if it saw it lately, otherwise the team's
  /// (report 3.8.2).
  Vector2d knownBall() const;
  /// The known ball on the field (mm).
  Vector2d knownBallOnField() const;
  /// The time (ms) since the known ball was seen.
  std::int64_t knownBallAge() const;

  /// The point and time at which the robot's own ball crosses the line to its left and right. If it
  /// does not, the time is very long.
  Crossing crossing() const;

  /// The role of this cycle; that of the goalie never changes.
  DynamicRole role() const { return message().role; }
  /// The message to the teammates.
  const BehaviorTeamMessage& message() const { return message_; }

  /// How to play the ball.
  const KickChoice& kick() const { return kick_; }

  /// The state of the game.
  const ButtonControl& game() const { return buttons_; }
  /// The number of connected teammates, from which messages were received lately.
  int connections() const;

  /// The times of the last goals scored by each team.
  Time ownGoal() const { return ownGoal_.time; }
  Time opponentGoal() const { return opponentGoal_.time; }

 private:
  /// The last goal of a team.
  struct Goal {
    int score = 0;  ///< including this goal
    Time time = never();

    void update(int scoreNow, Time now) {
      if (scoreNow > score) time = now;
      score = scoreNow;
    }
  };

  void forgetOldObstacles();
  void addTeammatesToObstacles();
  /// The estimated time (ms) that the robot needs to the ball: by the distance, the angle to turn,
  /// the time since the ball was seen, being on the wrong side of it and obstacles (report 3.8.2).
  double estimatedTimeToReachBall() const;
  bool plays() const;
  void negotiateRole();
  bool ownBall() const;
  Vector2d goalToScoreIn() const { return {world_->field.xGroundline, 0}; }

  const Parameters& p_;
  const WorldState* world_ = nullptr;
  ObstaclesModel obstacles_;
  RoleNegotiation roles_;
  BehaviorTeamMessage message_;
  ButtonControl buttons_;
  KickChoice kick_;
  Goal ownGoal_, opponentGoal_;
};
static_assert(complete<Tactics::Parameters>);

}  // namespace gt
