#include <cmath>

#include "environments/Limbs.h"
#include "environments/Table.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "streams/Config.h"

namespace gt {
namespace {

/// The parameters of the walk that an agent sets, in the order of their fields.
template <typename Visit>
void forEachParameter(WalkParameters& parameters, const Visit& visit) {
  forEachField(parameters, [&](const auto& field, auto& member) {
    using Member = std::remove_cvref_t<decltype(member)>;
    // The greatest accelerations count at the beginning only, the measured speeds do not change how
    // the robot walks, and the head is held.
    if constexpr (std::is_arithmetic_v<Member>)
      if (field.range.bounds() && !field.name.starts_with("correction") &&
          field.name.find("Change") == field.name.npos && !field.name.starts_with("head") &&
          field.name != "mouth")
        visit(field, member);
  });
}

/// Walk ahead along the x axis of the field, as fast and as straight as possible.
class Walk : public Limbs {
 public:
  Walk(EnvironmentOptions options, SceneDescription scene)
      : Limbs{std::move(options), std::move(scene), legJoints(), false} {
    terms_ = {
        {"ahead", "mean speed along the x axis of the field: m/s"},
        {"astray", "-0.5 for each m beside the line on which it began"},
        {"upright", "0.1 as long as it has not fallen"},
        {"effort", "-0.5 times the mean square of the last change of the requested angles: rad^2"}};
    if (actions() != ActionKind::parameters) return;
    ticksPerStep_ = 80;
    WalkParameters parameters;
    forEachParameter(parameters, [&](const auto& field, auto&) {
      actionSpace_.add(std::string{field.name}, "", -1, 1,
                       std::string{field.doc} + "; -1 and 1: the bounds, 0: as robots walk");
    });
  }

 protected:
  Result<void> load() override {
    return readConfig(scene_.resolve(scene_.config) + "/modules/WalkingEngine.InvKin.cfg",
                      parameters_);
  }

  Result<void> begin(Random& random) override {
    constexpr int settling = 12;  // ticks
    engine_ = {};
    motion_ = {};
    output_ = {};
    line_ = 300 * random.symmetric();
    auto done = put(random, {0.05 * random.symmetric(), -1700, line_}, Posture::standing, settling);
    from_ = body().pose.translation.x();
    return done;
  }

  void act(std::span<const float> actions) override {
    if (this->actions() == ActionKind::joints) return Limbs::act(actions);
    engine_.parameters = parameters_;
    auto next = actions.begin();
    forEachParameter(engine_.parameters.normal, [&](const auto& field, auto& member) {
      using Member = std::remove_cvref_t<decltype(member)>;
      const double action = *next++, usual = member;
      const double changed = usual + (action > 0 ? action * (field.range.high - usual)
                                                 : action * (usual - field.range.low));
      member = static_cast<Member>(std::is_integral_v<Member> ? std::round(changed) : changed);
    });
    for (int i = 0; i < ticksPerStep_; ++i) walk();
  }

  bool judge(std::span<double> terms) override {
    const double x = body().pose.translation.x();
    const bool fallen = body().posture != Posture::standing;
    terms[0] = (x - from_) / 1000 / secondsPerStep();
    terms[1] = -0.5 * std::abs(body().pose.translation.y() - line_) / 1000;
    terms[2] = fallen ? 0 : 0.1;
    terms[3] = -0.5 * effort();
    from_ = x;
    return fallen;
  }

 private:
  /// Executes a tick of the walking engine, at full speed ahead.
  void walk() {
    constexpr double fastest = 1000;  // mm/s: more than any parameters allow
    MotionRequest request;
    request.type = MotionType::walk;
    request.walk.translation.x() = fastest;
    engine_.update({simulation().time()}, request, RobotDimensions{}, {}, {motion_}, output_);
    motion_.executed = request;
    JointAngles angles = standing_;
    for (const Joint joint : joints()) angles[joint] = output_.joints.angles[joint];
    drive(angles);
  }

  const JointAngles standing_ = standingAngles();
  InvKinWalkingEngine::Parameters parameters_;  ///< As robots walk.
  InvKinWalkingEngine engine_;
  WalkingEngineOutput output_;
  MotionInfo motion_;
  double line_ = 0;  ///< mm: y of the line along which it should walk.
  double from_ = 0;  ///< mm: x after the last step.
};

}  // namespace

EnvironmentDescription walkDescription() {
  return {"Walk",
          "A robot alone in the dynamic fidelity walks ahead, by its joints at 125 Hz or by the "
          "parameters of the walking engine, one set each 0.64 s.",
          {ObservationKind::state, ObservationKind::beliefs, ObservationKind::image},
          {ActionKind::joints, ActionKind::parameters},
          {AgentKind::red},
          {Fidelity::dynamic},
          8,
          "the robot has fallen",
          [](EnvironmentOptions options, SceneDescription scene) -> std::unique_ptr<Environment> {
            return std::make_unique<Walk>(std::move(options), std::move(scene));
          }};
}

}  // namespace gt
