// The results of a match: its summary, with the robots whose programs failed, and its times.
#include <algorithm>
#include <filesystem>
#include <iterator>

#include "match/Match.h"

namespace gt {
namespace {

namespace fs = std::filesystem;

MatchEvent toMatchEvent(const GameEvent& event) {
  return {event.time,      std::string{enumName(event.type)},
          describe(event), event.team,
          event.number,    event.ownGoal,
          event.scoreRed,  event.scoreBlue};
}

/// Describes how a remote robot did not keep up; empty if it did.
std::string shortfall(const RemoteRobot& robot) {
  const RemoteStatistics& s = robot.statistics();
  if (s.frames == 0) return "no program has come";
  if (s.missedFrames * 10 <= s.frames) return "";
  return "its program gave no commands in " + std::to_string(s.missedFrames) + " of " +
         std::to_string(s.frames) + " frames";
}

}  // namespace

Result<void> Match::soundness() const {
  return failures_.empty() ? Result<void>{} : failures_.front().error;
}

/// Adds failures of the last tick.
void Match::noteFailures() {
  const auto note = [this](std::size_t robot, const Error& error) {
    if (std::ranges::find(failures_, robot, &RobotFailure::robot) == failures_.end())
      failures_.push_back({time(), robot, error});
  };
  const std::vector<SceneRobot>& robots = simulation_->scene().robots;
  for (std::size_t i = 0; i < robots.size(); ++i)
    if (const std::string& what = simulation_->failure(i); !what.empty())
      note(i, {.field = robots[i].name, .what = what});
  forEachRobot<LockstepRobot>([&](std::size_t index, const LockstepRobot& robot) {
    if (robot.failure()) note(index, *robot.failure());
  });
}

/// Adds failures as events, each at its time; those of remote robots at the end.
void Match::addFailures(MatchSummary& summary) const {
  std::vector<RobotFailure> failures = failures_;
  forEachRobot<RemoteRobot>([&](std::size_t index, const RemoteRobot& robot) {
    if (const std::string what = shortfall(robot); !what.empty())
      failures.push_back({time(), index, {.field = robot.name(), .what = what}});
  });
  for (const RobotFailure& failure : failures) {
    const auto place =
        std::ranges::upper_bound(summary.events, failure.time, {}, &MatchEvent::time);
    const Player& player = simulation_->players()[failure.robot];
    MatchEvent event{.time = failure.time,
                     .kind = "failure",
                     .text = failure.error.text(),
                     .team = player.teamColor,
                     .player = player.number()};
    if (place != summary.events.begin()) {
      event.redScore = std::prev(place)->redScore;
      event.blueScore = std::prev(place)->blueScore;
    }
    summary.events.insert(place, std::move(event));
  }
}

MatchSummary Match::summary() const {
  MatchSummary summary;
  summary.scene = fs::path{options_.scene}.filename().string();
  summary.seed = options_.seed;
  summary.duration = simulation_->time();
  summary.redScore = simulation_->referee().score(TeamColor::red);
  summary.blueScore = simulation_->referee().score(TeamColor::blue);
  for (const GameEvent& event : simulation_->referee().events())
    summary.events.push_back(toMatchEvent(event));
  addFailures(summary);
  if (invariants_) summary.broken = invariants_->broken();
  if (challenge_)
    for (const Challenge::Note& note : challenge_->notes())
      summary.events.push_back({.time = note.time, .kind = "challenge", .text = note.text});
  for (const SimulatedRobot* robot : robots_)
    if (robot->hadTruth()) summary.truth.push_back(robot->name());
  statistics_->summarize(summary);
  for (RobotSummary& robot : summary.robots) {
    if (!options_.logs.empty() &&
        std::ranges::count(robots_, robot.name, &SimulatedRobot::name) > 0)
      robot.log = robot.name + ".mcap";
    for (const GameEvent& event : simulation_->referee().events()) {
      if (event.type != GameEventType::goal || event.number != robot.player) continue;
      robot.goals += !event.ownGoal && event.team == robot.team;
      robot.ownGoals += event.ownGoal && event.team != robot.team;
    }
  }
  return summary;
}

std::vector<PartTime> Match::times() const {
  std::vector<PartTime> parts;
  const auto add = [&](const Stopwatch& watch) {
    if (watch.count == 0) return;
    auto part = std::find_if(parts.begin(), parts.end(),
                             [&](const PartTime& p) { return p.part == watch.name; });
    if (part == parts.end()) part = parts.insert(parts.end(), PartTime{watch.name, 0, 0});
    part->count += watch.count;
    part->totalMs += watch.totalMs;
  };
  for (const SimulatedRobot* robot : robots_)
    for (const auto& process : robot->robot().processes())
      for (const Stopwatch& watch : process->times()) add(watch);
  for (const Stopwatch* watch : simulation_->times()) add(*watch);
  for (const SimulatedRobot* robot : robots_) add(robot->logTime());
  return parts;
}

}  // namespace gt
