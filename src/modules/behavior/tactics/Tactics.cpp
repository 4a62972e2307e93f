#include "modules/behavior/tactics/Tactics.h"

#include <algorithm>

namespace gt {

void Tactics::update(const WorldState& world) {
  world_ = &world;
  obstacles_ = world.obstacles;
  addTeammatesToObstacles();
  role_ = negotiateRole();
  ownGoal_.update(world.game.ownScore, world.frame.time);
  opponentGoal_.update(world.game.opponentScore, world.frame.time);
  const bool plays = role_ == DynamicRole::striker || role_ == DynamicRole::goalie;
  kick_.update(world, obstacles_, knownBall(), world.frame.time - world.ball.lastSeen, plays);
}

void Tactics::addTeammatesToObstacles() {
  const double halfWidth = p_.teammateWidth / 2;
  for (const LocatedPlayer& mate : world_->players.ownTeam) {
    if (mate.number == 0) continue;
    const Vector2d middle = relative(world_->self.pose, mate.position);
    const double distance = std::max(middle.norm(), 1.0);
    const Vector2d away = middle / distance, aside = rotated(away, pi / 2);
    const Vector2d front = middle - away * std::min(halfWidth, distance / 2);
    for (const double part : {-1., -0.5, 0., 0.5, 1.})
      obstacles_.enter(front + part * halfWidth * aside, true, mate.lastSeen);
  }
}

bool Tactics::ownBall() const {
  const WorldState& w = *world_;
  return w.ball.lastSeen >= w.teamBall.lastSeen ||
         static_cast<double>(w.frame.time - w.ball.lastSeen) < p_.ownBall;
}

Vector2d Tactics::knownBall() const {
  const WorldState& w = *world_;
  return ownBall() ? w.ball.position : relative(w.self.pose, w.teamBall.position);
}

Vector2d Tactics::knownBallOnField() const {
  const WorldState& w = *world_;
  return ownBall() ? w.self.pose * w.ball.position : w.teamBall.position;
}

std::int64_t Tactics::knownBallAge() const {
  const WorldState& w = *world_;
  return std::min(w.frame.time - w.ball.lastSeen, w.frame.time - w.teamBall.lastSeen);
}

double Tactics::estimatedTimeToReachBall() const {
  const Vector2d ball = knownBall();
  const Vector2d toGoal = goalToScoreIn() - knownBallOnField();
  const double wrongSide =
      std::abs(normalize(angleOf(toGoal) - world_->self.pose.rotation - angleOf(ball)));
  return ball.norm() / p_.walkSpeed + std::abs(angleOf(ball)) / p_.turnSpeed +
         wrongSide * p_.wrongSide / p_.walkSpeed +
         p_.unseenBall * std::min(static_cast<double>(world_->frame.time - world_->ball.lastSeen),
                                  p_.longestUnseen) +
         (world_->body.state == BodyState::fallen ? p_.gettingUp : 0);
}

/// A striker hands its role over as soon as it hears of one that is nearer; another robot takes it
/// when it has been nearer than all others for a while. So the role neither flickers nor gets lost.
DynamicRole Tactics::negotiateRole() {
  const WorldState& w = *world_;
  if (w.player.role == PlayerRole::goalie) return DynamicRole::goalie;
  const double own = estimatedTimeToReachBall();
  const double ahead = role_ == DynamicRole::offensiveSupporter ? p_.forwardAdvantage : 0;
  bool nearest = w.game.penalty == Penalty::none, handsOver = !nearest, mostForward = true;
  for (const TeamMessages::Received& received : w.team.byPlayer) {
    const TeamMessage& mate = received.message;
    const bool heard = static_cast<double>(w.frame.time - received.timeReceived) < p_.heard;
    if (!heard || mate.playerNumber <= 1 || mate.playerNumber == w.player.number()) continue;
    const bool isStriker = mate.behavior.role == DynamicRole::striker;
    const double time = mate.behavior.estimatedTimeToReachBall;
    const bool sooner = time < own || (time == own && mate.playerNumber < w.player.number());
    if (isStriker && sooner) handsOver = true;
    if (isStriker ? time < own + p_.strikerAdvantage : sooner) nearest = false;
    if (!isStriker && mate.robotPose.translation.x() > w.self.pose.translation.x() + ahead)
      mostForward = false;
  }
  const DynamicRole supporter =
      mostForward ? DynamicRole::offensiveSupporter : DynamicRole::defensiveSupporter;
  if (role_ == DynamicRole::striker) {
    wantedSince_ = w.frame.time;
    return handsOver ? supporter : role_;
  }
  const DynamicRole wanted = nearest ? DynamicRole::striker : supporter;
  if (wantedSince_ == never()) role_ = wanted;  // the first cycle
  if (wanted != wanted_ || wantedSince_ == never()) wantedSince_ = w.frame.time;
  wanted_ = wanted;
  return static_cast<double>(w.frame.time - wantedSince_) >= p_.roleDelay ? wanted : role_;
}

}  // namespace gt
