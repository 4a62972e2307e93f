#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "modules/behavior/tactics/KickChoice.h"
#include "streams/Reflection.h"

namespace gt {

/// What a player makes of the state of the world before its options decide: where the ball is, who
/// of the team goes to it, and where to play it (report 3.8.2).
class Tactics {
 public:
  struct Parameters {
    // The ball and the team.
    double ownBall = 600;
    double heard = 5000;
    double teammateWidth = 160;
    // Roles.
    double walkSpeed = 0.2;
    double turnSpeed = 0.0015;
    double wrongSide = 200;
    double unseenBall = 0.5;
    double longestUnseen = 10000;
    double gettingUp = 3000;
    double strikerAdvantage = 1500;
    double roleDelay = 1000;
    double forwardAdvantage = 300;
    // How to play the ball.
    KickChoice::Parameters kick;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field("ownBall", &P::ownBall, "ms",
                "so long after it was seen the robot's own ball counts, then the team's",
                {0, 60000}),
          field("heard", &P::heard, "ms", "messages of teammates that are older do not count",
                {0, 60000}),
          field("teammateWidth", &P::teammateWidth, "mm",
                "width of a teammate as an obstacle, where its message says it is", {0, 1000}),
          field("walkSpeed", &P::walkSpeed, "mm/ms", "speed in the estimated time to the ball",
                {0.01, 1}),
          field("turnSpeed", &P::turnSpeed, "rad/ms",
                "speed of turning to the ball in the estimated time", {1e-4, 0.01}),
          field("wrongSide", &P::wrongSide, "mm/rad",
                "further distance in that time for each rad around the ball to behind it",
                {0, 2000}),
          field("unseenBall", &P::unseenBall, "",
                "further time for each unit of time that the robot has not seen the ball", {0, 10}),
          field("longestUnseen", &P::longestUnseen, "ms", "a longer time counts like this one",
                {0, 60000}),
          field("gettingUp", &P::gettingUp, "ms", "further time of a robot that has fallen",
                {0, 60000}),
          field("roleDelay", &P::roleDelay, "ms",
                "so long a robot wants to become striker, or another supporter, until it does",
                {0, 10000}),
          field("strikerAdvantage", &P::strikerAdvantage, "ms",
                "so much later than others the present striker may reach the ball", {0, 60000}),
          field("forwardAdvantage", &P::forwardAdvantage, "mm",
                "so far behind others the present offensive supporter may stand", {0, 5000}),
          field("kick", &P::kick)};
    }
  };

  /// The parameters must outlive this.
  explicit Tactics(const Parameters& parameters) : p_{parameters}, kick_{parameters.kick} {}

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

  /// How long the robot needs to the ball, in ms: by distance, by the angle to turn, by how long
  /// the ball is out of sight and by being on the wrong side of it (report 3.8.2).
  double estimatedTimeToReachBall() const;
  /// The role of this cycle. A field player compares its time to the ball with what its teammates
  /// told; the present striker has a little advantage, so that roles do not flicker. The goalie
  /// stays goalie.
  const DynamicRole& role() const { return role_; }

  /// How to play the ball.
  const KickChoice& kick() const { return kick_; }

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

  void addTeammatesToObstacles();
  DynamicRole negotiateRole();
  bool ownBall() const;
  Vector2d goalToScoreIn() const { return {world_->field.xGroundline, 0}; }

  const Parameters& p_;
  const WorldState* world_ = nullptr;
  ObstaclesModel obstacles_;
  DynamicRole role_ = DynamicRole::defensiveSupporter, wanted_ = role_;
  Time wantedSince_ = never();
  KickChoice kick_;
  Goal ownGoal_, opponentGoal_;
};
static_assert(complete<Tactics::Parameters>);

}  // namespace gt
