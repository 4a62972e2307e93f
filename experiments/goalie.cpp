// What a goalie alone does with balls that lie around it, and with balls that roll to its goal.
#include <algorithm>
#include <array>
#include <cmath>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "Teams.h"
#include "base/Statistics.h"

namespace gt {
namespace {

/// Where a goalie guards, before its ground line (mm).
constexpr double guardsBefore = 120;
/// How long it has to go back there, and to see the ball (s).
constexpr double goesBack = 8;

/// A goalie of its own in a match without a referee.
class LonelyGoalie {
 public:
  static Result<LonelyGoalie> make(const Job& job, const DataRoot& root) {
    auto options = matchOptions(job, root);
    if (!options) return options.error();
    options->scene = root.path("scenes/goalie.scene");
    auto match = Match::make(*options);
    if (!match) return match.error();
    return LonelyGoalie{*std::move(match)};
  }

  const FieldDimensions& field() const { return match_->configuration().get<FieldDimensions>(); }
  double deceleration() const { return match_->simulation().scene().physics.deceleration; }
  /// Has it guard while a ball lies at a place. Who has walked far away is put back.
  void guard(const Vector2d& ball) {
    constexpr double far = 700;  // mm
    const Vector2d guards{guardsBefore - field().xGroundline, 0};
    if ((world().robot(0).pose.translation - guards).norm() > far)
      world().placeRobot(0, {0, guards});
    world().placeBall(0, ball);
    run(goesBack);
  }
  void placeBall(const Vector2d& ball, const Vector2d& speed = {0, 0}) {
    world().placeBall(0, ball, speed);
  }
  void run(double seconds) {
    for (double time = 0; time < seconds; time += tickSeconds) step();
  }
  void step() { match_->step(); }
  const BallState& ball() const { return match_->simulation().world().ball(0); }
  bool isInGoal() const { return ball().position.x() < -field().xGroundline - field().ballRadius; }
  bool isInArea() const {
    return ball().position.x() < -field().xPenaltyArea &&
           std::abs(ball().position.y()) < field().yPenaltyArea;
  }
  Result<void> soundness() const { return match_->soundness(); }

 private:
  explicit LonelyGoalie(std::unique_ptr<Match> match) : match_{std::move(match)} {}
  World& world() { return match_->simulation().world(); }

  std::unique_ptr<Match> match_;
};

/// 28 places of its penalty area around a goalie that guards (mm).
std::vector<Vector2d> grid() {
  std::vector<Vector2d> places;
  for (const double x : {-2050., -1950., -1850., -1700.})
    for (const double y : {160., 280., 420.}) {
      places.emplace_back(x, y);
      places.emplace_back(x, -y);
    }
  for (const double x : {-1820., -1760., -1700., -1640.}) places.emplace_back(x, 0);
  return places;
}

/// Balls at rest around it.
Result<Measurement> clearBalls(LonelyGoalie& goalie) {
  constexpr double longest = 30;  // s
  constexpr double far = 600;     // mm, where it sees the ball before
  int cleared = 0, ownGoals = 0;
  RunningStatistics seconds;
  for (const Vector2d& place : grid()) {
    goalie.guard({far, 0});
    goalie.placeBall(place);
    double time = 0;
    for (; time < longest && goalie.isInArea() && !goalie.isInGoal(); time += tickSeconds)
      goalie.step();
    if (goalie.isInGoal()) {
      ++ownGoals;
    } else if (!goalie.isInArea()) {
      ++cleared;
      seconds.add(time);
    }
  }
  if (const auto done = goalie.soundness(); !done) return done.error();
  Measurement measured;
  measured.add("play.goalie.grid.cleared", "of 28", cleared, Aim::atLeast(26));
  measured.add("play.goalie.grid.ownGoals", "of 28", ownGoals, Aim::atMost(0));
  if (cleared > 0) measured.add("play.goalie.grid.seconds", "s", seconds.mean());
  return measured;
}

/// Shots from six places, at eleven points of the goal line each.
Result<Measurement> shoot(LonelyGoalie& goalie) {
  constexpr std::array<std::array<double, 2>, 6> from{
      {{-1400, 0}, {-1300, -450}, {-1200, 500}, {-900, 0}, {-700, -600}, {-500, 500}}};  // mm
  constexpr double atLine = 1050;             // mm/s, of a ball that nobody stops
  constexpr double longest = 4;               // s
  constexpr double inner = 100, outer = 200;  // mm from the middle of the goal
  int letIn = 0, touched = 0, letInInner = 0, letInOuter = 0;
  for (const auto& [x, y] : from)
    for (double target = -250; target <= 250; target += 50) {
      const Vector2d place{x, y}, way = Vector2d{-goalie.field().xGroundline, target} - place;
      goalie.guard(place);
      const double speed = std::sqrt(atLine * atLine + 2 * goalie.deceleration() * way.norm());
      goalie.placeBall(place, way.normalized() * speed);
      for (double time = 0; time < longest && !goalie.isInGoal(); time += tickSeconds)
        goalie.step();
      if (!goalie.isInGoal()) continue;
      ++letIn;
      touched += goalie.ball().lastToucher >= 0;
      letInInner += std::abs(target) <= inner;
      letInOuter += std::abs(target) >= outer;
    }
  if (const auto done = goalie.soundness(); !done) return done.error();
  Measurement measured;
  measured.add("play.goalie.shots.letIn", "of 66", letIn, Aim::atMost(8));
  measured.add("play.goalie.shots.letIn.touched", "of 66", touched);
  measured.add("play.goalie.shots.letIn.inner", "of 30", letInInner);
  measured.add("play.goalie.shots.letIn.outer", "of 24", letInOuter);
  return measured;
}

Result<Measurement> measureGoalie(const Job& job, const DataRoot& root) {
  auto goalie = LonelyGoalie::make(job, root);
  if (!goalie) return goalie.error();
  return job.parameter("part") == "grid" ? clearBalls(*goalie) : shoot(*goalie);
}

}  // namespace

Experiment goalieExperiment() {
  return {"play.goalie",
          "What a goalie alone does with balls at rest around it (grid), and how many of 66 shots "
          "it lets in (shots)",
          {profileParameter(),
           {"part", "balls at rest or shots", Parameter::Kind::each, {"grid", "shots"}},
           {"fidelity", "of the bodies", Parameter::Kind::choice, {"kinematic", "dynamic"}, true},
           teamParameter("red"),
           teamParameter("blue"),
           oracledParameter(),
           valuesParameter()},
          withValues<measureGoalie>};
}

}  // namespace gt
