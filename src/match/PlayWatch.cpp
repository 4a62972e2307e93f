#include "match/PlayWatch.h"

#include <algorithm>
#include <cmath>

#include "simulation/world/Oracle.h"

namespace gt {

bool rollsIntoGoal(const BallState& ball, TeamColor shooter, const FieldDimensions& field,
                   double deceleration) {
  const Vector2d from = toTeam(shooter, ball.position), speed = toTeam(shooter, ball.speed);
  const double ahead = field.xGroundline - from.x();
  if (ahead <= 0) return std::abs(from.y()) < field.yGoal;
  if (speed.x() <= 0) return false;
  const double across = from.y() + speed.y() / speed.x() * ahead;
  const double way = ahead * speed.norm() / speed.x();
  return std::abs(across) < field.yGoal && speed.squaredNorm() / (2 * deceleration) > way;
}

void PlayWatch::see(const PlayMoment& moment) {
  moment_ = moment;
  robots_.resize(moment.robots.size());
  measureSpeeds();
  ledger_.see(moment_);
  watchRoles();
  watchAreas();
  watchGoalies();
  shots_.see(moment_);
  kicks_.see(moment_);
}

// Computes speeds as means over the last ticks, since a walking body sways.
void PlayWatch::measureSpeeds() {
  constexpr double memory = 0.4;   // s
  constexpr double carried = 100;  // mm in a tick: it was put there
  constexpr double share = tickSeconds / memory;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    RobotRecord& record = robots_[i];
    PlayMoment::Robot& robot = moment_.robots[i];
    record.team = robot.team;
    const Vector2d step = robot.position - record.position;
    if (step.norm() < carried)
      record.speed += share * (step / tickSeconds - record.speed);
    else
      record.speed.setZero();
    record.position = robot.position;
    robot.speed = record.speed;
  }
}

void PlayWatch::watchRoles() {
  constexpr int back = 1000;   // ms
  constexpr double far = 700;  // mm
  PerTeam<int> strikers{}, fieldPlayers{};
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const PlayMoment::Robot& robot = moment_.robots[i];
    RobotRecord& record = robots_[i];
    TeamRecord& team = of(robot.team);
    if (!robot.hasRole) continue;
    fieldPlayers[indexOf(robot.team)] += robot.plays && robot.role != DynamicRole::goalie;
    if (robot.plays && robot.role == DynamicRole::striker) {
      ++strikers[indexOf(robot.team)];
      team.unseen.count(robot.ballUnseen > ballLost);
      if (robot.distanceTo(moment_.ball) > far) team.strikerSpeed.add(robot.speed.norm());
    }
    if (robot.role == record.role) continue;
    team.rolesKept.count(robot.role != record.before || moment_.time - record.changed > back);
    record.before = std::exchange(record.role, robot.role);
    record.changed = moment_.time;
  }
  for (const TeamColor team : teamColors) {
    const std::size_t index = indexOf(team);
    if (fieldPlayers[index] == 0) continue;
    teams_[index].twoStrikers.count(strikers[index] > 1);
    teams_[index].noStriker.count(strikers[index] == 0);
  }
}

void PlayWatch::watchAreas() {
  for (const PlayMoment::Robot& robot : moment_.robots) {
    const Vector2d place = toTeam(robot.team, robot.position);
    const bool isInside =
        place.x() < -field_.xPenaltyArea && std::abs(place.y()) < field_.yPenaltyArea;
    if (robot.plays && robot.role != DynamicRole::goalie && isInside)
      of(robot.team).inOwnArea += tickSeconds;
  }
}

