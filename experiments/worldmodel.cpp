// Measures what robots know of the world around them while they play: the ball by each locator, the
// team's ball, obstacles and players, against the truth (report 3.4 to 3.7).
#include <optional>
#include <utility>
#include <vector>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "WorldModelWatch.h"
#include "simulation/sensors/CeilingCamera.h"
#include "simulation/sensors/CeilingTracker.h"
#include "streams/mcap/Mcap.h"

namespace gt {
namespace {

constexpr const char* noLogs = "none";

/// What is watched: the ball by each robot, and the team's ball by radios like the scene's.
struct Watches {
  Watches(const Simulation& simulation, std::uint64_t seed) {
    const std::vector<Player>& players = simulation.players();
    balls.resize(players.size());
    RadioParameters radio = simulation.scene().radio;
    const auto add = [&](const std::string& name, bool oneIsLost) {
      team.emplace_back(name, radio, oneIsLost, players, Random{seed}.fork("team ball " + name));
    };
    add("radio", false);
    add("onelost", true);
    radio.loss = 0.5;
    add("loss50", false);
  }
  std::vector<BallWatch> balls;  ///< Of each robot of the simulation.
  std::vector<TeamBallWatch> team;
};

/// The message of a robot, with the ball of the locator that estimates its standard deviation.
TeamMessage messageOf(const Player& player, const RobotPose& pose, const BallModel& ball,
                      Time now) {
  TeamMessage message;
  message.playerNumber = player.number();
  message.timeSent = now;
  message.robotPose = pose.pose;
  message.robotPoseValidity = pose.validity;
  message.ballPosition = pose.pose * ball.position;
  message.ballSpeed = rotated(ball.speed, pose.pose.rotation);
  message.ballStandardDeviation = ball.standardDeviation;
  message.ballLastSeen = ball.lastSeen;
  return message;
}

/// The truth: the oracle's, or that of a camera at the ceiling.
class Truth {
 public:
  Truth(const Simulation& simulation, const Job& job)
      : simulation_{simulation},
        useCeiling_{job.parameter("truth") == "ceiling"},
        camera_{{}, simulation.players(), Random{job.seed}.fork("ceiling camera")} {}

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
  /// How things are for a robot; null if that is unknown. Compares camera and oracle.
  const OracledWorldState* of(std::size_t robot, Tally& tally) {
    const OracledWorldState& oracle = simulation_.input(robot).oracle;
    const Player& player = simulation_.players()[robot];
    const bool seen = tracker_.fill(player.teamColor, player.number(), oracle.time, state_);
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

/// Looks at all robots after an image.
void look(Match& match, Watches& watches, int picture, Truth& truths, Tally& tally) {
  const auto& robots = match.robots();
  std::vector<std::pair<std::size_t, TeamMessage>> messages;
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const std::size_t index = match.robotIndex(i);
    if (match.simulation().input(index).game.penalty != Penalty::none || !robots[i]->belief().pose)
      continue;
    const OracledWorldState* truth = truths.of(index, tally);
    if (!truth) continue;
    watches.balls[index].update(*robots[i], *truth, tally);
    compareObstacles(*robots[i], *truth, tally);
    const Player& player = robots[i]->robot().setup().player;
    if (const auto* players = robots[i]->robot().provided<PlayersCollection>())
      comparePlayers(*players, player.teamColor, *truth, tally);
    const RobotPose& pose = *robots[i]->belief().pose;
    const BallModel& ball = watches.balls[index].probabilistic();
    for (TeamBallWatch& team : watches.team) team.update(index, ball, pose, *truth, tally);
    if (picture % imagesPerTeamMessage == 0)
      messages.emplace_back(index, messageOf(player, pose, ball, truth->time));
  }
  for (const auto& [index, message] : messages)
    for (TeamBallWatch& team : watches.team) team.send(index, message, message.timeSent);
}

Result<Tally> watchMatch(const Job& job, const DataRoot& root) {
  auto match = makeMatch(job, root);
  if (!match) return match.error();
  Truth truth{(*match)->simulation(), job};
  if (const std::string& folder = job.parameter("logs"); folder != noLogs)
    if (auto done = truth.record(folder + "/ceiling-" + std::to_string(job.seed) + ".mcap"); !done)
      return done.error();
  Watches watches{(*match)->simulation(), job.seed};
  Tally tally;
  for (int picture = 0; !(*match)->finished();) {
    (*match)->step();
    truth.update();
    const Simulation& simulation = (*match)->simulation();
    if (!simulation.input(0).image || simulation.referee().state() != GameState::playing) continue;
    look(**match, watches, ++picture, truth, tally);
  }
  if (const auto done = (*match)->soundness(); !done) return done.error();
  return tally;
}

/// Each rate, and a summary of the sizes of each kind of error.
Result<Measurement> measureWorldModel(const Job& job, const DataRoot& root) {
  const auto tally = watchMatch(job, root);
  if (!tally) return tally.error();
  Measurement measured;
  for (const auto& [name, rate] : tally->rates)
    measured.add("worldmodel." + name, "%", rate.percent());
  for (const auto& [name, errors] : tally->errors)
    for (const auto& [of, value] : summaryOf(errors.sizes()))
      measured.add("worldmodel." + name + '.' + of, errors.unit, value);
  return measured;
}

}  // namespace

Experiment worldModelExperiment() {
  return {"worldmodel.play",
          "What robots that play know of ball, obstacles and other players, against the truth",
          {profileParameter(),
           {"minutes", "of the match", Parameter::Kind::number, {"4"}},
           {"truth",
            "the simulator's, or that of a camera at the ceiling",
            Parameter::Kind::choice,
            {"oracle", "ceiling"}},
           {"logs", "folder for the logs of that camera", Parameter::Kind::text, {noLogs}},
           valuesParameter()},
          withValues<measureWorldModel>};
}

}  // namespace gt
