#include <cmath>

#include "environments/BallGame.h"
#include "environments/Table.h"

namespace gt {
namespace {

/// Walk to the ball so that it lies before the robot, which faces the opponent's goal.
class Approach : public BallGame {
 public:
  Approach(EnvironmentOptions options, SceneDescription scene)
      : BallGame{std::move(options),
                 std::move(scene),
                 {.robots = {sceneStriker}},
                 {.skills = {skill::stand, skill::goToBall, skill::searchBall}, .kicks = false}} {
    terms_ = {{"closer", "by how much the robot got closer to its place 0.15 m behind the ball: m"},
              {"facing", "0.3 times by how much it got to face the goal more: rad"},
              {"time", "-0.1 for each second"},
              {"done", "1 at the end"}};
  }

 protected:
  void place(Random& random) override {
    constexpr double fromBorder = 350, nearest = 400, furthest = 1800;  // mm
    const Vector2d ball = anywhere(random, fromBorder);
    Vector2d robot = anywhere(random, fromBorder);
    while ((robot - ball).norm() < nearest || (robot - ball).norm() > furthest)
      robot = anywhere(random, fromBorder);
    world().placeBall(0, ball);
    world().placeRobot(0, {pi * random.symmetric(), robot});
  }

  void start() override { before_ = errors(); }

  bool judge(std::span<double> terms) override {
    constexpr double precision = 30;  // mm
    const Errors now = errors();
    const Vector2d lies = relative(pose(0), ball().position);
    const bool done = std::abs(lies.x() - ballDistance) < precision &&
                      std::abs(lies.y()) < precision && now.angle < fromDegrees(15);
    terms[0] = (before_.distance - now.distance) / 1000;
    terms[1] = 0.3 * (before_.angle - now.angle);
    terms[2] = -0.1 * secondsPerStep();
    terms[3] = done ? 1 : 0;
    before_ = now;
    return done;
  }

 private:
  /// How far the robot is from where it should be.
  struct Errors {
    double distance = 0, angle = 0;  // mm, rad
  };
  Errors errors() const {
    const Vector2d& at = ball().position;
    const double facing = angleOf(goalOf(TeamColor::red) - at);
    const Vector2d place = at - ballDistance * direction(facing);
    return {(place - pose(0).translation).norm(), std::abs(normalize(facing - pose(0).rotation))};
  }

  Errors before_;
};

}  // namespace

EnvironmentDescription approachDescription() {
  return {"Approach",
          "A robot walks to the ball, wherever both are on the field, so that it lies before the "
          "robot, which faces the opponent's goal.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::motion, ActionKind::skills, ActionKind::joints},
          {AgentKind::red},
          {Fidelity::kinematic, Fidelity::dynamic},
          20,
          "the ball lies 0.15 m before the robot, give or take 0.03 m in both directions, and the "
          "robot faces the goal by 15 degrees",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<Approach>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
