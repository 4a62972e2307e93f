#include "match/MatchStatistics.h"

#include <algorithm>
#include <cmath>

#include "base/Statistics.h"
#include "simulation/world/Oracle.h"

namespace gt {
namespace {

/// A robot that is further from where it believes to be does not know where it is.
constexpr double lostDistance = 1000;  // mm

}  // namespace

ErrorStatistics statisticsOf(const std::vector<double>& errors) {
  return {static_cast<std::int64_t>(errors.size()), mean(errors), quantile(errors, 0.5),
          quantile(errors, 0.95), quantile(errors, 1)};
}

MatchStatistics::MatchStatistics(const Simulation& simulation,
                                 const std::vector<MatchRobot*>& robots,
                                 std::vector<std::vector<std::string>> kicks,
                                 const FieldDimensions& field)
    : simulation_{simulation},
      robots_{robots},
      kicks_{std::move(kicks)},
      records_(robots.size()),
      play_{field, simulation.scene().physics.deceleration} {
  moment_.robots.resize(robots.size());
}

void MatchStatistics::update() {
  const bool second = simulation_.time().ms % 1000 == 0;
  const GameState state = simulation_.referee().state();
  const bool running =
      state == GameState::ready || state == GameState::set || state == GameState::playing;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    countActions(i);
    if (simulation_.input(i).image && running) compare(i);
    if (!second) continue;
    RobotSample sample{simulation_.world().robot(i).pose, 0};
    if (const RobotPose* pose = robots_[i]->belief().pose)
      sample.localizationError =
          (toTeam(simulation_.players()[i].teamColor, pose->pose).translation -
           sample.pose.translation)
              .norm();
    records_[i].samples.push_back(sample);
  }
  if (simulation_.world().ballCount() == 0) return;
  if (second) ball_.push_back(simulation_.world().ball(0).position);
  watchPlay();
}

void MatchStatistics::watchPlay() {
  const std::vector<GameEvent>& events = simulation_.referee().events();
  for (; notedEvents_ < events.size(); ++notedEvents_) play_.note(events[notedEvents_]);
  if (simulation_.referee().state() != GameState::playing) return;
  moment_.time = simulation_.time();
  moment_.ball = simulation_.world().ball(0);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Player& player = simulation_.players()[i];
    PlayMoment::Robot& robot = moment_.robots[i];
    robot.team = player.teamColor;
    robot.position = simulation_.world().robot(i).pose.translation;
    robot.plays = simulation_.input(i).game.penalty == Penalty::none;
    robot.kicks = records_[i].kicking;
    robot.action = records_[i].lastAction;
    const BehaviorTeamMessage* decision = robots_[i]->decision();
    robot.hasRole = decision != nullptr;
    if (decision) {
      robot.role = decision->role;
      robot.kickTarget = toTeam(player.teamColor, decision->kickTarget);
    } else if (player.role == PlayerRole::goalie) {
      robot.role = DynamicRole::goalie;
    }
    if (const BallModel* ball = robots_[i]->belief().ball)
      robot.ballUnseen = static_cast<double>(simulation_.image(i).time - ball->lastSeen);
  }
  play_.see(moment_);
}

void MatchStatistics::compare(std::size_t robot) {
  const Pose2D truth =
      toTeam(simulation_.players()[robot].teamColor, simulation_.world().robot(robot).pose);
  RobotRecord& record = records_[robot];
  if (const RobotPose* pose = robots_[robot]->belief().pose) {
    record.localization.push_back((pose->pose.translation - truth.translation).norm());
    record.lostFor = record.localization.back() > lostDistance ? record.lostFor + 1 : 0;
    record.longestLost = std::max(record.longestLost, record.lostFor);
    record.rotation.push_back(std::abs(normalize(pose->pose.rotation - truth.rotation)));
  }
  const BallModel* ball = robots_[robot]->belief().ball;
  if (ball && ball->lastSeen == simulation_.image(robot).time &&
      simulation_.world().ballCount() > 0) {
    const Vector2d onField =
        toTeam(simulation_.players()[robot].teamColor, simulation_.world().ball(0).position);
    record.ball.push_back((ball->position - relative(truth, onField)).norm());
  }
}

void MatchStatistics::countActions(std::size_t robot) {
  RobotRecord& record = records_[robot];
  if (const MotionInfo* motion = robots_[robot]->belief().motion) {
    static const std::string none;
    const std::string& action =
        motion->executed.type == MotionType::specialAction ? motion->executed.specialAction : none;
    if (action != record.lastAction) {
      record.kicking = std::ranges::find(kicks_[robot], action) != kicks_[robot].end();
      if (record.kicking) ++record.kicks[action];
      record.lastAction = action;
    }
  }
  if (const RobotState* state = robots_[robot]->belief().state) {
    record.falls += state->state == BodyState::fallen && record.lastState != BodyState::fallen;
    record.lastState = state->state;
  }
}

std::vector<double> MatchStatistics::localizationErrors() const {
  std::vector<double> all;
  for (const RobotRecord& record : records_)
    all.insert(all.end(), record.localization.begin(), record.localization.end());
  return all;
}

double MatchStatistics::longestLost() const {
  double longest = 0;
  for (const RobotRecord& record : records_) longest = std::max(longest, record.longestLost);
  return longest * tickSeconds * Simulation::ticksPerImage;
}

namespace {

/// The distance that a robot walked (mm), summed from second to second, so that swaying is not
/// counted. Steps of a robot that was carried away are not counted either.
double distanceWalked(const std::vector<RobotSample>& samples) {
  constexpr double longest = 500;  // mm
  double distance = 0;
  for (std::size_t i = 1; i < samples.size(); ++i) {
    const double step = (samples[i].pose.translation - samples[i - 1].pose.translation).norm();
    if (step <= longest) distance += step;
  }
  return distance;
}

}  // namespace

void MatchStatistics::summarize(MatchSummary& summary) const {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const RobotRecord& record = records_[i];
    const Player& player = simulation_.players()[i];
    RobotSummary& robot = summary.robots.emplace_back();
    robot.name = simulation_.scene().robots[i].name;
    robot.team = player.teamColor;
    robot.player = player.number();
    robot.role = player.role;
    robot.localizationError = statisticsOf(record.localization);
    robot.rotationError = statisticsOf(record.rotation);
    robot.ballError = statisticsOf(record.ball);
    robot.distanceWalked = distanceWalked(record.samples);
    robot.falls = record.falls;
    for (const auto& [kick, count] : record.kicks) robot.kicks.push_back({kick, count});
    robot.samples = record.samples;
  }
  summary.ball = ball_;
  summary.shots = play_.shots();
  const double minutes = static_cast<double>(simulation_.time().ms) / 60'000;
  if (minutes > 0) summary.play = play_.figures(minutes);
}

}  // namespace gt
