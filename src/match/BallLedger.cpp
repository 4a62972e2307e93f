#include "match/BallLedger.h"

#include <algorithm>

#include "simulation/world/Oracle.h"

namespace gt {
namespace {

/// Whether a robot comes to the ball.
bool comesTo(const BallState& ball, const PlayMoment::Robot& robot) {
  constexpr double comes = 50;  // mm/s, by which it comes nearer
  const Vector2d way = ball.position - robot.position;
  return robot.speed.dot(way) > comes * way.norm();
}

}  // namespace

BallUse BallLedger::useOf(const PlayMoment& moment) {
  const BallState& ball = moment.ball;
  bool isNear = false, kicks = false, sees = false, fieldPlayer = false, comes = false;
  PerTeam<bool> team{};
  for (const PlayMoment::Robot& robot : moment.robots) {
    if (!robot.plays) continue;
    if (robot.distanceTo(ball) >= atBall) {
      comes |= comesTo(ball, robot);
      continue;
    }
    isNear = true;
    kicks |= robot.kicks;
    sees |= robot.ballUnseen < ballLost;
    if (robot.role == DynamicRole::goalie) continue;
    fieldPlayer = true;
    team[indexOf(robot.team)] = true;
  }
  if (kicks) return BallUse::kicked;
  if (ball.speed.norm() > rollingBall) return isNear ? BallUse::pushed : BallUse::rolls;
  if (!isNear) return comes ? BallUse::comes : BallUse::left;
  if (!fieldPlayer) return BallUse::goalie;
  if (team[0] && team[1]) return BallUse::duel;
  return sees ? BallUse::linedUp : BallUse::searched;
}

void BallLedger::see(const PlayMoment& moment) {
  constexpr double near = 300, moves = 20;  // mm, mm/s
  constexpr double beside = 200;            // mm, from the field's border
  const BallState& ball = moment.ball;
  ++uses_[useOf(moment)];
  const bool isNear = std::ranges::any_of(moment.robots, [&](const PlayMoment::Robot& robot) {
    return robot.plays && robot.distanceTo(ball) < near;
  });
  idle_.count(!isNear && ball.speed.norm() < moves);
  atBorder_.count(std::abs(ball.position.x()) > field_.xGroundline - beside ||
                  std::abs(ball.position.y()) > field_.ySideline - beside);
  for (const TeamColor team : teamColors) {
    territory_[indexOf(team)].count(toTeam(team, ball.position).x() > 0);
    if (ball.lastToucher >= 0)
      possession_[indexOf(team)].count(
          moment.robots[static_cast<std::size_t>(ball.lastToucher)].team == team);
  }
}

void BallLedger::report(PlayFigures& figures) const {
  for (std::size_t i = 0; i < enumCount<BallUse>; ++i) {
    const auto use = static_cast<BallUse>(i);
    figures.share("ball." + std::string{enumName(use)}, {uses_[use], idle_.all});
  }
  figures.share("ball.idle", idle_);
  figures.share("ball.border", atBorder_);
  for (const TeamColor team : teamColors) {
    figures.share(teamFigure(team, "possession"), possession_[indexOf(team)]);
    figures.share(teamFigure(team, "territory"), territory_[indexOf(team)]);
  }
}

}  // namespace gt
