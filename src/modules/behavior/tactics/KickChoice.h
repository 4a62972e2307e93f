#pragma once
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "modules/behavior/tactics/WorldState.h"
#include "streams/Reflection.h"

namespace gt {

/// Chooses how to play the ball (report 3.8.2): the outcomes of each kick of the table, in each
/// direction, are imagined, from where the ball ends and who is nearer there, which part of the
/// goal is free, and how long it takes the robot to get behind the ball. The best of them is the
/// plan. As soon as some kick from where the robot stands is about as good, it is to be performed.
/// It plans in each cycle; if plans last (`lasts`), a robot beside the ball still does, and the
/// farther away the ball is, the longer a plan lasts.
class KickChoice {
 public:
  /// What a second costs, and what is good enough.
  struct Haste {
    double second = 0.03;
    double enough = 0;
    double impatience = 0.01;
    double reliable = 0.9;
    double strong = 0.5;

    static constexpr auto fields() {
      using H = Haste;
      return Fields{
          field<&H::second>("cost of a second until the ball is on its way", {0, 1}),
          field<&H::enough>("by how much a kick may be worse than the plan", {0, 1}),
          field<&H::impatience>("by how much more with each second at the ball", {0, 1}),
          field<&H::reliable>("share of the balls that a kick moves from where the ball lies",
                              {0, 1}),
          field<&H::strong>(
              "how far it moves them from there, as a share of the way from its best place",
              {0, 1})};
    }
  };
  struct Parameters {
    // What an end of the ball is worth; a goal is worth 1.
    double ahead = 0.1;
    double shot = 0.5;
    double possession = 0.15;
    double opponentFar = 1200;
    double widestGoal = 1;
    double blocked = 0.25;
    // A goalie hurries: its ball lies before its goal.
    Haste fieldPlayer;
    Haste goalie{.second = 0.15, .enough = 0.15, .impatience = 0.1, .reliable = 0.7, .strong = 0.3};
    // An opponent that comes to the ball.
    double opponentSpeed = 200;
    double opponentReach = 200;
    double disturbed = 0.7;
    double arrives = 1;
    // The way to the ball.
    double walkSpeed = 230;
    double turnSpeed = 90;
    double aroundSpeed = 60;
    // At the ball.
    double aim = 5;
    double sees = 4;
    double nearBall = 350;
    double stopping = 0.08;
    double misplaced = 10;
    double follows = 1500;
    double accurate = 20;
    double holds = 0.7;
    double mostFalls = 0.02;
    double longest = 3;
    double ownGoalRisk = 0.005;
    // Memory.
    double otherPlan = 0.08;
    double begins = 1200;
    double lasts = 0;
    // The ball's way.
    double ballCorridor = 200;
    double handled = 800;
    double postClearance = 60;
    // Walls.
    double wallClearance = 85;
    double bodyLength = 205;
    double cornerClearance = 1.4;

