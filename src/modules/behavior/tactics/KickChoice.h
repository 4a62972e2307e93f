#pragma once
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "modules/behavior/tactics/WorldState.h"
#include "streams/Reflection.h"

namespace gt {

/// Chooses how to play the ball (report 3.8.2). The outcomes of each kick of the table are
/// predicted for each direction. Their worth depends on where the ball ends, which players are
/// nearer there, which part of the goal is free, and how long the robot needs to get behind the
/// ball. The best kick is the plan. As soon as some kick from the robot's present pose is about as
/// good, it is performed. Plans are made in each cycle. If plans last (`lasts`), a robot beside the
/// ball still plans in each cycle, and a plan lasts the longer, the farther away the ball is.
class KickChoice {
 public:
  /// The cost of time, and the thresholds for performing a kick.
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
          field<&H::enough>(
              "greatest difference by which a performed kick may be worse than the plan", {0, 1}),
          field<&H::impatience>("increase of `enough` for each second at the ball", {0, 1}),
          field<&H::reliable>(
              "least share of balls that a kick moves from the present position of the ball",
              {0, 1}),
          field<&H::strong>(
              "least distance that a kick moves the ball from its present position, as a share of "
              "that from its best position",
              {0, 1})};
    }
  };
  struct Parameters {
    // The worth of a position where the ball ends; a goal is worth 1.
    double ahead = 0.1;
    double shot = 0.5;
    double possession = 0.15;
    double opponentFar = 1200;
    double widestGoal = 1;
    double blocked = 0.25;
    // A goalie hurries, because its ball lies in front of its goal.
    Haste fieldPlayer;
    Haste goalie{.second = 0.15, .enough = 0.15, .impatience = 0.1, .reliable = 0.7, .strong = 0.3};
    // An opponent that comes to the ball.
    double opponentSpeed = 200;
    double opponentReach = 200;
    double disturbed = 0.7;
    double arrives = 1;
    // The robot's path to the ball.
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
    // The ball's path.
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
          field<&P::ahead>("worth of a ball at the opponent's ground line; negative at the own one",
                           {0, 1}),
          field<&P::shot>(
              "worth of each radian of the opponent's goal as seen from the ball; negative for the "
              "own goal",
              {0, 1}),
          field<&P::widestGoal>(Unit::rad, "greatest angle of a goal that counts", {0.1, 3.2}),
          field<&P::possession>(
              "worth of a ball to which the own team is a meter nearer than the opponents", {0, 1}),
          field<&P::opponentFar>(Unit::mm,
                                 "assumed distance from the ball of opponents that are not known",
                                 {0, 5000}),
          field<&P::blocked>("cost of a ball that is stopped by another player", {0, 1}),
          field<&P::fieldPlayer>("haste of field players to kick"),
          field<&P::goalie>("haste of a goalie to kick"),
          field<&P::opponentSpeed>(Unit::mmPerS, "speed of an opponent that comes to the ball",
                                   {10, 1000}),
          field<&P::opponentReach>(
              Unit::mm, "distance from the ball to the middle of an opponent that has reached it",
              {0, 1000}),
          field<&P::disturbed>(
              "share of balls that do not move because an opponent is also at the ball", {0, 1}),
          field<&P::arrives>(Unit::s, "uncertainty of an opponent's time of arrival at the ball",
                             {0.01, 10}),
          field<&P::walkSpeed>(Unit::mmPerS, "walking speed to the ball", {10, 1000}),
          field<&P::turnSpeed>(Unit::degPerS, "turning speed beside the ball", {1, 1000}),
          field<&P::aroundSpeed>(Unit::degPerS, "speed of walking around the ball", {1, 1000}),
          field<&P::aim>(Unit::deg, "standard deviation of the robot's heading when it kicks",
                         {0, 90}),
          field<&P::sees>(Unit::deg,
                          "standard deviation of the direction of the ball when it is kicked",
                          {0, 90}),
          field<&P::nearBall>(Unit::mm, "distance of the ball below which a robot is at the ball",
                              {0, 1000}),
          field<&P::stopping>(
              Unit::s, "time for which the robot continues to walk until a kick begins", {0, 1}),
          field<&P::misplaced>(Unit::mm, "error of the ball's position when a kick begins",
                               {0, 100}),
          field<&P::follows>(
              Unit::mm, "distance at which a kicked ball is searched in the direction of the kick",
              {0, 5000}),
          field<&P::accurate>(
              Unit::deg,
              "greatest spread of the directions of a kick from the present position of the ball",
              {0, 180}),
          field<&P::holds>(
              "share of reliable, strong and accurate that suffices for a kick that is about to "
              "begin",
              {0.1, 1}),
          field<&P::mostFalls>("share of falls above which a kick is not used", {0, 1}),
          field<&P::longest>(Unit::s, "greatest duration of kicks that are used", {0, 10}),
          field<&P::ownGoalRisk>(
              "greatest share of balls that may roll into the own goal after a goalie's kick",
              {0, 1}),
          field<&P::otherPlan>(
              "difference by which another plan must be better to replace the present one", {0, 1}),
          field<&P::begins>(Unit::ms, "time for which a robot tries to begin a kick", {0, 5000}),
          field<&P::lasts>(
              "how long a plan lasts, as a share of the time that the robot needs until it is "
              "near the ball; and how far the ball moves meanwhile, as a share of its distance",
              {0, 1}),
          field<&P::ballCorridor>(
              Unit::mm, "width of the corridor that a ball needs between obstacles", {0, 1000}),
          field<&P::handled>(Unit::mm,
                             "distance of the ball beyond which obstacles around it do not count",
                             {0, 5000}),
          field<&P::postClearance>(
              Unit::mm,
              "distance from a goal post to a ball's middle that surely enters the goal, or surely "
              "misses the own goal",
              {0, 300}),
          field<&P::wallClearance>(Unit::mm, "distance that the body's middle needs from a wall",
                                   {0, 1000}),
          field<&P::bodyLength>(
              Unit::mm,
              "distance from the ball to the middle of the hind part of a robot behind it",
              {0, 1000}),
          field<&P::cornerClearance>(
              "distance needed in a corner, as a multiple of that from a wall", {0, 10})};
    }
  };

  /// A kick, with the direction of the ball and the heading of the robot, on the field (rad).
  struct Plan {
    int motion = 0;  ///< index in MotionNet::motions; 0 none
    double direction = 0, facing = 0;
    double worth = 0;  ///< including the cost of time
  };

  /// The parameters must outlive this.
  explicit KickChoice(const Parameters& parameters);

  /// Chooses for a ball at a position relative to the robot (mm) that was last seen `unseen` (ms)
  /// ago. `obstacles` are relative to the robot. If not `plays`, nothing is planned; only the kick
  /// being performed is observed.
  void update(const WorldState& world, const ObstaclesModel& obstacles, const Vector2d& ball,
              std::int64_t unseen, bool plays = true);

  const Plan& plan() const { return plan_; }
  /// The point on the field (mm) in the direction of the last kick at which the ball is searched.
  const Vector2d& target() const { return target_; }
  /// The point on the field (mm) to which the performed kick, or else the plan, moves the ball if
  /// nothing is in its way; without both the position of the ball.
  const Vector2d& aim() const { return aim_; }
  /// The end of the last kick.
  Time lastKick() const { return lastKick_; }
  /// The index of the motion to be performed now, until it ends; 0: none.
  int now() const { return now_; }

 private:
  static constexpr int directions = 72;
  static constexpr double step = 2 * pi / directions;
  static constexpr int lengths = 9;
  static constexpr double lengthStep = 500;  // mm
  static constexpr double ownGoal = -1;      // worth

  /// A direction on the field (angle in rad and unit vector `along`), relative to the robot (the
  /// angle by which it must turn and unit vector `turned`), and whether walls leave room behind the
  /// ball.
  struct Facing {
    double angle = 0, turn = 0;
    Vector2d along = Vector2d::Zero(), turned = Vector2d::Zero();
    bool hasRoom = false;
  };
  /// The worth of the ball's paths of a length, in each direction. Directions are stored twice, so
  /// that following directions can be read without wrapping around.
  using Paths = std::array<double, 2 * directions>;
  /// The angle of a goal as seen from a point: its sine and cosine, both times the same factor.
  struct GoalAngle {
    double sine = 0, cosine = 0;
  };
  /// Predicted paths of a ball that is kicked from about a position relative to the robot, for a
  /// heading of the robot.
  struct Imagined {
    struct Path {
      int direction, length;  ///< indices
      double share;
    };
    std::vector<Path> paths;
    double missed = 0;
  };

  /// The effects of a kick on a ball at about a position, and the standard deviation of its
  /// direction by the errors of heading and ball (degrees).
  struct About {
    std::array<KickedPlace, 5> places;
    double spread = -1;

    bool operator==(const About& other) const;
  };
  /// A point where the ball ends (mm, on the field), and its worth.
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
  /// The predicted paths of a kick from its best position, for a robot with heading 0.
  const Imagined& fromBestPlace(int motion);
  /// The worth of a path for a robot that is turned by 0, 1, ... steps.
  const double* worthOf(const Imagined::Path& path) const {
    return &paths_[static_cast<std::size_t>(path.length)][static_cast<std::size_t>(path.direction)];
  }
  template <std::size_t count>
  void addTurned(const Imagined& imagined, std::array<double, count>& worth) const;
  /// The worth of the predicted paths for a robot that is turned by 0, 1, ... steps.
  template <std::size_t count>
  std::array<double, count> worthTurned(const Imagined& imagined) const;
  /// The share of balls that end in the own goal, for a robot that is turned by `turned` steps.
  double ownGoals(const Imagined& imagined, std::size_t turned) const;
  /// The worth of a kick that is performed after a time (s), in which an opponent may arrive.
  double worthIn(double seconds, double worth) const;
  bool isUsed(const KickDescription& kick) const;
  bool isSure(const KickDescription& kick, const Vector2d& place, double demand) const;
  double timeTo(const KickDescription& kick, double kickAngle, const Facing& facing) const;
  double disturbed(double seconds) const;
  double opponentArrival(const ObstaclesModel& obstacles) const;
  bool needsPlan() const;
  void choosePlan();
  void decide(std::int64_t unseen);
  /// The point to which a kick moves the ball from its present position (mm, on the field).
  Vector2d aimOf(const Plan& plan) const;
  Plan worthNow(int begun);
  bool hasRoom(const Facing& facing) const;
  void look(const ObstaclesModel& obstacles);

  bool isGoalie() const { return world_->player.role == PlayerRole::goalie; }
  const Haste& haste() const { return isGoalie() ? p_.goalie : p_.fieldPlayer; }

  const Parameters& p_;
  const WorldState* world_ = nullptr;
  Vector2d ball_ = Vector2d::Zero();         ///< mm, relative to the robot
  Vector2d ballOnField_ = Vector2d::Zero();  ///< mm
  std::array<Facing, directions> facings_;
  GoalAngle widest_;
  std::array<Paths, lengths> paths_{};
  double stays_ = 0;  ///< worth of a ball that stays where it is
  Imagined imagined_;
  /// for each motion, while About is unchanged
  std::vector<std::pair<About, Imagined>> fromBestPlace_;
  std::vector<Vector2d> own_, opponents_;  ///< mm, on the field
  double opponentArrives_ = 0;             ///< s, from now
  Plan plan_;
  /// position of the ball on the field at the time of the plan
  Vector2d plannedBall_ = Vector2d::Zero();
  int now_ = 0;
  Vector2d target_ = Vector2d::Zero(), aim_ = Vector2d::Zero();
  Time planned_ = never(), decided_ = never(), atBallSince_ = never(), lastKick_ = never();
};
static_assert(complete<KickChoice::Parameters>);

}  // namespace gt
