#include "PlayWatch.h"

#include <algorithm>
#include <array>

#include "base/Enum.h"
#include "simulation/Oracle.h"

namespace gt {
namespace {

std::string nameOf(TeamColor team, const char* figure) {
  return std::string{enumName(team)} + '.' + figure;
}

}  // namespace

void PlayWatch::see(const PlayMoment& moment) {
  robots_.resize(moment.robots.size());
  const auto distance = [&](const PlayMoment::Robot& robot) {
    return (robot.position - moment.ball.position).norm();
  };
  constexpr double near = 300, moves = 20;  // mm, mm/s
  const bool isNear = std::ranges::any_of(
      moment.robots, [&](const auto& robot) { return robot.plays && distance(robot) < near; });
  tally_.count("ball.idle", !isNear && moment.ball.speed.norm() < moves);
  if (const int toucher = moment.ball.lastToucher; toucher >= 0)
    robots_[static_cast<std::size_t>(toucher)].touched = moment.ball.lastTouched;
  watchRoles(moment);
  watchAreas(moment);
  watchGoalies(moment);
  watchKick(moment);
  ball_ = moment.ball;
  time_ = moment.time;
}

void PlayWatch::watchRoles(const PlayMoment& moment) {
  constexpr double lostFor = 1000;  // ms
  constexpr int back = 1000;        // ms
  std::array<int, 2> strikers{}, fieldPlayers{};
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const PlayMoment::Robot& robot = moment.robots[i];
    RobotRecord& record = robots_[i];
    fieldPlayers[static_cast<std::size_t>(robot.team)] +=
        robot.plays && robot.role != DynamicRole::goalie;
    if (robot.plays && robot.role == DynamicRole::striker) {
      ++strikers[static_cast<std::size_t>(robot.team)];
      tally_.count(nameOf(robot.team, "striker.unseen"), robot.ballUnseen > lostFor);
    }
    if (robot.role == record.role) continue;
    tally_.count(nameOf(robot.team, "roles.kept"),
                 robot.role != record.before || moment.time - record.changed > back);
    record.before = std::exchange(record.role, robot.role);
    record.changed = moment.time;
  }
  for (const TeamColor team : {TeamColor::red, TeamColor::blue}) {
    const auto index = static_cast<std::size_t>(team);
    tally_.count(nameOf(team, "strikers.two"), strikers[index] > 1);
    if (fieldPlayers[index] > 0) tally_.count(nameOf(team, "strikers.none"), strikers[index] == 0);
  }
}

void PlayWatch::watchAreas(const PlayMoment& moment) {
  for (const PlayMoment::Robot& robot : moment.robots) {
    const Vector2d place = toTeam(robot.team, robot.position);
    const bool isInside =
        place.x() < -field_.xPenaltyArea && std::abs(place.y()) < field_.yPenaltyArea;
    if (robot.plays && robot.role != DynamicRole::goalie && isInside)
      inOwnArea_[static_cast<std::size_t>(robot.team)] += tickSeconds;
  }
}

void PlayWatch::watchGoalies(const PlayMoment& moment) {
  constexpr double beside = 400, rests = 50, isLong = 1;  // mm, mm/s, s
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const PlayMoment::Robot& robot = moment.robots[i];
    RobotRecord& record = robots_[i];
    const bool lies = robot.role == DynamicRole::goalie && moment.ball.speed.norm() < rests &&
                      (robot.position - moment.ball.position).norm() < beside;
    record.ballBeside = lies ? record.ballBeside + tickSeconds : 0;
    if (record.ballBeside > isLong) record.leftBall = moment.time;
    const TeamColor other = robot.team == TeamColor::red ? TeamColor::blue : TeamColor::red;
    if (robot.role == DynamicRole::goalie && moment.ball.lastToucher != static_cast<int>(i) &&
        rollsIntoGoal(moment.ball, other))
      shot_[static_cast<std::size_t>(robot.team)] = moment.time;
  }
}

