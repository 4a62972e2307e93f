// How well teams play: against each other, without opponents, a striker alone, penalty shots.
#include <algorithm>
#include <cmath>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "PlayWatch.h"
#include "Profiles.h"
#include "Teams.h"

namespace gt {
namespace {

Result<std::unique_ptr<Match>> matchOnScene(const Job& job, const DataRoot& root, const char* scene,
                                            std::optional<double> minutes = {}) {
  auto options = matchOptions(job, root);
  if (!options) return options.error();
  options->scene = root.path(scene);
  options->minutes = minutes;
  return Match::make(*options);
}

/// What a watch sees of a match now.
PlayMoment momentOf(Match& match) {
  const Simulation& simulation = match.simulation();
  PlayMoment moment{match.time(), simulation.world().ball(0), {}};
  for (std::size_t i = 0; i < simulation.world().activeRobots(); ++i) {
    PlayMoment::Robot& robot = moment.robots.emplace_back();
    robot.team = simulation.players()[i].teamColor;
    robot.position = simulation.world().robot(i).pose.translation;
    robot.plays = simulation.input(i).game.penalty == Penalty::none;
    robot.kicks = match.statistics().kicks(i);
  }
  for (std::size_t i = 0; i < match.robots().size(); ++i) {
    const Robot& program = match.robots()[i]->robot();
    PlayMoment::Robot& robot = moment.robots[match.robotIndex(i)];
    if (const auto* behavior = program.provided<BehaviorTeamMessage>()) robot.role = behavior->role;
    if (const BallModel* ball = match.robots()[i]->ball())
      robot.ballUnseen =
          static_cast<double>(simulation.image(match.robotIndex(i)).time - ball->lastSeen);
  }
  return moment;
}

/// Plays to the end.
void watch(Match& match, PlayWatch& play) {
  std::size_t seen = 0;
  while (!match.finished()) {
    match.step();
    const Referee& referee = match.simulation().referee();
    for (; seen < referee.events().size(); ++seen) {
      const GameEvent& event = referee.events()[seen];
      if (event.type == GameEventType::goal)
        play.goal(event.team);
      else if (event.type == GameEventType::stuckBall || event.type == GameEventType::ballOut ||
               event.type == GameEventType::kickOff)
        play.interrupt();
    }
    if (referee.state() == GameState::playing) play.see(momentOf(match));
  }
}

/// What a team did, per time.
void measureTeam(const MatchSummary& summary, TeamColor team, double minutes, const PlayWatch& play,
                 Measurement& measured) {
  const std::string name = "play." + std::string{enumName(team)};
  int penalties = 0, charges = 0;
  for (const MatchEvent& event : summary.events) {
    penalties += event.kind == "penalty" && event.team == team;
    charges += event.kind == "penalty" && event.team == team &&
               event.text.find("harge") != std::string::npos;
  }
  measured.add(name + ".goals", "goals",
               team == TeamColor::red ? summary.redScore : summary.blueScore);
  measured.add(name + ".kicks", "1/min", play.kicks(team) / minutes);
  measured.add(name + ".penalties", "in 5 min", penalties * 5 / minutes, Aim::atMost(1));
  measured.add(name + ".charges", "robots", charges, Aim::atMost(0));
  measured.add(name + ".ownArea", "s in 5 min", play.inOwnArea(team) * 5 / minutes);
  for (std::size_t i = 0; i < enumCount<GoalCause>; ++i) {
    const auto cause = static_cast<GoalCause>(i);
    measured.add(name + ".letIn." + std::string{enumName(cause)}, "goals", play.letIn(team, cause));
  }
}

/// How often each penalty was given to a team.
void measurePenalties(const Referee& referee, TeamColor team, double minutes,
                      Measurement& measured) {
  EnumArray<Penalty, int> penalties;
  for (const GameEvent& event : referee.events())
    if (event.type == GameEventType::penalty && event.team == team) ++penalties[event.penalty];
  const std::string name = "play." + std::string{enumName(team)} + ".penalties.";
  for (std::size_t i = 0; i < enumCount<Penalty>; ++i)
    if (const auto penalty = static_cast<Penalty>(i); penalty != Penalty::none)
      measured.add(name + std::string{enumName(penalty)}, "in 5 min",
                   penalties[penalty] * 5 / minutes);
}

Result<Measurement> playBoth(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/match.scene", job.number("minutes"));
  if (!match) return match.error();
  const SceneDescription& scene = (*match)->simulation().scene();
  PlayWatch play{*(*match)->configuration().field, scene.physics.deceleration};
  watch(**match, play);
  if (const auto done = (*match)->soundness(); !done) return done.error();
  const MatchSummary summary = (*match)->summary();
  Measurement measured;
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    measureTeam(summary, team, job.number("minutes"), play, measured);
    measurePenalties((*match)->simulation().referee(), team, job.number("minutes"), measured);
  }
  for (const auto& [name, rate] : play.tally().rates)
    measured.add("play." + name, "%", rate.percent());
  for (const auto& [name, times] : play.tally().errors)
    for (const auto& [of, value] : summaryOf(times.values))
      measured.add("play." + name + '.' + of, times.unit, value);
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

/// A striker alone with a ball, both anywhere, until it has scored.
Result<Measurement> playStriker(const Job& job, const DataRoot& root) {
  auto match = matchOnScene(job, root, "scenes/one-robot.scene");
  if (!match) return match.error();
  Simulation& simulation = (*match)->simulation();
  const FieldDimensions& field = *(*match)->configuration().field;
  Random random = Random{job.seed}.fork("start");
  const auto anywhere = [&] {
    return Vector2d{(field.xGroundline - 300) * random.symmetric(),
                    (field.ySideline - 250) * random.symmetric()};
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
      {"fidelity", "of the bodies", Parameter::Kind::choice, {"kinematic", "dynamic"}},
      teamParameter("red"),
      teamParameter("blue"),
      oracledParameter(),
      valuesParameter()};
  parameters.insert(parameters.end(), more.begin(), more.end());
  return {name, description, std::move(parameters), measure};
}

}  // namespace

Experiments playExperiments() {
  return {experiment("play.match", "How two teams play: what becomes of kicks, roles, penalties",
                     withValues<playBoth>,
                     {{"minutes", "both halves together", Parameter::Kind::number, {"10"}}}),
          experiment("play.alone", "How often a team without opponents scores in ten minutes",
                     withValues<playAlone>),
          experiment("play.striker", "How soon a striker alone scores, from anywhere",
                     withValues<playStriker>),
          experiment("play.shootOut", "How many penalty shots score", withValues<playShootOut>)};
}

}  // namespace gt
