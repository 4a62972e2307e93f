// Lets GridImageProcessor2 look through the eyes of robots that play, from no color at all, while
// the light changes, and compares it with GT2003 and its color table.
#include <array>
#include <memory>

#include "Experiments.h"
#include "Profiles.h"
#include "VisionMeasures.h"
#include "match/Match.h"
#include "modules/perception/processors/GridImageProcessor2.h"

namespace gt {
namespace {

/// A part of the play, from and to seconds after the whistle. The light changes evenly.
struct Phase {
  const char* name;
  double from, to;
  double lightFrom, lightTo;
};
constexpr std::array phases{
    Phase{"learning", 0, 30, 1.25, 1.25}, Phase{"bright", 30, 60, 1.25, 1.25},
    Phase{"darkening", 60, 90, 1.25, 0.5}, Phase{"half", 90, 120, 0.5, 0.5}};

/// What both processors found in a phase.
struct Found {
  Tally table, adaptive;
};
using PlayTally = std::array<Found, phases.size()>;

FoundPercepts perceptsOf(const Robot& robot) {
  return {*robot.provided<BallPercept>(), *robot.provided<LandmarksPercept>(),
          *robot.provided<LinesPercept>(), *robot.provided<PlayersPercept>(),
          *robot.provided<ObstaclesPercept>()};
}

/// Looks through the eyes of one robot: it sees its images by the light of its scene, the
/// adaptive processor the same ones by another light.
class Spectator {
 public:
  Spectator(Match& match, std::size_t robot, std::uint64_t seed)
      : match_{match},
        robot_{robot},
        cameraScene_{match.simulation().world().model()},
        renderer_{cameraScene_},
        truth_{match.simulation().world(), match.simulation().scene()},
        measures_{truth_},
        random_{seed} {}

  void look(double light, Found& found) {
    Simulation& simulation = match_.simulation();
    const std::size_t index = match_.robotIndex(robot_);
    const Robot& robot = match_.robots()[robot_]->robot();
    const CameraMatrix& matrix = *robot.provided<CameraMatrix>();
    CameraEffects effects = simulation.scene().camera;
    effects.brightness = light;
    effects = simulation.sensors(index).build().seen(effects);
    view_.robot = index;
    const CameraView& camera = simulation.lastView(index);
    renderer_.render(simulation.world().data(), camera, effects, random_(), view_.image,
                     &view_.truth);
    view_.image.time = simulation.time();
    view_.camera = trueMatrix(camera, simulation.world().robot(index).pose);
    truth_.look(view_);
    measures_.comparePercepts(perceptsOf(robot), matrix, found.table);
    processor_.update(view_.image, matrix, FieldDimensions{}, percepts_, debug_);
    measures_.comparePercepts(percepts_, matrix, found.adaptive);
  }

 private:
  Match& match_;
  std::size_t robot_;
  CameraScene cameraScene_;
  CameraRenderer renderer_;
  VisionTruth truth_;
  VisionMeasures measures_;
  Random random_;
  GameView view_;
  GridImageProcessor2 processor_;
  FoundPercepts percepts_;
  Debug debug_{1024};
};

Result<PlayTally> watchPlay(const Job& job, const DataRoot& root) {
  auto match = makeMatch(job, root);
  if (!match) return match.error();
  // A goalie, a defender and a striker.
  std::vector<std::unique_ptr<Spectator>> spectators;
  for (const std::size_t robot : {0u, 2u, 5u})
    spectators.push_back(std::make_unique<Spectator>(**match, robot, job.seed * 100 + robot));
  PlayTally tally;
  double seconds = 0;
  for (std::size_t phase = 0; phase < phases.size();) {
    (*match)->step();
    const Simulation& simulation = (*match)->simulation();
    if (!simulation.input(0).image || simulation.referee().state() != GameState::playing) continue;
    seconds += Simulation::ticksPerImage * tickSeconds;
    const Phase& now = phases[phase];
    const double part = (seconds - now.from) / (now.to - now.from);
    for (const auto& spectator : spectators)
      spectator->look(now.lightFrom + part * (now.lightTo - now.lightFrom), tally[phase]);
    if (seconds >= now.to) ++phase;
  }
  if (const auto done = (*match)->soundness(); !done) return done.error();
  return tally;
}

double percent(const Tally& tally, const std::string& name) {
  const auto found = tally.rates.find(name);
  return found == tally.rates.end() ? 0 : found->second.percent();
}

Result<Measurement> measureVisionPlay(const Job& job, const DataRoot& root) {
  const auto tally = watchPlay(job, root);
  if (!tally) return tally.error();
  Measurement measured;
  for (std::size_t phase = 0; phase < phases.size(); ++phase) {
    const std::string base = std::string{"vision.GridImageProcessor2."} + phases[phase].name + ".";
    for (const std::string name :
         {"ball.found", "flags.found", "goals.found", "edges.line.right", "edges.border.right",
          "players.found", "players.color", "ball.false", "flags.false", "goals.false"}) {
      const Found& found = (*tally)[phase];
      const double table = percent(found.table, name), own = percent(found.adaptive, name);
      measured.add(base + name, "%", own);
      const bool compared = name == "ball.found" || name == "flags.found" || name == "goals.found";
      if (compared && table > 0)
        measured.add(base + name + ".ofTable", "%", 100 * own / table,
                     phase == 0 ? Aim{} : Aim::atLeast(90));
    }
  }
  return measured;
}

}  // namespace

Experiment visionPlayExperiment() {
  return {"vision.play",
          "The image processor that adapts its colors, through the eyes of robots that play",
          {profileParameter()},
          measureVisionPlay};
}

}  // namespace gt
