// Measures what robots know of the world around them while they play: the ball by each locator, the
// team's ball, obstacles and players, against the truth (report 3.4 to 3.7).
#include <memory>
#include <optional>

#include "Experiments.h"
#include "InParallel.h"
#include "WorldModelWatch.h"
#include "simulation/sensors/CeilingCamera.h"
#include "simulation/sensors/CeilingTracker.h"
#include "streams/Mcap.h"

namespace gt {
namespace {

/// What is watched of one robot.
struct Watch {
  explicit Watch(std::uint64_t seed)
      : team{{{"loss5", 0.05, false, seed},
              {"loss50", 0.5, false, seed},
              {"onelost", 0.05, true, seed}}} {}
  BallWatch ball;
  std::array<TeamBallWatch, 3> team;
};

/// The message of a robot, with the ball of the locator that tells how sure it is.
TeamMessage messageOf(const Player& player, const RobotPose& pose, const BallModel& ball,
                      Time now) {
  TeamMessage message;
  message.playerNumber = player.number();
  message.timeSent = now;
  message.robotPose = pose.pose;
  message.robotPoseValidity = pose.validity;
  message.ballPosition = pose.pose * ball.position;
  message.ballSpeed = rotated(ball.speed, pose.pose.rotation);
  message.ballDeviation = ball.deviation;
  message.ballLastSeen = ball.lastSeen;
  return message;
}

/// The truth: the oracle's, or that of a camera at the ceiling.
class Truth {
 public:
  Truth(const Simulation& simulation, const ExperimentOptions& options, std::uint64_t seed)
      : simulation_{simulation},
        useCeiling_{options.ceiling},
        camera_{{}, simulation.players(), Random{seed}.fork("ceiling camera")} {}

  Result<void> record(const std::string& path) {
    auto log = McapWriter::open(path);
    if (!log) return log.error();
    log_ = std::move(*log);
    return {};
  }
  void update() {
    if (!camera_.look(simulation_.world(), percept_)) return;
    tracker_.update(percept_);
    if (log_) log_->write("/CeilingCameraPercept", percept_.time, percept_);
  }
  /// How things are for a robot; null if nobody can tell. Compares camera and oracle.
  const OracledWorldState* of(std::size_t robot, Tally& tally) {
    const OracledWorldState& oracle = simulation_.input(robot).oracle;
    const Player& player = simulation_.players()[robot];
    const bool seen = tracker_.tell(player.teamColor, player.number(), oracle.time, state_);
    if (seen) {
      tally.measure("ceiling.robot.position", "mm",
                    (state_.robotPose.translation - oracle.robotPose.translation).norm());
      tally.measure("ceiling.ball.position", "mm",
                    (state_.ballPosition - oracle.ballPosition).norm());
      tally.measure("ceiling.ball.speed", "mm/s", (state_.ballSpeed - oracle.ballSpeed).norm());
    }
    if (!useCeiling_) return &oracle;
    return seen ? &state_ : nullptr;
  }

 private:
  const Simulation& simulation_;
  bool useCeiling_;
  CeilingCamera camera_;
  CeilingCameraPercept percept_;
  CeilingTracker tracker_;
  OracledWorldState state_;
  std::optional<McapWriter> log_;
};

/// Looks at all robots after a picture.
void look(Match& match, std::vector<std::unique_ptr<Watch>>& watches, int picture, Truth& truths,
          Tally& tally) {
  const auto& robots = match.robots();
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const std::size_t index = match.robotIndex(i);
    if (match.simulation().input(index).game.penalty != Penalty::none || !robots[i]->pose())
      continue;
    const OracledWorldState* truth = truths.of(index, tally);
    if (!truth) continue;
    watches[i]->ball.update(*robots[i], *truth, tally);
    compareObstacles(*robots[i], *truth, tally);
    comparePlayers(*robots[i], *truth, tally);
    const Player& player = robots[i]->robot().setup().player;
    const RobotPose& pose = *robots[i]->pose();
    const BallModel& ball = watches[i]->ball.probabilistic();
    const Time now = truth->time;
    for (TeamBallWatch& team : watches[i]->team) team.update(ball, pose, *truth, player, tally);
    if (picture % picturesPerTeamMessage != 0) continue;
    for (std::size_t k = 0; k < robots.size(); ++k)
      if (k != i && robots[k]->robot().setup().player.teamColor == player.teamColor)
        for (TeamBallWatch& team : watches[k]->team)
          team.send(messageOf(player, pose, ball, now), now);
  }
}

Result<Tally> watchMatch(std::uint64_t seed, const ExperimentOptions& how) {
  MatchOptions options;
  options.seed = seed;
  options.minutes = std::min(how.minutes, 4.);
  auto match = Match::make(options);
  if (!match) return match.error();
  Truth truth{(*match)->simulation(), how, seed};
  if (!how.ceilingLogs.empty())
    if (auto done = truth.record(how.ceilingLogs + "/ceiling-" + std::to_string(seed) + ".mcap");
        !done)
      return done.error();
  std::vector<std::unique_ptr<Watch>> watches;
  for (std::size_t i = 0; i < (*match)->robots().size(); ++i)
    watches.push_back(std::make_unique<Watch>(seed * 100 + i));
  Tally tally;
  for (int picture = 0; !(*match)->finished();) {
    (*match)->step();
    truth.update();
    const Simulation& simulation = (*match)->simulation();
    if (!simulation.input(0).image || simulation.referee().state() != GameState::playing) continue;
    look(**match, watches, ++picture, truth, tally);
  }
  return tally;
}

/// The mean, the median and the 95th percentile of the sizes of each kind of error, and each rate.
void report(const std::vector<Tally>& runs, Figures& figures) {
  Tally all;
  for (const Tally& run : runs) {
    for (const auto& [name, rate] : run.rates) all.rates[name];
    for (const auto& [name, list] : run.errors) all.errors[name].unit = list.unit;
  }
  const auto valuesOf = [&](auto map, const std::string& name, auto of) {
    std::vector<double> values;
    for (const Tally& run : runs)
      if (const auto found = (run.*map).find(name); found != (run.*map).end())
        values.push_back(of(found->second));
    return values;
  };
  for (const auto& entry : all.rates)
    figures.add(
        "worldmodel." + entry.first, "%",
        valuesOf(&Tally::rates, entry.first, [](const Tally::Rate& r) { return r.percent(); }));
  for (const auto& [name, list] : all.errors) {
    const auto meanSize = [](const Tally::Errors& e) {
      double sum = 0;
      for (const double v : e.values) sum += std::abs(v);
      return sum / static_cast<double>(e.values.size());
    };
    figures.add("worldmodel." + name + ".mean", list.unit,
                valuesOf(&Tally::errors, name, meanSize));
    for (const auto& [suffix, share] : {std::pair{".median", 0.5}, std::pair{".p95", 0.95}})
      figures.add("worldmodel." + name + suffix, list.unit,
                  valuesOf(&Tally::errors, name,
                           [share = share](const Tally::Errors& e) { return e.size(share); }));
  }
}

}  // namespace

Result<void> measureWorldModel(Figures& figures, const ExperimentOptions& options) {
  std::vector<Result<Tally>> results(options.seeds.size(), Tally{});
  inParallel(results.size(),
             [&](std::size_t i) { results[i] = watchMatch(options.seeds[i], options); });
  std::vector<Tally> runs;
  for (Result<Tally>& result : results) {
    if (!result) return result.error();
    runs.push_back(*std::move(result));
  }
  report(runs, figures);
  return {};
}

}  // namespace gt
