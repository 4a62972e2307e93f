#include "environments/Limbs.h"
#include "environments/Table.h"

namespace gt {
namespace {

/// Get up from one of the sides.
class GetUp : public Limbs {
 public:
  GetUp(EnvironmentOptions options, SceneDescription scene)
      : Limbs{std::move(options), std::move(scene), headAndLegJoints(), false} {
    terms_ = {
        {"upright", "half of the cosine of the body's lean against upright, minus 0.5"},
        {"height", "the body's height as a share of 0.13 m, at most 1, minus 1"},
        {"effort", "-0.5 times the mean square of the last change of the requested angles: rad^2"}};
  }

 protected:
  Result<void> begin(Random& random) override {
    constexpr int settling = 25;  // ticks
    stood_ = 0;
    const Posture side = random.chance(0.5) ? Posture::onLeftSide : Posture::onRightSide;
    return put(random, {pi * random.symmetric(), 0, 0}, side, settling);
  }

  bool judge(std::span<double> terms) override {
    constexpr double standHeight = 130;  // mm
    constexpr double steep = 0.94;       // cosine of 20 degrees
    constexpr double low = 90;           // mm: a robot that stands is higher
    constexpr int longEnough = 62;       // ticks: half a second
    terms[0] = (upright() - 1) / 2;
    terms[1] = std::min(body().height / standHeight, 1.0) - 1;
    terms[2] = -0.5 * effort();
    stood_ = upright() > steep && body().height > low ? stood_ + 1 : 0;
    return stood_ >= longEnough;
  }

 private:
  int stood_ = 0;  ///< For so many ticks.
};

}  // namespace

EnvironmentDescription getUpDescription() {
  return {"GetUp",
          "A robot in the dynamic fidelity lies on its left or right side and gets up, by its "
          "joints at 125 Hz. All rewards are costs: the sooner it stands, the better.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::joints},
          {AgentKind::red},
          {Fidelity::dynamic},
          5,
          "the robot has stood for half a second: higher than 90 mm, leaning by less than 20 "
          "degrees",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<GetUp>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
