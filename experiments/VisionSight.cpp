// Why the strikers of a match do not see the ball: it is not in the image, something hides it, or
// vision misses it.
#include "Experiments.h"
#include "Profiles.h"
#include "VisionTruth.h"
#include "match/Match.h"
#include "measure/Tally.h"
#include "modules/perception/scanning/CameraImage.h"
#include "representations/perception/BallPercept.h"

namespace gt {
namespace {

using Kind = VisionTruth::Kind;

/// What a camera shows of the ball, and why that is not enough.
enum class Sight { seen, missed, partly, far, hiddenBySelf, hiddenByOthers, outside };

/// Looks at what robots see, which is rendered anew to know what each pixel shows.
class Sights {
 public:
  explicit Sights(Match& match)
      : match_{match},
        cameraScene_{match.simulation().world().model()},
        renderer_{cameraScene_},
        truth_{match.simulation().world(), match.simulation().scene()} {}

  Sight of(std::size_t robot) {
    const std::size_t index = match_.robotIndex(robot);
    if (match_.robots()[robot]->robot().provided<BallPercept>()->seen) return Sight::seen;
    const Simulation& simulation = match_.simulation();
    const CameraView& camera = simulation.lastView(index);
    view_.robot = index;
    renderer_.render(simulation.world().data(), camera, {}, 0, view_.image, &view_.truth);
    view_.camera = trueMatrix(camera, simulation.world().robot(index).pose);
    truth_.look(view_);
    const Vector2d place = truth_.ball();
    const double ballRadius = simulation.world().ballRadius(0);
    const Vector3d ray =
        Vector3d{place.x(), place.y(), ballRadius} - truth_.camera().pose.translation;
    const CameraInfo& info = view_.image.info;
    const double radius = info.focalX * ballRadius / ray.norm();
    const int visible = truth_.pixels(Kind::ball);
    if (visible > pi * radius * radius / 2) return radius >= 3 ? Sight::missed : Sight::far;
    if (visible > 0) return Sight::partly;
    const Vector2d p = pointIn(truth_.camera(), ray);
    if (truth_.camera().pose.rotation.col(0).dot(ray) <= 0 || !info.contains(p.x(), p.y()))
      return Sight::outside;
    return truth_.shows(p, Kind::robot, index) || truth_.shows(p, Kind::tricot, index)
               ? Sight::hiddenBySelf
               : Sight::hiddenByOthers;
  }

 private:
  Match& match_;
  CameraScene cameraScene_;
  CameraRenderer renderer_;
  VisionTruth truth_;
  GameView view_;
};

Result<Measurement> measureSight(const Job& job, const DataRoot& root) {
  auto match = makeMatch(job, root);
  if (!match) return match.error();
  constexpr std::int64_t lostFor = 1000;  // ms
  Sights sights{**match};
  Tally tally;
  while (!(*match)->finished()) {
    (*match)->step();
    const Simulation& simulation = (*match)->simulation();
    if (!simulation.input(0).image || simulation.referee().state() != GameState::playing) continue;
    for (std::size_t i = 0; i < (*match)->robots().size(); ++i) {
      const std::size_t index = (*match)->robotIndex(i);
      const Robot& robot = (*match)->robots()[i]->robot();
      const auto* behavior = robot.provided<BehaviorTeamMessage>();
      const BallModel* ball = (*match)->robots()[i]->belief().ball;
      if (simulation.input(index).game.penalty != Penalty::none || !behavior || !ball ||
          behavior->role != DynamicRole::striker)
        continue;
      const bool unseen = simulation.image(index).time - ball->lastSeen > lostFor;
      const Sight sight = sights.of(i);
      tally.count("unseen", unseen);
      if (sight == Sight::seen || sight == Sight::missed)
        tally.count("found", sight == Sight::seen);
      for (std::size_t s = 0; s < enumCount<Sight>; ++s) {
        const std::string name{enumNames<Sight>[s]};
        tally.count(name, s == static_cast<std::size_t>(sight));
        if (unseen) tally.count("unseen." + name, s == static_cast<std::size_t>(sight));
      }
    }
  }
  if (const auto done = (*match)->soundness(); !done) return done.error();
  Measurement measured;
  for (const auto& [name, rate] : tally.rates)
    measured.add("vision.sight." + name, "%", rate.percent());
  return measured;
}

}  // namespace

Experiment visionSightExperiment() {
  return {"vision.sight",
          "Whether the strikers of a match see the ball, and why not",
          {profileParameter(), {"minutes", "of the match", Parameter::Kind::number, {"4"}}},
          measureSight};
}

}  // namespace gt
