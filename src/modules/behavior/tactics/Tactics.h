#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "modules/behavior/tactics/ButtonControl.h"
#include "modules/behavior/tactics/KickChoice.h"
#include "modules/behavior/tactics/RoleNegotiation.h"
#include "modules/behavior/tactics/RollingBall.h"
#include "streams/Reflection.h"

namespace gt {

/// What a player makes of the state of the world before its options decide: where the ball is, who
/// of the team goes to it, and where to play it (report 3.8.2).
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
              Unit::ms, "so long after it was seen the robot's own ball counts, then the team's",
              {0, 60000}),
          field<&P::teammateWidth>(
              Unit::mm, "width of a teammate as an obstacle, where its message says it is",
              {0, 1000}),
          field<&P::obstacleMemory>(
              Unit::ms, "an obstacle that was not seen for so long does not count, as robots move",
              {0, 1e5}),
          field<&P::deceleration>(Unit::mmPerS2, "of a rolling ball", {0, 10000}),
          field<&P::walkSpeed>(Unit::mmPerMs, "speed in the estimated time to the ball", {0.01, 1}),
          field<&P::turnSpeed>(Unit::radPerMs, "speed of turning to the ball in the estimated time",
                               {1e-4, 0.01}),
          field<&P::wrongSide>(
              Unit::mmPerRad,
              "further distance in that time for each rad around the ball to behind it", {0, 2000}),
          field<&P::unseenBall>(
              "further time for each unit of time that the robot has not seen the ball", {0, 10}),
          field<&P::longestUnseen>(Unit::ms, "a longer time counts like this one", {0, 60000}),
          field<&P::blockedWay>(Unit::ms, "further time if the direct way to the ball is blocked",
                                {0, 60000}),
          field<&P::besideBall>(Unit::mm,
                                "obstacles that are nearer to the ball do not block the way to it",
                                {0, 5000}),
          field<&P::roles>(),
          field<&P::connected>(
              Unit::ms, "a teammate from which nothing was heard for so long is not connected",
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

  /// Begins a cycle: enters the teammates that sent where they are among the obstacles, for the
  /// camera does not see what is behind the robot, and negotiates the role. The state of the world
  /// must exist as long as the cycle.
  void update(const WorldState& world);

  const WorldState& world() const { return *world_; }
  const ObstaclesModel& obstacles() const { return obstacles_; }

  /// The known ball relative to the robot: its own if it saw it lately, else the team's
  /// (report 3.8.2).
  Vector2d knownBall() const;
  Vector2d knownBallOnField() const;
  /// In ms.
  std::int64_t knownBallAge() const;

  /// Where and when the own ball crosses the line to the robot's left and right: never, long from
  /// now.
  Crossing crossing() const;

  /// The role of this cycle; the goalie stays goalie.
  DynamicRole role() const { return message().role; }
  /// What the teammates have to know.
  const BehaviorTeamMessage& message() const { return message_; }

  /// How to play the ball.
  const KickChoice& kick() const { return kick_; }

  /// The state of the game.
  const ButtonControl& game() const { return buttons_; }
  /// How many teammates the robot is connected with: heard lately.
  int connections() const;

  /// When the teams scored last.
  Time ownGoal() const { return ownGoal_.time; }
  Time opponentGoal() const { return opponentGoal_.time; }

 private:
  /// The last goal of a team.
  struct Goal {
    int score = 0;  ///< with it
    Time time = never();

    void update(int scoreNow, Time now) {
      if (scoreNow > score) time = now;
      score = scoreNow;
    }
  };

  void forgetOldObstacles();
  void addTeammatesToObstacles();
  /// How long the robot needs to the ball, in ms: by distance, by the angle to turn, by how long
  /// the ball is out of sight, by being on the wrong side of it and by obstacles (report 3.8.2).
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