    static constexpr auto fields() {
      using P = Parameters;
      return Fields{
          field<&P::ahead>(
              "worth of a ball at the opponent's ground line; at the own one it is as bad", {0, 1}),
          field<&P::shot>(
              "worth of each radian at which the opponent's goal is seen from the ball; the own "
              "one's is as bad",
              {0, 1}),
          field<&P::widestGoal>(Unit::rad, "a wider goal counts like this", {0.1, 3.2}),
          field<&P::possession>(
              "worth of a ball that a teammate reaches a meter before any opponent", {0, 1}),
          field<&P::opponentFar>(Unit::mm, "distance of opponents that nobody knows of", {0, 5000}),
          field<&P::blocked>("cost of a ball that somebody stops", {0, 1}),
          field<&P::fieldPlayer>("how soon field players kick"),
          field<&P::goalie>("how soon a goalie does"),
          field<&P::opponentSpeed>(Unit::mmPerS, "of one that comes to the ball", {10, 1000}),
          field<&P::opponentReach>(Unit::mm, "from the ball to the middle of one that is there",
                                   {0, 1000}),
          field<&P::disturbed>(
              "share of the balls that stay where they are because an opponent is there, too",
              {0, 1}),
          field<&P::arrives>(Unit::s, "so uncertain it is when an opponent is there", {0.01, 10}),
          field<&P::walkSpeed>(Unit::mmPerS, "to the ball", {10, 1000}),
          field<&P::turnSpeed>(Unit::degPerS, "beside the ball", {1, 1000}),
          field<&P::aroundSpeed>(Unit::degPerS, "around the ball", {1, 1000}),
          field<&P::aim>(Unit::deg, "how far the robot faces elsewhere than planned", {0, 90}),
          field<&P::sees>(Unit::deg, "how far the ball lies elsewhere than seen", {0, 90}),
          field<&P::nearBall>(Unit::mm, "how near it a robot is at the ball", {0, 1000}),
          field<&P::stopping>(Unit::s, "so long the robot goes on walking until it begins to kick",
                              {0, 1}),
          field<&P::misplaced>(Unit::mm, "how far the ball lies elsewhere when a kick begins",
                               {0, 100}),
          field<&P::follows>(
              Unit::mm, "so far off a kicked ball is looked for in the direction in which it went",
              {0, 5000}),
          field<&P::accurate>(
              Unit::deg, "how far the balls of a kick spread from where the ball lies, at most",
              {0, 180}),
          field<&P::holds>(
              "share of reliable, strong and accurate that is enough for a kick that is about to "
              "begin",
              {0.1, 1}),
          field<&P::mostFalls>("share of falls after which a kick is not used", {0, 1}),
          field<&P::longest>(Unit::s, "kicks that take longer are not used", {0, 10}),
          field<&P::ownGoalRisk>(
              "share of the balls that may roll into the own goal after a goalie's kick", {0, 1}),
          field<&P::otherPlan>("by how much another plan has to be better", {0, 1}),
          field<&P::begins>(Unit::ms, "so long a robot tries to begin a kick", {0, 5000}),
          field<&P::lasts>(
              "how long a plan lasts, as a share of the time that the robot needs until it is "
              "near the ball; and how far the ball moves meanwhile, as a share of its distance",
              {0, 1}),
          field<&P::ballCorridor>(
              Unit::mm, "width of the corridor that a ball needs between obstacles", {0, 1000}),
          field<&P::handled>(Unit::mm, "obstacles around a ball that is farther away do not count",
                             {0, 5000}),
          field<&P::postClearance>(
              Unit::mm,
              "from a post to the middle of a ball that surely goes in, or surely not into the "
              "own goal",
              {0, 300}),
          field<&P::wallClearance>(Unit::mm, "room that the body's middle needs beside a wall",
                                   {0, 1000}),
          field<&P::bodyLength>(Unit::mm,
                                "from the ball to the middle of the hind part of a robot behind it",
                                {0, 1000}),
          field<&P::cornerClearance>("room in a corner, as a multiple of that beside a wall",
                                     {0, 10})};
    }
  };

  /// A kick, where the ball goes and where the robot faces for it, on the field (rad).
  struct Plan {
    int motion = 0;  ///< index in MotionNet::motions; 0 none
    double direction = 0, facing = 0;
    double worth = 0;  ///< with the cost of the time it takes
  };

  /// The parameters must outlive this.
  explicit KickChoice(const Parameters& parameters);

  /// Chooses for a ball at a place relative to the robot (mm) that was last seen some ms ago, with
  /// obstacles relative to the robot. One that does not play the ball now only sees what it
  /// performs.
  void update(const WorldState& world, const ObstaclesModel& obstacles, const Vector2d& ball,
              std::int64_t unseen, bool plays = true);

  const Plan& plan() const { return plan_; }
  /// Where the last kick sent the ball, on the field (mm), and when it ended.
  const Vector2d& target() const { return target_; }
  /// Where the kick that is performed, or the plan, brings the ball if nothing is in its way, on
  /// the field (mm). Without either: where the ball lies.
  const Vector2d& aim() const { return aim_; }
  Time lastKick() const { return lastKick_; }
  /// The motion to be performed now, until it ends; 0 none.
  int now() const { return now_; }

 private:
  static constexpr int directions = 72;
  static constexpr double step = 2 * pi / directions;
  static constexpr int lengths = 9;
  static constexpr double lengthStep = 500;  // mm
  static constexpr double ownGoal = -1;      // worth

