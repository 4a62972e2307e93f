#include "modules/behavior/tactics/Tactics.h"

#include <algorithm>

#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {

void Tactics::update(const WorldState& world) {
  world_ = &world;
  obstacles_ = world.obstacles;
  forgetOldObstacles();
  addTeammatesToObstacles();
  buttons_.update(world);
  negotiateRole();
  ownGoal_.update(world.game.ownScore, world.frame.time);
  opponentGoal_.update(world.game.opponentScore, world.frame.time);
  const bool plays = role() == DynamicRole::striker || role() == DynamicRole::goalie;
  kick_.update(world, obstacles_, knownBall(), world.frame.time - world.ball.lastSeen, plays);
}

void Tactics::forgetOldObstacles() {
  for (ObstaclesModel::Sector& sector : obstacles_.sectors)
    if (static_cast<double>(world_->frame.time - sector.lastSeen) > p_.obstacleMemory) sector = {};
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

int Tactics::connections() const {
  const auto isConnected = [this](const TeamMessages::Received& received) {
    const int number = received.message.playerNumber;
    return number != 0 && number != world_->player.number() &&
           static_cast<double>(world_->frame.time - received.timeReceived) < p_.connected;
  };
  return static_cast<int>(std::ranges::count_if(world_->team.byPlayer, isConnected));
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

Crossing Tactics::crossing() const {
  constexpr double longFromNow = 1e6;  // ms
  return crossingOf(world_->ball, p_.deceleration).value_or(Crossing{0, longFromNow});
}

double Tactics::estimatedTimeToReachBall() const {
  const WorldState& w = *world_;
  const Vector2d ball = knownBall();
  const Vector2d toGoal = goalToScoreIn() - knownBallOnField();
  const double wrongSide =
      std::abs(normalize(angleOf(toGoal) - w.self.pose.rotation - angleOf(ball)));
  const double free = corridor(obstacles_, angleOf(ball), p_.teammateWidth);
  return ball.norm() / p_.walkSpeed + std::abs(angleOf(ball)) / p_.turnSpeed +
         wrongSide * p_.wrongSide / p_.walkSpeed +
         p_.unseenBall *
             std::min(static_cast<double>(w.frame.time - w.ball.lastSeen), p_.longestUnseen) +
         (free < ball.norm() - p_.besideBall ? p_.blockedWay : 0);
}

/// A robot that is penalized, lies or is lifted up does not play.
bool Tactics::plays() const {
  const WorldState& w = *world_;
  return w.game.penalty == Penalty::none && w.body.state == BodyState::standing &&
         w.motion.executed.type != MotionType::getup;
}

void Tactics::negotiateRole() {
  const WorldState& w = *world_;
  const double time = plays() ? estimatedTimeToReachBall() : RoleNegotiation::notAvailable;
  if (w.player.role == PlayerRole::goalie) {
    message_ = {DynamicRole::goalie, time};
  } else {
    roles_.update({w.player.number(), time, w.self.pose.translation.x()}, w.team, w.frame.time);
    message_ = roles_.message();
  }
  message_.kickTarget = kick_.aim();
}

}  // namespace gt
