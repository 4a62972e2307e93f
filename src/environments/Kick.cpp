#include "environments/Limbs.h"
#include "environments/Table.h"

namespace gt {
namespace {

/// Kick the ball that lies before the robot straight ahead, as far as possible.
class Kick : public Limbs {
 public:
  Kick(EnvironmentOptions options, SceneDescription scene)
      : Limbs{std::move(options), std::move(scene), headAndLegJoints(), true} {
    terms_ = {
        {"ahead", "how far the ball has rolled along the x axis of the field: m"},
        {"astray", "-1 for each m that it has got further away from its first line"},
        {"fallen", "-1 if the robot falls"},
        {"effort", "-0.1 times the mean square of the last change of the requested angles: rad^2"}};
  }

 protected:
  Result<void> begin(Random& random) override {
    constexpr int settling = 12;                                         // ticks
    constexpr double ahead = 175, variety = 15, aside = 40, line = 300;  // mm
    const double y = line * random.symmetric();
    const Pose2D pose{0.05 * random.symmetric(), -1000, y};
    const Vector2d ball =
        pose * Vector2d{ahead + variety * random.symmetric(), aside * random.symmetric()};
    world().placeBall(0, ball);
    auto done = put(random, pose, Posture::standing, settling);
    from_ = at_ = world().ball(0).position;
    return done;
  }

  bool judge(std::span<double> terms) override {
    const Vector2d& ball = world().ball(0).position;
    const bool fallen = body().posture != Posture::standing;
    terms[0] = (ball.x() - at_.x()) / 1000;
    terms[1] = (std::abs(at_.y() - from_.y()) - std::abs(ball.y() - from_.y())) / 1000;
    terms[2] = fallen ? -1 : 0;
    terms[3] = -0.1 * effort();
    at_ = ball;
    return fallen;
  }

 private:
  Vector2d from_ = Vector2d::Zero();  ///< mm: where the ball lay at the beginning.
  Vector2d at_ = Vector2d::Zero();    ///< mm: after the last step.
};

}  // namespace

EnvironmentDescription kickDescription() {
  return {"Kick",
          "A robot in the dynamic fidelity stands before the ball and kicks it straight ahead, by "
          "its joints at 125 Hz. With its beliefs alone it kicks blindly: they do not have the "
          "ball.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::joints},
          {AgentKind::red},
          {Fidelity::dynamic},
          4,
          "the robot has fallen",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<Kick>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
