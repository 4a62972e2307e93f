// How well teams play: against each other, without opponents, a striker alone, penalty shots.
#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "Teams.h"

namespace gt {
namespace {

Result<std::unique_ptr<Match>> matchOnScene(const Job& job, const DataRoot& root, const char* scene,
                                            std::optional<double> minutes = {}) {
  auto options = matchOptions(job, root);
  if (!options) return options.error();
  options->scene = root.path(scene);
  if (minutes) options->minutes = *minutes;
  return Match::make(*options);
}

/// What a figure of a team in a match must reach. Penalties are those of five minutes; the musts of
/// goals are of both teams in 40 matches.
Aim aimOf(std::string_view figure) {
  static const std::map<std::string_view, Aim> musts{
      {"strikers.two", Aim::atMost(0.5)},         {"strikers.none", Aim::atMost(1)},
      {"striker.unseen", Aim::atMost(18)},        {"penalties", Aim::atMost(0.15)},
      {"kick.afterTouch.median", Aim::atMost(6)}, {"letIn.touched", Aim::atMost(2. / 80)},
      {"letIn.unseen", Aim::atMost(4. / 80)},
  };
  if (figure.ends_with("Charge")) return Aim::atMost(0);
  const auto must = musts.find(figure.substr(figure.find('.') + 1));
  return must == musts.end() ? Aim{} : must->second;
}

Result<Measurement> playBoth(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/match.scene", job.number("minutes"));
  if (!match) return match.error();
  while (!(*match)->finished()) (*match)->step();
  if (const auto done = (*match)->soundness(); !done) return done.error();
  Measurement measured;
  for (const PlayFigure& figure : (*match)->summary().play)
    measured.add("play." + figure.name, figure.unit, figure.value, aimOf(figure.name));
  return measured;
}

/// A goalie without a team against two strikers, for five minutes: what a goalie does about balls
/// before it tells sooner than by the few goals of matches.
Result<Measurement> playSiege(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/siege.scene");
  if (!match) return match.error();
  while (!(*match)->finished()) (*match)->step();
  if (const auto done = (*match)->soundness(); !done) return done.error();
  Measurement measured;
  measured.add("play.siege.letIn", "goals", (*match)->summary().blueScore);
  constexpr std::string_view causes = "red.letIn.";
  for (const PlayFigure& figure : (*match)->summary().play)
    if (figure.name.starts_with(causes))
      measured.add("play.siege.letIn." + figure.name.substr(causes.size()), figure.unit,
                   figure.value);
  return measured;
}

/// A team without opponents.
Result<Measurement> playAlone(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/no-opponents.scene");
  if (!match) return match.error();
  while (!(*match)->finished()) (*match)->step();
  if (const auto done = (*match)->soundness(); !done) return done.error();
  Measurement measured;
  measured.add("play.alone.goals", "goals", (*match)->summary().redScore, Aim::atLeast(10));
  return measured;
}

/// A striker alone with a ball, both anywhere but in its own penalty area, where it must not play,
/// until it has scored.
Result<Measurement> playStriker(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/one-robot.scene");
  if (!match) return match.error();
  Simulation& simulation = (*match)->simulation();
  const FieldDimensions& field = (*match)->configuration().get<FieldDimensions>();
  Random random = Random{job.seed}.fork("start");
  const auto anywhere = [&] {
    constexpr double room = 100;  // mm, that a robot keeps off its area
    for (;;) {
      const Vector2d place{(field.xGroundline - 300) * random.symmetric(),
                           (field.ySideline - 250) * random.symmetric()};
      const bool inArea =
          place.x() < room - field.xPenaltyArea && std::abs(place.y()) < field.yPenaltyArea + room;
      if (!inArea) return place;
    }
  };
  const Vector2d start = anywhere();
  simulation.world().placeRobot(0, {pi * random.symmetric(), start});
  simulation.world().placeBall(0, anywhere());
  constexpr double longest = 120;  // s
  const auto scored = [&] { return simulation.world().ball(0).position.x() > field.xGroundline; };
  double seconds = 0;
  for (; seconds < longest && !scored(); seconds += tickSeconds) (*match)->step();
  if (const auto done = (*match)->soundness(); !done) return done.error();
  Measurement measured;
  measured.add("play.striker.seconds", "s", seconds, Aim::atMost(15));
  measured.add("play.striker.scored", "%", seconds < 60 ? 100 : 0, Aim::atLeast(100));
  return measured;
}

/// Penalty shots, in turns.
Result<Measurement> playShootOut(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/penalty-shoot-out.scene");
  if (!match) return match.error();
  while (!(*match)->finished()) (*match)->step();
  if (const auto done = (*match)->soundness(); !done) return done.error();
  int goals = 0, shots = 0;
  for (const GameEvent& event : (*match)->simulation().referee().events()) {
    goals += event.type == GameEventType::shotGoal;
    shots += event.type == GameEventType::shotGoal || event.type == GameEventType::shotMissed;
  }
  Measurement measured;
  measured.add("play.shootOut.goals", "%", 100. * goals / std::max(1, shots));
  measured.add("play.shootOut.shots", "shots", shots);
  return measured;
}

Experiment experiment(const char* name, const char* description,
                      decltype(Experiment::measure) measure, std::vector<Parameter> more = {}) {
  std::vector<Parameter> parameters{
      profileParameter(),
      {"fidelity", "of the bodies", Parameter::Kind::choice, {"kinematic", "dynamic"}, true},
      teamParameter("red"),
      teamParameter("blue"),
      oracledParameter(),
      valuesParameter()};
  parameters.insert(parameters.end(), more.begin(), more.end());
  return {name, description, std::move(parameters), measure};
}

}  // namespace

Experiments playExperiments() {
  return {
      experiment("play.match", "How two teams play: what becomes of kicks, roles, penalties",
                 withValues<playBoth>,
                 {{"minutes", "both halves together", Parameter::Kind::number, {"10"}}}),
      experiment("play.siege", "How many goals a goalie alone lets in against two strikers",
                 withValues<playSiege>),
      experiment("play.alone", "How often a team without opponents scores in ten minutes",
                 withValues<playAlone>),
      experiment("play.striker", "How soon a striker alone scores, from anywhere but its own area",
                 withValues<playStriker>),
      experiment("play.shootOut", "How many penalty shots score", withValues<playShootOut>)};
}

}  // namespace gt
