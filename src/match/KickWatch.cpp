#include "match/KickWatch.h"

#include "simulation/world/Oracle.h"

namespace gt {

void KickWatch::see(const PlayMoment& moment) {
  robots_.resize(moment.robots.size());
  elapsed_ = time_ == never() ? 0 : static_cast<double>(moment.time - time_) / 1000;
  time_ = moment.time;
  watchApproaches(moment);
  followKick(moment);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const PlayMoment::Robot& robot = moment.robots[i];
    if (robot.kicks && !robots_[i].kicked) begin(moment, i);
    robots_[i].kicked = robot.kicks;
  }
  ball_ = moment.ball;
}

void KickWatch::watchApproaches(const PlayMoment& moment) {
  const BallState& ball = moment.ball;
  const bool isTouched = ball.lastToucher >= 0 && ball.lastTouched > ball_.lastTouched;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Approach& approach = robots_[i].approach;
    if (isTouched && ball.lastToucher != static_cast<int>(i)) {
      approach = {.known = true};
      continue;
    }
    if (!approach.known) continue;
    double& part = moment.robots[i].distanceTo(ball) < atBall ? approach.lines
                   : ball.speed.norm() > rollingBall          ? approach.rolls
                                                              : approach.comes;
    part += elapsed_;
  }
}

void KickWatch::followKick(const PlayMoment& moment) {
  if (!kick_) return;
  constexpr int longest = 8000, leaves = 200;  // ms
  const BallState& ball = moment.ball;
  Kick& kick = *kick_;
  const PlayMoment::Robot& kicker = moment.robots[kick.robot];
  const bool touchedByKicker = ball.lastToucher == static_cast<int>(kick.robot);
  if (!kick.free) {
    if (touchedByKicker && ball.lastTouched >= kick.began) {
      kick.lastTouch = ball.lastTouched;
      kick.onGoal = rollsIntoGoal(ball, kick.team, field_, deceleration_);
    }
    const bool hit = kick.lastTouch >= kick.began;
    if (hit && (!touchedByKicker || (moment.time - kick.lastTouch > leaves && !kicker.kicks))) {
      leave();
    } else if (moment.time - kick.began > longest) {
      of(kick.team).hits.count(false);
      kick_.reset();
    }
  }
  if (kick_ && kick_->free && ball.lastTouched > kick_->lastTouch && ball.lastToucher >= 0) {
    const bool own = moment.robots[static_cast<std::size_t>(ball.lastToucher)].team == kick_->team;
    end(ball_.position, own, own && !touchedByKicker);
  }
}

void KickWatch::begin(const PlayMoment& moment, std::size_t robot) {
  const TeamColor team = moment.robots[robot].team;
  // The robot that kicks next counts as the next to touch the ball.
  if (kick_ && kick_->free)
    end(moment.ball.position, kick_->team == team, kick_->team == team && kick_->robot != robot);
  TeamRecord& record = of(team);
  ++record.kicks;
  kick_ = Kick{robot, team, moment.time, moment.ball.position, {}};
  if (moment.robots[robot].hasRole)
    kick_->planned = moment.robots[robot].kickTarget - moment.ball.position;
  const Approach& approach = robots_[robot].approach;
  if (!approach.known) return;
  record.afterTouch.push_back(approach.rolls + approach.comes + approach.lines);
  record.rolls.push_back(approach.rolls);
  record.comes.push_back(approach.comes);
  record.lines.push_back(approach.lines);
}

void KickWatch::leave() {
  constexpr double shot = 1600;  // mm
  kick_->free = true;
  TeamRecord& record = of(kick_->team);
  record.hits.count(true);
  const Vector2d goal = toTeam(kick_->team, Vector2d{field_.xGroundline, 0});
  if ((kick_->from - goal).norm() < shot) record.onGoal.count(kick_->onGoal);
}

void KickWatch::end(const Vector2d& ball, bool own, bool pass) {
  constexpr double back = 100;  // mm
  TeamRecord& record = of(kick_->team);
  const Vector2d way = toTeam(kick_->team, Vector2d{ball - kick_->from});
  record.ways.push_back(way.norm());
  comparePlan(ball - kick_->from);
  record.back.count(way.x() < -back);
  record.ownTouch.count(own);
  record.passes.count(pass);
  if (kick_->onGoal) of(opponent(kick_->team)).saved.count(true);
  kick_.reset();
}

void KickWatch::comparePlan(const Vector2d& way) {
  constexpr double moved = 100;  // mm
  if (!kick_->planned || kick_->planned->norm() < moved) return;
  TeamRecord& record = of(kick_->team);
  record.ofPlanned.push_back(100 * way.norm() / kick_->planned->norm());
  if (way.norm() > moved)
    record.offPlanned.push_back(
        toDegrees(std::abs(normalize(angleOf(way) - angleOf(*kick_->planned)))));
}

void KickWatch::goal(TeamColor team) {
  if (!kick_) return;
  if (!kick_->free && kick_->lastTouch >= kick_->began) leave();
  of(kick_->team).ownTouch.count(kick_->team == team);
  if (kick_->onGoal && kick_->team == team) of(opponent(team)).saved.count(false);
  kick_.reset();
}

void KickWatch::interrupt() {
  kick_.reset();
  for (Record& record : robots_) record.approach = {};
}

void KickWatch::report(double minutes, PlayFigures& figures) const {
  for (const TeamColor team : teamColors) {
    const TeamRecord& record = teams_[indexOf(team)];
    const auto name = [&](const char* figure) { return teamFigure(team, figure); };
    figures.add(name("kicks"), "1/min", record.kicks / minutes);
    figures.share(name("kick.hits"), record.hits);
    figures.share(name("kick.onGoal"), record.onGoal);
    figures.share(name("kick.back"), record.back);
    figures.share(name("kick.nextTouch.own"), record.ownTouch);
    figures.share(name("kick.pass"), record.passes);
    figures.share(name("goal.saved"), record.saved);
    figures.spread(name("kick.way"), "mm", record.ways);
    figures.spread(name("kick.ofPlanned"), "%", record.ofPlanned);
    figures.spread(name("kick.offPlanned"), "deg", record.offPlanned);
    figures.spread(name("kick.afterTouch"), "s", record.afterTouch);
    figures.spread(name("kick.afterTouch.rolls"), "s", record.rolls);
    figures.spread(name("kick.afterTouch.comes"), "s", record.comes);
    figures.spread(name("kick.afterTouch.linesUp"), "s", record.lines);
  }
}

}  // namespace gt
