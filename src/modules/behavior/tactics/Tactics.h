#pragma once
#include "base/Geometry.h"
#include "base/Time.h"
#include "modules/behavior/tactics/WorldState.h"
#include "streams/Reflection.h"

namespace gt {

/// What a player makes of the state of the world before its options decide: where the ball is, who
/// of the team goes to it, and where to play it (report 3.8.2).
class Tactics {
 public:
  struct Parameters {
    // The ball and the team.
    double ownBall = 2000;
    double heard = 2000;
    double teammateWidth = 160;
    // Roles.
    double walkSpeed = 0.2;
    double turnSpeed = 0.0015;
    double wrongSide = 200;
    double unseenBall = 0.5;
    double strikerAdvantage = 1500;
    double forwardAdvantage = 300;
    // Where to play the ball.
    double ownGoalRadius = 900;
    double ownGoalDepth = 200;
    double ownGoalAngle = 1.2;
    double besideGoal = 250;
    double beforeGoal = 500;
    double middle = 200;
    double aside = 0.5;
    double behindGoalLine = 50;
    // Past obstacles.
    double handled = 700;
    double shot = 1600;
    double ballCorridor = 180;
    double freeAhead = 500;
    double mostAround = 40;
    double openGoal = 0.8;
    // Walls.
    double wallClearance = 85;
    double bodyLength = 205;
    double cornerClearance = 1.4;
    // Aim.
    double goalShare = 0.4;
    double leastTolerance = 5;
    double mostTolerance = 15;

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
                "further time for each unit of time that the ball has not been known", {0, 10}),
          field("strikerAdvantage", &P::strikerAdvantage, "ms",
                "so much later than others the present striker may reach the ball", {0, 60000}),
          field("forwardAdvantage", &P::forwardAdvantage, "mm",
                "so far behind others the present offensive supporter may stand", {0, 5000}),
          field("ownGoalRadius", &P::ownGoalRadius, "mm",
                "nearer to the own goal the ball is played away from it", {0, 5000}),
          field("ownGoalDepth", &P::ownGoalDepth, "mm",
                "how far behind the goal line the place lies from which it is played away",
                {0, 1000}),
          field("ownGoalAngle", &P::ownGoalAngle, "rad",
                "greatest angle to the field's length at which it is played away", {0, 1.5}),
          field("besideGoal", &P::besideGoal, "mm",
                "nearer to the opponent's ground line, beside the goal, no shot goes in: the ball "
                "is played back",
                {0, 2000}),
          field("beforeGoal", &P::beforeGoal, "mm",
                "distance from that line of the place to which it is played back", {0, 2000}),
          field("middle", &P::middle, "mm",
                "nearer to the field's middle axis the robot aims to the side to which it is "
                "turned, else to the far side of the goal",
                {0, 2000}),
          field("aside", &P::aside, "",
                "where it aims, from the middle of the goal (0) to the post (1)", {0, 1}),
          field("behindGoalLine", &P::behindGoalLine, "mm", "how far behind the goal line it aims",
                {0, 1000}),
          field("handled", &P::handled, "mm",
                "obstacles around a ball that is farther away do not count", {0, 5000}),
          field("shot", &P::shot, "mm",
                "nearer to the goal the free part of the goal decides, else a free direction",
                {0, 5000}),
          field("ballCorridor", &P::ballCorridor, "mm",
                "width of the corridor that a ball needs between obstacles", {0, 1000}),
          field("freeAhead", &P::freeAhead, "mm", "length of that corridor", {0, 5000}),
          field("mostAround", &P::mostAround, "degree",
                "greatest angle by which the robot plays past obstacles", {0, 180}),
          field("openGoal", &P::openGoal, "",
                "a goal of which more than this share is free counts as open", {0, 1}),
          field("wallClearance", &P::wallClearance, "mm",
                "room that the body's middle needs beside a wall", {0, 1000}),
          field("bodyLength", &P::bodyLength, "mm",
                "from the ball to the middle of the hind part of a robot behind it", {0, 1000}),
          field("cornerClearance", &P::cornerClearance, "",
                "room in a corner, as a multiple of that beside a wall", {0, 10}),
          field("goalShare", &P::goalShare, "",
                "angle by which a kick may go astray, as a share of half the goal's", {0, 1}),
          field("leastTolerance", &P::leastTolerance, "degree", "least such angle", {0, 90}),
          field("mostTolerance", &P::mostTolerance, "degree", "greatest such angle", {0, 90})};
    }
  };

  /// The parameters must outlive this.
  explicit Tactics(const Parameters& parameters) : p_{parameters} {}

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

  /// The direction in which to play the ball, on the field, in rad: to the opponent's goal, out of
  /// the own one for a ball beside it.
  double kickDirection() const;
  /// How far a kick may go astray to either side, in rad: as long as it still hits the goal, and
  /// more generously from far away.
  double kickTolerance() const;

 private:
  void addTeammatesToObstacles();
  DynamicRole negotiateRole() const;
  bool ownBall() const;
  bool hasRoom(const Vector2d& ball, double facing) const;
  double pastObstacles(double wanted) const;
  double wantedDirection() const;
  Vector2d opponentGoal() const { return {world_->field.xGroundline, 0}; }
  Vector2d ownGoal() const { return {-world_->field.xGroundline, 0}; }

  const Parameters& p_;
  const WorldState* world_ = nullptr;
  ObstaclesModel obstacles_;
  DynamicRole role_ = DynamicRole::defensiveSupporter;
};
static_assert(complete<Tactics::Parameters>);

}  // namespace gt
