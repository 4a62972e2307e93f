// The technical challenges of 2003 (report, chapter 4), from random starts: whether the robot does
// the task, and how soon.
#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "Teams.h"

namespace gt {
namespace {

/// Runs a challenge's scene to its end, with everything where the seed puts it, if the job asks for
/// that.
Result<std::unique_ptr<Match>> run(const Job& job, const DataRoot& root, const std::string& kind) {
  MatchOptions options{root};
  options.scene = root.path("scenes/" + kind + "-challenge.scene");
  options.seed = job.seed;
  options.profile = job.parameter("profile");
  options.fidelity = job.parameter("fidelity");
  options.truth = oracled(job);
  options.randomChallenge = job.parameter("course") == "random";
  auto match = Match::make(options);
  if (!match) return match;
  while (!(*match)->finished()) (*match)->step();
  if (const auto done = (*match)->soundness(); !done) return done.error();
  return match;
}

Result<Measurement> crossField(const Job& job, const DataRoot& root) {
  const auto match = run(job, root, "obstacle");
  if (!match) return match.error();
  const Challenge& challenge = *(*match)->challenge();
  Measurement measured;
  const bool clean = challenge.succeeded() && challenge.contacts() == 0;
  measured.add("play.challenge.obstacles.arrived", "%", challenge.succeeded() ? 100 : 0);
  measured.add("play.challenge.obstacles.clean", "%", clean ? 100 : 0, Aim::atLeast(90));
  measured.add("play.challenge.obstacles.contacts", "contacts", challenge.contacts());
  measured.add("play.challenge.obstacles.seconds", "s", challenge.seconds(), Aim::atMost(25));
  return measured;
}

Result<Measurement> visitPlaces(const Job& job, const DataRoot& root) {
  const auto match = run(job, root, "localization");
  if (!match) return match.error();
  const Challenge& challenge = *(*match)->challenge();
  Measurement measured;
  constexpr int all = 15;
  measured.add("play.challenge.localization.points", "points", challenge.points());
  measured.add("play.challenge.localization.allPoints", "%", challenge.points() == all ? 100 : 0,
               Aim::atLeast(90));
  measured.add("play.challenge.localization.seconds", "s", challenge.seconds());
  double sum = 0;
  int visited = 0;
  for (const Challenge::Target& target : challenge.targets())
    if (target.distance >= 0) sum += target.distance, ++visited;
  measured.add("play.challenge.localization.visited", "places", visited);
  if (visited > 0) measured.add("play.challenge.localization.distance.mean", "mm", sum / visited);
  return measured;
}

Result<Measurement> bringBall(const Job& job, const DataRoot& root) {
  const auto match = run(job, root, "ball");
  if (!match) return match.error();
  const Challenge& challenge = *(*match)->challenge();
  Measurement measured;
  constexpr double soon = 60;  // s
  const bool isSoon = challenge.succeeded() && challenge.seconds() <= soon;
  measured.add("play.challenge.ball.goal", "%", challenge.succeeded() ? 100 : 0);
  measured.add("play.challenge.ball.goalWithinMinute", "%", isSoon ? 100 : 0, Aim::atLeast(90));
  measured.add("play.challenge.ball.seconds", "s", challenge.seconds());
  return measured;
}

std::vector<Parameter> parameters() {
  return {profileParameter(),
          {"fidelity", "of the bodies", Parameter::Kind::choice, {"kinematic", "dynamic"}, true},
          {"course",
           "where all stand: as the seed says, or as in the scene",
           Parameter::Kind::choice,
           {"random", "scene"}},
          oracledParameter(),
          valuesParameter()};
}

}  // namespace

Experiments challengeExperiments() {
  return {{"play.challenge.obstacles",
           "From goal to goal past seven robots (report 4.3): contacts and time", parameters(),
           withValues<crossField>},
          {"play.challenge.localization",
           "Visits five places without flags (report 4.2): points and time", parameters(),
           withValues<visitPlaces>},
          {"play.challenge.ball",
           "Brings the black and white ball into the goal (report 4.1): how often and how soon",
           parameters(), withValues<bringBall>}};
}

}  // namespace gt
