#include <cmath>

#include "environments/BallGame.h"
#include "environments/Table.h"

namespace gt {
namespace {

constexpr std::size_t redGoalie = 0, attacker = 6;  // in the scene

/// Keep the ball out of the own goal.
class Goalie : public BallGame {
 public:
  Goalie(EnvironmentOptions options, SceneDescription scene)
      : BallGame{std::move(options),
                 std::move(scene),
                 {.robots = {redGoalie, attacker}},
                 {.skills = {skill::stand, skill::goToPoint, skill::goToBall, skill::handleBall,
                             skill::guardGoal}}} {
    terms_ = {{"ball", "0.3 times by how much the ball got further away from the own goal: m"},
              {"goal", "-1 at the end, if the ball is in the own goal"},
              {"cleared", "1 at the end, if the ball is in the other half"}};
  }

 protected:
  void place(Random& random) override {
    const Vector2d goal = goalOf(TeamColor::blue);
    const Vector2d away = direction(fromDegrees(50) * random.symmetric());
    from_ = goal + random.uniform(1100, 1700) * away;
    const Vector2d aim{goal.x(), 0.9 * field().yGoal * random.symmetric()};
    // As fast as a ball that would just roll to the line, and up to twice as fast.
    const double distance = (aim - from_).norm();
    const double speed =
        std::sqrt(2 * simulation().scene().physics.deceleration * distance) * random.uniform(1, 2);
    shot_ = (aim - from_) / distance * speed;
    world().placeBall(0, from_);
    world().placeRobot(0, {0.3 * random.symmetric(), goal.x() + 120, 200 * random.symmetric()});
    world().placeRobot(1, {angleOf(-away), from_ + 300 * away});
  }

  void start() override {
    world().placeBall(0, from_, shot_);
    before_ = fromGoal();
  }

  bool judge(std::span<double> terms) override {
    const double now = fromGoal();
    const bool lost = scorer() == TeamColor::blue, cleared = ball().position.x() > 0;
    terms[0] = 0.3 * (now - before_) / 1000;
    terms[1] = lost ? -1 : 0;
    terms[2] = cleared ? 1 : 0;
    before_ = now;
    return lost || cleared;
  }

 private:
  double fromGoal() const { return (ball().position - goalOf(TeamColor::blue)).norm(); }

  Vector2d from_ = Vector2d::Zero();  ///< mm: where the ball lies before it rolls.
  Vector2d shot_ = Vector2d::Zero();  ///< mm/s: how it begins to roll.
  double before_ = 0;                 ///< mm: of the ball from the own goal, after the last step.
};

}  // namespace

EnvironmentDescription goalieDescription() {
  return {"Goalie",
          "A goalie keeps a ball out of its goal that rolls there; an attacker of the other team, "
          "which plays as it always does, runs after it.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::motion, ActionKind::skills, ActionKind::joints},
          {AgentKind::red},
          {Fidelity::kinematic, Fidelity::dynamic},
          20,
          "the ball is in the own goal, or in the other half",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<Goalie>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
