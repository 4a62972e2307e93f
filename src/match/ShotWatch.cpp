#include "match/ShotWatch.h"

#include <algorithm>

#include "simulation/world/Oracle.h"

namespace gt {
namespace {

/// Time within which a ball that was stopped may still go in (ms).
constexpr int rebound = 1000;

}  // namespace

void ShotWatch::see(const PlayMoment& moment) {
  if (running_) follow(moment, *running_);
  if (running_) return;
  for (const TeamColor team : teamColors)
    if (rollsIntoGoal(moment.ball, team, field_, deceleration_)) return begin(moment, team);
}

void ShotWatch::begin(const PlayMoment& moment, TeamColor shooter) {
  constexpr double line = 20;  // mm: a ball that is as near to the goal is in it already
  if (toTeam(shooter, moment.ball.position).x() > field_.xGroundline - line) return;
  const PlayMoment::Robot* goalie = moment.goalie(opponent(shooter));
  ShotSummary shot;
  shot.time = moment.time;
  shot.team = shooter;
  shot.robot = moment.ball.lastToucher;
  shot.origin = moment.ball.position;
  shot.speed = moment.ball.speed.norm();
  running_ = Running{shot, goalie ? goalie->position : Vector2d{Vector2d::Zero()},
                     std::string{goalie ? goalie->action : ""}, moment.ball.lastTouched};
}

void ShotWatch::follow(const PlayMoment& moment, Running& running) {
  ShotSummary& shot = running.shot;
  if (running.ended != never()) {
    if (moment.time - running.ended > rebound) close();
    return;
  }
  const BallState& ball = moment.ball;
  if (const PlayMoment::Robot* goalie = moment.goalie(opponent(shot.team))) {
    shot.goalieMoved = std::max(shot.goalieMoved, (goalie->position - running.goalie).norm());
    if (shot.goalieAction.empty() && goalie->action != running.action)
      shot.goalieAction = goalie->action;
  }
  const bool isTouched = ball.lastToucher >= 0 && ball.lastTouched > running.lastTouch;
  if (isTouched && ball.lastToucher != shot.robot) {
    const auto& toucher = moment.robots[static_cast<std::size_t>(ball.lastToucher)];
    const bool isGoalie = toucher.role == DynamicRole::goalie && toucher.team != shot.team;
    shot.end = isGoalie ? ShotEnd::saved : ShotEnd::stopped;
    running.ended = moment.time;
  } else if (!rollsIntoGoal(ball, shot.team, field_, deceleration_)) {
    shot.end = ShotEnd::missed;
    running.ended = moment.time;
  }
}

void ShotWatch::close() {
  shots_.push_back(running_->shot);
  running_.reset();
}

void ShotWatch::goal(TeamColor team) {
  if (!running_) return;
  if (running_->shot.team == team) running_->shot.end = ShotEnd::goal;
  close();
}

void ShotWatch::interrupt() {
  if (running_) close();
}

void ShotWatch::report(PlayFigures& figures) const {
  for (const TeamColor team : teamColors) {
    EnumArray<ShotEnd, int> ends;
    PlayShare blocked;
    std::vector<double> moved;
    int shots = 0;
    for (const ShotSummary& shot : shots_) {
      if (shot.team != team) continue;
      ++shots;
      ++ends[shot.end];
      blocked.count(!shot.goalieAction.empty());
      moved.push_back(shot.goalieMoved);
    }
    figures.add(teamFigure(team, "shots"), "shots", shots);
    for (std::size_t i = 0; i < enumCount<ShotEnd>; ++i)
      figures.add(teamFigure(team, "shots." + std::string{enumName(static_cast<ShotEnd>(i))}),
                  "shots", ends[static_cast<ShotEnd>(i)]);
    // What the opponents' goalie does.
    const TeamColor other = opponent(team);
    figures.share(teamFigure(other, "goalie.acts"), blocked);
    figures.spread(teamFigure(other, "goalie.moved"), "mm", moved);
  }
}

}  // namespace gt
