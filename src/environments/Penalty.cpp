#include "environments/BallGame.h"
#include "environments/Table.h"

namespace gt {
namespace {

constexpr std::size_t blueGoalie = 4;  // in the scene

/// Score against the other team's goalie.
class PenaltyShot : public BallGame {
 public:
  PenaltyShot(EnvironmentOptions options, SceneDescription scene)
      : BallGame{
            std::move(options),
            std::move(scene),
            {.robots = {sceneStriker, blueGoalie}},
            {.skills = {skill::stand, skill::goToBall, skill::handleBall, skill::searchBall}}} {
    terms_ = {
        {"closer", "0.3 times by how much the robot got closer to the ball: m"},
        {"ball", "by how much the ball got closer to the middle of the goal: m"},
        {"time", "-0.05 for each second"},
        {"goal", "5 at the end, if the ball is in the opponent's goal; -5 if in the own one"}};
  }

 protected:
  void place(Random& random) override {
    const Vector2d ball{600 * random.uniform(0, 1), 400 * random.symmetric()};
    const Vector2d robot{ball.x() - random.uniform(300, 600), ball.y() + 300 * random.symmetric()};
    world().placeBall(0, ball);
    world().placeRobot(0, {0.5 * random.symmetric(), robot});
    world().placeRobot(1, {pi, field().xGroundline - 100, 150 * random.symmetric()});
  }

  void start() override { before_ = distances(); }

  bool judge(std::span<double> terms) override {
    const Distances now = distances();
    const auto scored = scorer();
    terms[0] = 0.3 * (before_.toBall - now.toBall) / 1000;
    terms[1] = (before_.toGoal - now.toGoal) / 1000;
    terms[2] = -0.05 * secondsPerStep();
    terms[3] = !scored ? 0 : *scored == TeamColor::red ? 5 : -5;
    before_ = now;
    return scored.has_value();
  }

 private:
  struct Distances {
    double toBall = 0, toGoal = 0;  // mm: of the robot, of the ball
  };
  Distances distances() const {
    return {(ball().position - pose(0).translation).norm(),
            (goalOf(TeamColor::red) - ball().position).norm()};
  }

  Distances before_;
};

}  // namespace

EnvironmentDescription penaltyDescription() {
  return {"Penalty",
          "A robot stands before the ball in the opponent's half and scores, against the other "
          "team's goalie, which plays as it always does.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::motion, ActionKind::skills, ActionKind::joints},
          {AgentKind::red},
          {Fidelity::kinematic, Fidelity::dynamic},
          30,
          "the ball is in a goal",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<PenaltyShot>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