void PlayWatch::watchGoalies() {
  constexpr double beside = 400, isLong = 1;  // mm, s
  const BallState& ball = moment_.ball;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const PlayMoment::Robot& robot = moment_.robots[i];
    if (robot.role != DynamicRole::goalie) continue;
    RobotRecord& record = robots_[i];
    const bool lies = ball.speed.norm() < rollingBall && robot.distanceTo(ball) < beside;
    const bool isUnseen = lies && robot.ballUnseen > ballLost;
    record.ballBeside = lies ? record.ballBeside + tickSeconds : 0;
    record.besideUnseen = isUnseen ? record.besideUnseen + tickSeconds : 0;
    if (record.ballBeside > isLong) record.leftBall = moment_.time;
    if (record.besideUnseen > isLong) record.missedBall = moment_.time;
    if (ball.lastToucher != static_cast<int>(i) &&
        rollsIntoGoal(ball, opponent(robot.team), field_, deceleration_))
      of(robot.team).shot = moment_.time;
  }
}

GoalCause PlayWatch::causeOf(TeamColor letIn) const {
  constexpr std::int64_t recently = 3000;  // ms
  const auto goalie = std::ranges::find_if(robots_, [&](const RobotRecord& record) {
    return record.role == DynamicRole::goalie && record.team == letIn;
  });
  if (goalie == robots_.end()) return GoalCause::shot;
  const bool wasShot = moment_.time - teams_[indexOf(letIn)].shot < recently;
  if (!wasShot && moment_.ball.lastToucher == goalie - robots_.begin()) return GoalCause::touched;
  if (moment_.time - goalie->missedBall < recently) return GoalCause::unseen;
  return moment_.time - goalie->leftBall < recently ? GoalCause::beside : GoalCause::shot;
}

void PlayWatch::note(const GameEvent& event) {
  switch (event.type) {
    case GameEventType::goal:
      return goal(event.team);
    case GameEventType::penalty:
      ++of(event.team).penalties[event.penalty];
      return;
    case GameEventType::stuckBall:
    case GameEventType::ballOut:
    case GameEventType::kickOff:
      return interrupt();
    default:
      return;
  }
}

void PlayWatch::goal(TeamColor team) {
  ++of(team).goals;
  ++of(opponent(team)).letIn[causeOf(opponent(team))];
  kicks_.goal(team);
  shots_.goal(team);
}

void PlayWatch::interrupt() {
  kicks_.interrupt();
  shots_.interrupt();
  for (TeamRecord& team : teams_) team.shot = never();
  for (RobotRecord& record : robots_) {
    record.leftBall = record.missedBall = never();
    record.ballBeside = record.besideUnseen = 0;
  }
}

std::vector<PlayFigure> PlayWatch::figures(double minutes) const {
  PlayFigures figures;
  ledger_.report(figures);
  for (const TeamColor color : teamColors) {
    const TeamRecord& team = teams_[indexOf(color)];
    const auto name = [&](const std::string& figure) { return teamFigure(color, figure); };
    const auto inFive = [&](double value) { return value * 5 / minutes; };
    figures.add(name("goals"), "goals", team.goals);
    for (std::size_t i = 0; i < enumCount<GoalCause>; ++i) {
      const auto cause = static_cast<GoalCause>(i);
      figures.add(name("letIn." + std::string{enumName(cause)}), "goals", team.letIn[cause]);
    }
    int penalties = 0;
    for (std::size_t i = 0; i < enumCount<Penalty>; ++i) {
      const auto penalty = static_cast<Penalty>(i);
      if (penalty == Penalty::none) continue;
      penalties += team.penalties[penalty];
      figures.add(name("penalties." + std::string{enumName(penalty)}), "in 5 min",
                  inFive(team.penalties[penalty]));
    }
    figures.add(name("penalties"), "in 5 min", inFive(penalties));
    figures.add(name("ownArea"), "s in 5 min", inFive(team.inOwnArea));
    figures.share(name("strikers.two"), team.twoStrikers);
    figures.share(name("strikers.none"), team.noStriker);
    figures.share(name("striker.unseen"), team.unseen);
    figures.share(name("roles.kept"), team.rolesKept);
    if (team.strikerSpeed.count() > 0)
      figures.add(name("striker.speed"), "mm/s", team.strikerSpeed.mean());
  }
  kicks_.report(minutes, figures);
  shots_.report(figures);
  return figures.take();
}

}  // namespace gt