  /// A direction on the field: an angle and a unit vector; relative to the robot, the angle by
  /// which it has to turn and a unit vector; whether walls leave room behind the ball.
  struct Facing {
    double angle = 0, turn = 0;
    Vector2d along = Vector2d::Zero(), turned = Vector2d::Zero();
    bool hasRoom = false;
  };
  /// The worth of the ball's paths of a length, in each direction. Directions come twice, so that
  /// none is the last of those that follow another one.
  using Paths = std::array<double, 2 * directions>;
  /// The angle at which a goal is seen: its sine and cosine, both times the same.
  struct GoalAngle {
    double sine = 0, cosine = 0;
  };
  /// Where a ball goes that lies about at a place before a robot that faces a direction.
  struct Imagined {
    struct Path {
      int direction, length;  ///< indices
      double share;
    };
    std::vector<Path> paths;
    double missed = 0;
  };

  /// What a kick does with a ball that lies about at a place, and how far the robot faces elsewhere
  /// and the ball lies elsewhere (degrees, standard deviation).
  struct About {
    std::array<KickedPlace, 5> places;
    double spread = -1;

    bool operator==(const About& other) const;
  };
  /// A place where the ball ends (mm, on the field), and its worth.
  struct End {
    Vector2d place;
    double worth;
  };

  Vector2d clampedToField(const Vector2d& place) const;
  double worthOf(const Vector2d& end) const;
  GoalAngle angleOfGoal(double x, const Vector2d& end) const;
  void judgePaths(int direction, const End& start, double free);
  About about(const KickDescription& kick, const Vector2d& place) const;
  static void imagine(const About& about, double facing, Imagined& imagined);
  /// What is imagined of a kick from its best place, for a robot that faces 0.
  const Imagined& fromBestPlace(int motion);
  /// The worth of a path, for a robot that is turned by 0, 1, ... steps.
  const double* worthOf(const Imagined::Path& path) const {
    return &paths_[static_cast<std::size_t>(path.length)][static_cast<std::size_t>(path.direction)];
  }
  template <std::size_t count>
  void addTurned(const Imagined& imagined, std::array<double, count>& worth) const;
  /// The worth of what is imagined, likewise.
  template <std::size_t count>
  std::array<double, count> worthTurned(const Imagined& imagined) const;
  /// The share of the balls that end in the own goal, for a robot that is turned by so many steps.
  double ownGoals(const Imagined& imagined, std::size_t turned) const;
  /// What it is worth if it takes so many seconds.
  double worthIn(double seconds, double worth) const;
  bool isUsed(const KickDescription& kick) const;
  bool isSure(const KickDescription& kick, const Vector2d& place, double demand) const;
  double timeTo(const KickDescription& kick, double kickAngle, const Facing& facing) const;
  double disturbed(double seconds) const;
  double opponentArrival(const ObstaclesModel& obstacles) const;
  bool needsPlan() const;
  void choosePlan();
  void decide(std::int64_t unseen);
  /// Where a kick brings the ball from where it lies (mm, on the field).
  Vector2d aimOf(const Plan& plan) const;
  Plan worthNow(int begun);
  bool hasRoom(const Facing& facing) const;
  void look(const ObstaclesModel& obstacles);

  bool isGoalie() const { return world_->player.role == PlayerRole::goalie; }
  const Haste& haste() const { return isGoalie() ? p_.goalie : p_.fieldPlayer; }

  const Parameters& p_;
  const WorldState* world_ = nullptr;
  Vector2d ball_ = Vector2d::Zero();         ///< relative to the robot
  Vector2d ballOnField_ = Vector2d::Zero();  ///< mm
  std::array<Facing, directions> facings_;
  GoalAngle widest_;
  std::array<Paths, lengths> paths_{};
  double stays_ = 0;  ///< worth of a ball that stays where it is
  Imagined imagined_;
  std::vector<std::pair<About, Imagined>> fromBestPlace_;  ///< by motion; as long as it is so
  std::vector<Vector2d> own_, opponents_;                  ///< on the field
  double opponentArrives_ = 0;                             ///< s, from now
  Plan plan_;
  Vector2d plannedBall_ = Vector2d::Zero();  ///< where it was on the field for the plan
  int now_ = 0;
  Vector2d target_ = Vector2d::Zero(), aim_ = Vector2d::Zero();
  Time planned_ = never(), decided_ = never(), atBallSince_ = never(), lastKick_ = never();
};
static_assert(complete<KickChoice::Parameters>);

}  // namespace gt
