// Plays matches and counts goals, own goals, and how well the robots know where they are.
#include <algorithm>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "Teams.h"

namespace gt {
namespace {

/// Returns how far the ball moved (m) while it was not put somewhere.
double playToTheEnd(Match& match) {
  constexpr double put = 60;  // mm in a tick: no kick is that fast
  double way = 0;
  Vector2d before = match.simulation().world().ball(0).position;
  while (!match.finished()) {
    match.step();
    const Vector2d now = match.simulation().world().ball(0).position;
    const double moved = (now - before).norm();
    if (moved < put) way += moved / 1000;
    before = now;
  }
  return way;
}

Result<Measurement> playMatch(const Job& job, const DataRoot& root) {
  auto options = matchOptions(job, root);
  if (!options) return options.error();
  options->minutes = job.number("minutes");
  auto match = Match::make(*options);
  if (!match) return match.error();
  const double ballWay = playToTheEnd(**match);
  if (const auto done = (*match)->soundness(); !done) return done.error();
  const MatchSummary summary = (*match)->summary();
  int ownGoals = 0, kicks = 0, stuckBalls = 0, penalties = 0, falls = 0;
  double walked = 0;  // m
  for (const MatchEvent& event : summary.events) {
    ownGoals += event.kind == "goal" && event.ownGoal;
    stuckBalls += event.kind == "stuckBall";
    penalties += event.kind == "penalty";
  }
  for (const RobotSummary& robot : summary.robots) {
    walked += robot.distanceWalked / 1000;
    falls += robot.falls;
    for (const KickCount& kick : robot.kicks) kicks += kick.count;
  }
  const std::vector<double> errors = (*match)->statistics().localizationErrors();
  const ErrorStatistics localization = statisticsOf(errors);
  constexpr double lost = 1000;  // mm
  const auto lostImages = std::ranges::count_if(errors, [](double error) { return error > lost; });

  Measurement measured;
  const int goals = summary.redScore + summary.blueScore;
  measured.add("match.goals", "goals", goals, Aim::atLeast(3));
  measured.add("match.goals.red", "goals", summary.redScore);
  measured.add("match.goals.blue", "goals", summary.blueScore);
  measured.add("match.goals.regular", "goals", goals - ownGoals);
  measured.add("match.goals.own", "goals", ownGoals);
  measured.add("match.kicks", "kicks", kicks);
  measured.add("match.stuckBalls", "balls", stuckBalls);
  measured.add("match.penalties", "robots", penalties);
  measured.add("match.falls", "falls", falls);
  measured.add("match.walked", "m", walked);
  measured.add("match.ball.way", "m/min", ballWay / job.number("minutes"));
  measured.add("match.localization.error.mean", "mm", localization.mean);
  measured.add("match.localization.error.median", "mm", localization.median, Aim::atMost(150));
  measured.add("match.localization.error.p95", "mm", localization.percentile95, Aim::atMost(600));
  measured.add("match.localization.error.max", "mm", localization.maximum);
  measured.add(
      "match.localization.lost.share", "%",
      100 * static_cast<double>(lostImages) / std::max(1.0, static_cast<double>(errors.size())));
  measured.add("match.localization.lost.longest", "s", (*match)->statistics().longestLost());
  return measured;
}

}  // namespace

Experiment matchExperiment() {
  return {"match",
          "Whole matches: goals, kicks, penalties, localization against the truth",
          {profileParameter(),
           {"fidelity", "of the bodies", Parameter::Kind::choice, {"kinematic", "dynamic"}, true},
           teamParameter("red"),
           teamParameter("blue"),
           {"minutes", "both halves together", Parameter::Kind::number, {"10"}},
           oracledParameter(),
           valuesParameter()},
          withValues<playMatch>};
}

}  // namespace gt