void PlayWatch::watchKick(const PlayMoment& moment) {
  const BallState& ball = moment.ball;
  if (kick_) {
    Kick& kick = *kick_;
    const PlayMoment::Robot& kicker = moment.robots[kick.robot];
    const bool touchedByKicker = ball.lastToucher == static_cast<int>(kick.robot);
    constexpr int longest = 8000, leaves = 200;  // ms
    if (!kick.free) {
      if (touchedByKicker && ball.lastTouched >= kick.began) {
        kick.lastTouch = ball.lastTouched;
        kick.onGoal = rollsIntoGoal(ball, kicker.team);
      }
      const bool hit = kick.lastTouch >= kick.began;
      if (hit && (!touchedByKicker || (moment.time - kick.lastTouch > leaves && !kicker.kicks))) {
        leave();
      } else if (moment.time - kick.began > longest) {
        tally_.count(nameOf(kicker.team, "kick.hits"), false);
        kick_.reset();
      }
    }
    if (kick_ && kick.free && ball.lastTouched > kick.lastTouch && ball.lastToucher >= 0) {
      end(moment.robots[static_cast<std::size_t>(ball.lastToucher)].team == kicker.team);
    }
  }
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const PlayMoment::Robot& robot = moment.robots[i];
    if (robot.kicks && !robots_[i].kicked) beginKick(moment, i);
    robots_[i].kicked = robot.kicks;
  }
  teams_.resize(moment.robots.size());
  std::ranges::transform(moment.robots, teams_.begin(), &PlayMoment::Robot::team);
}

void PlayWatch::beginKick(const PlayMoment& moment, std::size_t robot) {
  const TeamColor team = moment.robots[robot].team;
  ++kicks_[static_cast<std::size_t>(team)];
  kick_ = Kick{robot, moment.time, moment.ball.position};
  Time touched = never();
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (i != robot) touched = std::max(touched, robots_[i].touched);
  if (touched != never())
    tally_.measure(nameOf(team, "kick.afterTouch"), "s",
                   static_cast<double>(moment.time - touched) / 1000);
}

void PlayWatch::leave() {
  const TeamColor team = teams_[kick_->robot];
  kick_->free = true;
  tally_.count(nameOf(team, "kick.hits"), true);
  const Vector2d goal = toTeam(team, Vector2d{field_.xGroundline, 0});
  constexpr double shot = 1600;  // mm
  if ((kick_->from - goal).norm() < shot) tally_.count(nameOf(team, "kick.onGoal"), kick_->onGoal);
}

void PlayWatch::end(bool own) {
  const TeamColor team = teams_[kick_->robot];
  tally_.count(nameOf(team, "kick.nextTouch.own"), own);
  if (kick_->onGoal)
    tally_.count(nameOf(team == TeamColor::red ? TeamColor::blue : TeamColor::red, "goal.saved"),
                 true);
  kick_.reset();
}

GoalCause PlayWatch::causeOf(TeamColor letIn) const {
  constexpr std::int64_t recently = 3000;  // ms
  const auto goalie = std::ranges::find_if(robots_, [&](const RobotRecord& record) {
    return record.role == DynamicRole::goalie &&
           teams_[static_cast<std::size_t>(&record - robots_.data())] == letIn;
  });
  if (goalie == robots_.end()) return GoalCause::shot;
  const bool wasShot = time_ - shot_[static_cast<std::size_t>(letIn)] < recently;
  if (!wasShot && ball_.lastToucher == goalie - robots_.begin()) return GoalCause::touched;
  return time_ - goalie->leftBall < recently ? GoalCause::beside : GoalCause::shot;
}

void PlayWatch::goal(TeamColor team) {
  const TeamColor letIn = team == TeamColor::red ? TeamColor::blue : TeamColor::red;
  ++letIn_[static_cast<std::size_t>(letIn)][causeOf(letIn)];
  if (!kick_) return;
  if (!kick_->free && kick_->lastTouch >= kick_->began) leave();
  const TeamColor kicker = teams_[kick_->robot];
  tally_.count(nameOf(kicker, "kick.nextTouch.own"), kicker == team);
  if (kick_->onGoal && kicker == team)
    tally_.count(nameOf(kicker == TeamColor::red ? TeamColor::blue : TeamColor::red, "goal.saved"),
                 false);
  kick_.reset();
}

void PlayWatch::interrupt() {
  kick_.reset();
  shot_ = {never(), never()};
  for (RobotRecord& record : robots_) {
    record.touched = record.leftBall = never();
    record.ballBeside = 0;
  }
}

bool PlayWatch::rollsIntoGoal(const BallState& ball, TeamColor shooter) const {
  const Vector2d from = toTeam(shooter, ball.position), speed = toTeam(shooter, ball.speed);
  const double ahead = field_.xGroundline - from.x();
  if (ahead <= 0) return std::abs(from.y()) < field_.yGoal;
  if (speed.x() <= 0) return false;
  const double across = from.y() + speed.y() / speed.x() * ahead;
  const double way = ahead * speed.norm() / speed.x();
  return std::abs(across) < field_.yGoal && speed.squaredNorm() / (2 * deceleration_) > way;
}

}  // namespace gt
