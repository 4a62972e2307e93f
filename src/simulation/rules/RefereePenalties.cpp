// What the referee does about fouls, the penalty shoot-out, and a game controller's orders.
#include <cmath>

#include "simulation/rules/Referee.h"
#include "simulation/world/Oracle.h"

namespace gt {
namespace {

/// Distance of penalized robots from the sideline, behind the side wall (mm).
constexpr double besideField = 350;
/// Distance from the sideline at which robots come back to the field (mm).
constexpr double returnInside = 200;

}  // namespace

void Referee::penalizeFouls(World& world) {
  for (const Foul& foul : fouls_.update(world, away_, kickedOff_ ? nullptr : &kickOff_))
    penalize(world, foul.robot, foul.penalty);
}

void Referee::penalize(World& world, std::size_t robot, Penalty penalty) {
  if (penalty == Penalty::none) return giveBack(world, robot);
  const Player& player = players_[robot];
  record(world, GameEventType::penalty, player.teamColor, player.number()).penalty = penalty;
  penalties_[robot] = penalty;
  backAt_[robot] = world.time() + toMs(penalty == Penalty::obstruction ? rules().obstructionRemoval
                                                                       : rules().removal);
  putAway(world, robot);
  notifyRobots(world.time());
}

void Referee::putAway(World& world, std::size_t robot) {
  // The robots of a team in a row beside its own half, one team on each side.
  const Player& player = players_[robot];
  const Pose2D beside{pi / 2, -250. - 400. * player.number(), -field_.ySideline - besideField};
  world.placeRobot(robot, toTeam(player.teamColor, beside));
  away_[robot] = true;
}

void Referee::giveBack(World& world, std::size_t robot) {
  const Player& player = players_[robot];
  penalties_[robot] = Penalty::none;
  backAt_[robot] = never();
  if (away_[robot]) {
    const Vector2d ball =
        world.ballCount() > 0 ? toTeam(player.teamColor, world.ball(0).position) : Vector2d{0, 0};
    const double side = ball.y() > 0 ? -1 : 1;
    // If all places there are taken, it waits beside the field, and the penalty goes on.
    Pose2D back{-side * pi / 2, -100, side * (field_.ySideline - returnInside)};
    const auto taken = [&] {
      return !free(world, toTeam(player.teamColor, back).translation, robot);
    };
    constexpr int places = 4;
    for (int i = 1; i < places && taken(); ++i) back.translation.x() -= 350;
    away_[robot] = taken();
    if (!away_[robot]) {
      world.placeRobot(robot, toTeam(player.teamColor, back));
      record(world, GameEventType::returnedRobot, player.teamColor, player.number());
    } else {
      penalties_[robot] = Penalty::requestForPickup;
      backAt_[robot] = world.time() + tickMs;
    }
  }
  notifyRobots(world.time());
}

void Referee::giveBackWhoseTimeIsOver(World& world) {
  for (std::size_t i = 0; i < world.activeRobots(); ++i)
    if (backAt_[i] != never() && world.time() >= backAt_[i]) giveBack(world, i);
}

void Referee::startShootOut(World& world) {
  clockRuns_ = false;
  shootOut_.emplace(rules().shots, parameters_.kickOff);
  beginShot(world);
}

void Referee::beginShot(World& world) {
  kickOff_ = shootOut_->team();
  shooter_ = keeper_ = nobody;
  for (std::size_t i = 0; i < world.activeRobots(); ++i) {
    const bool goalie = players_[i].role == PlayerRole::goalie;
    if (players_[i].teamColor != kickOff_ && goalie) keeper_ = i;
    // The last striker shoots; a goalie if there is nobody else.
    if (players_[i].teamColor == kickOff_ && (!goalie || shooter_ == nobody)) shooter_ = i;
  }
  for (std::size_t i = 0; i < world.activeRobots(); ++i) {
    penalties_[i] = Penalty::none;
    backAt_[i] = never();
    if (i != shooter_ && i != keeper_) putAway(world, i);
  }
  for (const std::size_t i : {shooter_, keeper_}) {
    if (i == nobody) continue;
    away_[i] = false;
    const Pose2D pose = i == shooter_ ? Pose2D{0, -230, 0} : Pose2D{0, -2000, 0};
    world.placeRobot(i, toTeam(players_[i].teamColor, pose));
  }
  if (world.ballCount() > 0) world.placeBall(0, {0, 0});
  changeState(GameState::set, world.time());
}

void Referee::updateShot(World& world) {
  if (state_ == GameState::set) {
    if (world.time() - stateSince_ < toMs(parameters_.setTime)) return;
    record(world, GameEventType::kickOff, kickOff_);
    return changeState(GameState::playing, world.time());
  }
  if (state_ != GameState::playing) return;
  if (timeLeft(world.time()) == 0 || world.ballCount() == 0) return endShot(world, false);
  const BallPlace place = ballPlace(world);
  if (place != BallPlace::onField)
    endShot(world, place == BallPlace::inGoal && toTeam(kickOff_, world.ball(0).position).x() > 0);
}

void Referee::endShot(World& world, bool goal) {
  const TeamColor team = shootOut_->team();
  shootOut_->count(goal);
  GameEvent& event = record(world, goal ? GameEventType::shotGoal : GameEventType::shotMissed, team,
                            shooter_ == nobody ? 0 : players_[shooter_].number());
  setShots(event);
  if (shootOut_->over()) return finish(world);
  beginShot(world);
}

void Referee::setShots(GameEvent& event) const {
  event.scoreRed = shootOut_->goals(TeamColor::red);
  event.scoreBlue = shootOut_->goals(TeamColor::blue);
}

void Referee::follow(const GameControllerMessage& message, World& world) {
  const Time now = world.time();
  led_ = true;
  ledTimeLeft_ = 1000 * message.secondsLeft;
  ledAt_ = now;
  half_ = message.firstHalf ? 1 : 2;
  if (message.kickOff) kickOff_ = *message.kickOff;
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    score_[team] = message.teams[team].score;
  for (std::size_t i = 0; i < world.activeRobots(); ++i) {
    const auto& penalties = message.teams[players_[i].teamColor].penalties;
    const Penalty penalty = penalties[static_cast<std::size_t>(players_[i].role)];
    if (penalty == penalties_[i]) continue;
    if (penalty == Penalty::none)
      giveBack(world, i);
    else
      penalize(world, i, penalty);
    backAt_[i] = never();
  }
  if (message.state == state_) return notifyRobots(now);
  // The hands of a person: the ball at its place, badly placed robots at theirs.
  if (message.state == GameState::ready && world.ballCount() > 0) world.placeBall(0, {0, 0});
  if (message.state == GameState::set) placeForKickOff(world);
  if (message.state == GameState::playing && state_ == GameState::set)
    record(world, GameEventType::kickOff, kickOff_);
  if (message.state == GameState::finished)
    record(world, half_ == 1 ? GameEventType::halfTime : GameEventType::gameOver, TeamColor::red);
  changeState(message.state, now);
}

}  // namespace gt
