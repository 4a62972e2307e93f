// How soon a robot knows that a ball rolls, and whether it keeps it in sight.
#include <algorithm>
#include <cmath>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "measure/Tally.h"
#include "representations/behavior/BehaviorControlRequest.h"

namespace gt {
namespace {

/// A robot that looks at a ball, and stands or walks.
class BallWatcher {
 public:
  static Result<BallWatcher> make(const Job& job, const DataRoot& root) {
    MatchOptions options{root};
    options.scene = root.path("scenes/one-robot.scene");
    options.seed = job.seed;
    options.profile = job.parameter("profile");
    auto match = Match::make(options);
    if (!match) return match.error();
    return BallWatcher{*std::move(match), job.seed};
  }

  /// A ball that lies somewhere ahead, then rolls.
  void watch(bool walks, Tally& tally) {
    execute(walks);
    World& world = match_->simulation().world();
    world.placeRobot(
        0, {pi * random_.symmetric(), 300 * random_.symmetric(), 300 * random_.symmetric()});
    const Pose2D self = world.robot(0).pose;
    const double distance = random_.uniform(500, 1600);
    const Vector2d place = self * (distance * direction(fromDegrees(45) * random_.symmetric()));
    world.placeBall(0, clamped(place));
    run(2);
    if (!seesBall()) return;
    for (double time = 0; time < 0.4; time += tickSeconds)
      if (step()) compareResting(tally);
    // To the robot, past it, or away from it.
    const Vector2d from = world.ball(0).position;
    const Vector2d toRobot = world.robot(0).pose.translation - from;
    const double way = angleOf(toRobot) + fromDegrees(100) * random_.symmetric();
    world.placeBall(0, from, random_.uniform(400, 1500) * direction(way));
    constexpr double longest = 1.2, soon = 0.2;  // s
    bool compared = false;
    for (double time = 0; time < longest; time += tickSeconds) {
      if (!step()) continue;
      if (!mayBeSeen()) break;
      compareRolling(time, tally);
      if (time >= soon && !std::exchange(compared, true)) compareSpeed(tally);
    }
  }
  Result<void> soundness() const { return match_->soundness(); }

 private:
  BallWatcher(std::unique_ptr<Match> match, std::uint64_t seed)
      : match_{std::move(match)}, random_{Random{seed}.fork("rolling")} {}

  void execute(bool walks) {
    BehaviorControlRequest request;
    request.root = walks ? "walk" : "stand";
    request.basicBehavior = true;
    if (walks) request.parameters = {"100", "0", std::to_string(15 * random_.symmetric())};
    request.outputs = {{"head_control_mode", "search_auto"}};
    robot().robot().fromTools().write(match_->time(), request);
    robot().robot().answer();
  }
  /// Whether there was an image.
  bool step() {
    match_->step();
    return match_->simulation().input(0).image;
  }
  void run(double seconds) {
    for (double time = 0; time < seconds; time += tickSeconds) step();
  }
  static Vector2d clamped(const Vector2d& place) {
    return {std::clamp(place.x(), -1700., 1700.), std::clamp(place.y(), -1000., 1000.)};
  }
  SimulatedRobot& robot() { return *match_->robots().front(); }
  const OracledWorldState& truth() const { return match_->simulation().input(0).oracle; }
  Vector2d ball() const { return relative(truth().robotPose, truth().ballPosition); }
  Vector2d speed() const { return rotated(truth().ballSpeed, -truth().robotPose.rotation); }
  /// Neither below the head nor behind, nor far away or at rest.
  bool mayBeSeen() const {
    const Vector2d place = ball();
    return place.norm() > 250 && place.norm() < 2000 &&
           std::abs(angleOf(place)) < fromDegrees(80) && speed().norm() > 150;
  }
  /// Or has only glanced aside.
  bool seesBall() {
    constexpr std::int64_t glance = 900;  // ms
    return match_->time() - model().lastSeen < glance && (model().position - ball()).norm() < 300;
  }
  const BallModel& model() { return *robot().belief().ball; }

  void compareResting(Tally& tally) {
    tally.measure("resting.position", "mm", (model().position - ball()).norm());
    tally.measure("resting.speed", "mm/s", model().speed.norm());
  }
  void compareRolling(double time, Tally& tally) {
    constexpr double soon = 0.2;  // s
    if (time < soon) return;
    tally.count("seen", match_->time() - model().lastSeen < 100);
    tally.measure("position", "mm", (model().position - ball()).norm());
    tally.measure("speed", "%", 100 * (model().speed - speed()).norm() / speed().norm());
  }
  void compareSpeed(Tally& tally) {
    constexpr double about = 0.4;  // share
    tally.count("known", (model().speed - speed()).norm() < about * speed().norm());
  }

  std::unique_ptr<Match> match_;
  Random random_;
};

Result<Measurement> measureRolling(const Job& job, const DataRoot& root) {
  auto watcher = BallWatcher::make(job, root);
  if (!watcher) return watcher.error();
  Tally tally;
  const int balls = static_cast<int>(job.number("balls"));
  for (int i = 0; i < balls; ++i) watcher->watch(i % 2 == 1, tally);
  if (const auto done = watcher->soundness(); !done) return done.error();
  Measurement measured;
  for (const auto& [name, rate] : tally.rates)
    measured.add("worldmodel.rolling." + name, "%", rate.percent());
  for (const auto& [name, errors] : tally.errors)
    for (const auto& [of, value] : summaryOf(errors.sizes()))
      measured.add("worldmodel.rolling." + name + '.' + of, errors.unit, value);
  return measured;
}

}  // namespace

Experiment rollingExperiment() {
  return {"worldmodel.rolling",
          "How soon a robot that stands or walks knows that a ball rolls, and whether it sees it",
          {profileParameter(),
           {"balls", "that roll, one after another", Parameter::Kind::number, {"60"}},
           valuesParameter()},
          withValues<measureRolling>};
}

}  // namespace gt
