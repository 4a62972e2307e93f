#include "simulation/rules/Referee.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simulation/world/Oracle.h"

namespace gt {
namespace {

/// A ball of at least this speed that rolls towards the goal is a shot; a robot that deflects it
/// within `shotMs` before it goes in did not score.
constexpr double shotSpeed = 200;  // mm/s
constexpr std::int64_t shotMs = 2000;
constexpr std::int64_t initialMs = 1000;
constexpr std::int64_t readyAtLeastMs = 4000;  // until robots that have to walk do walk
constexpr std::int64_t standingMs = 1000;
constexpr double standingMm = 15;
constexpr double standingDegrees = 5, standingLegDegrees = 10;  // who cheers moves its legs
constexpr double stuckMm = 50;
/// Greatest distance of a robot's parts from its middle (mm).
constexpr double robotRadius = 150;

}  // namespace

Referee::Referee(const GameParameters& parameters, const RuleParameters& rules,
                 const FieldDimensions& field, const std::vector<Player>& players)
    : parameters_(parameters),
      field_(field),
      players_(players),
      fouls_(rules, field, players),
      data_(players.size()),
      penalties_(players.size(), Penalty::none),
      away_(players.size()),
      backAt_(players.size(), never()),
      kickOff_(parameters.kickOff),
      lastSeen_(players.size()) {
  if (!parameters_.referee) state_ = GameState::playing;
  notifyRobots(Time{});
}

std::int64_t Referee::timeLeft(Time now) const {
  const std::int64_t half = toMs(parameters_.minutes * 60) / 2;
  const bool playing = state_ == GameState::playing;
  std::int64_t left = half;
  if (led_)
    left = ledTimeLeft_ - (playing ? now - ledAt_ : 0);
  else if (shootOut_)
    left = toMs(rules().shotTime) - (playing ? now - stateSince_ : 0);
  else if (clockRuns_)
    left = half - (now - halfStarted_);
  return std::max<std::int64_t>(left, 0);
}

void Referee::changeState(GameState state, Time now) {
  state_ = state;
  stateSince_ = now;
  movedAt_ = now;
  ballMovedAt_ = now;
  fouls_.reset();
  if (state == GameState::set) kickedOff_ = false;
  notifyRobots(now);
}

void Referee::order(GameState state, World& world) {
  state == GameState::ready ? beginReady(world) : changeState(state, world.time());
}

void Referee::setScore(TeamColor team, int goals, Time now) {
  score_[team] = goals;
  notifyRobots(now);
}

void Referee::setPenalty(std::size_t robot, Penalty penalty, Time now) {
  penalties_[robot] = penalty;
  backAt_[robot] = never();
  notifyRobots(now);
}

void Referee::update(World& world) {
  const Time now = world.time();
  if (led_) return;
  giveBackWhoseTimeIsOver(world);
  if (!parameters_.referee || state_ == GameState::finished) return;
  if (shootOut_) return updateShot(world);
  if (clockRuns_ && timeLeft(now) == 0) return endHalf(world);
  switch (state_) {
    case GameState::initial:
      if (now - stateSince_ < initialMs) break;
      if (parameters_.shootOut == ShootOutMode::only) return startShootOut(world);
      if (world.ballCount() > 0) world.placeBall(0, {0, 0});
      beginReady(world);
      break;
    case GameState::ready:
      updateReady(world);
      break;
    case GameState::set:
      if (now - stateSince_ < toMs(parameters_.setTime)) break;
      if (world.ballCount() > 0) world.placeBall(0, {0, 0});
      if (!clockRuns_) halfStarted_ = now;
      clockRuns_ = true;
      record(world, GameEventType::kickOff, kickOff_);
      changeState(GameState::playing, now);
      break;
    case GameState::playing:
      updatePlaying(world);
      break;
    default:
      break;
  }
}

void Referee::beginReady(World& world) {
  for (std::size_t i = 0; i < world.activeRobots(); ++i)
    if (away_[i] || penalties_[i] != Penalty::none) giveBack(world, i);
  changeState(GameState::ready, world.time());
}

bool Referee::standing(const World& world) {
  bool moved = false;
  for (std::size_t i = 0; i < world.activeRobots(); ++i) {
    const RobotBody &now = world.robot(i), &last = lastSeen_[i];
    bool still =
        (now.pose.translation - last.pose.translation).norm() < standingMm &&
        std::abs(normalize(now.pose.rotation - last.pose.rotation)) < fromDegrees(standingDegrees);
    for (std::size_t leg = 0; leg < enumCount<Leg>; ++leg)
      for (int number = 1; number <= 3; ++number) {
        const Joint joint = legJoint(static_cast<Leg>(leg), number);
        still &= std::abs(now.joints[joint] - last.joints[joint]) < fromDegrees(standingLegDegrees);
      }
    if (still) continue;
    lastSeen_[i] = now;
    moved = true;
  }
  if (moved) movedAt_ = world.time();
  return world.time() - movedAt_ >= standingMs;
}

void Referee::updateReady(World& world) {
  const std::int64_t waited = world.time() - stateSince_;
  const bool all =
      standing(world) && waited >= std::min(readyAtLeastMs, toMs(parameters_.readyTime));
  if (!all && waited < toMs(parameters_.readyTime)) return;
  placeForKickOff(world);
  changeState(GameState::set, world.time());
}

bool Referee::wellPlaced(World& world, std::size_t robot, bool inCircle) const {
  const Player& player = players_[robot];
  const Vector2d p = toTeam(player.teamColor, world.robot(robot).pose.translation);
  if (world.robot(robot).posture != Posture::standing) return false;
  const bool onField = std::abs(p.y()) < field_.ySideline && p.x() > -field_.xGroundline - 100;
  if (!onField || p.x() > -robotRadius / 2) return false;
  const bool inArea = p.x() < -field_.xPenaltyArea && std::abs(p.y()) < field_.yPenaltyArea;
  if ((player.role == PlayerRole::goalie) != inArea) return false;
  if (inCircle) return world.ballCount() == 0 || !world.wouldTouch(0, {0, 0}, robot);
  return p.norm() >= field_.centerCircleRadius + robotRadius;
}

Pose2D Referee::kickOffPose(std::size_t robot) const {
  const bool own = players_[robot].teamColor == kickOff_;
  switch (players_[robot].role) {
    case PlayerRole::goalie:
      return {0, -2000, 0};
    case PlayerRole::defender:
      return own ? Pose2D{0, -1100, -400} : Pose2D{0, -1250, -300};
    case PlayerRole::striker1:
      return own ? Pose2D{0, -500, 600} : Pose2D{0, -800, 500};
    default:
      return own ? Pose2D{0, -230, 0} : Pose2D{0, -650, 0};
  }
}

bool Referee::free(const World& world, const Vector2d& position, std::size_t except) const {
  for (std::size_t i = 0; i < world.robotCount(); ++i)
    if (i != except && (world.robot(i).pose.translation - position).norm() < 2 * robotRadius)
      return false;
  return true;
}

void Referee::placeRobot(World& world, std::size_t robot, const Pose2D& wanted) {
  const TeamColor team = players_[robot].teamColor;
  for (const double aside : {0., 350., -350., 700., -700.}) {
    const Pose2D pose =
        toTeam(team, Pose2D{wanted.rotation, wanted.translation + Vector2d{0, aside}});
    if (free(world, pose.translation, robot)) return world.placeRobot(robot, pose);
  }
  world.placeRobot(robot, toTeam(team, wanted));
}

void Referee::placeForKickOff(World& world) {
  // Of the team that kicks off the robot nearest to the ball may stand inside the circle.
  std::size_t kicker = world.activeRobots();
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < world.activeRobots(); ++i) {
    const double distance = world.robot(i).pose.translation.norm();
    if (away_[i] || players_[i].teamColor != kickOff_ || players_[i].role == PlayerRole::goalie ||
        distance >= nearest)
      continue;
    nearest = distance;
    kicker = i;
  }
  for (std::size_t i = 0; i < world.activeRobots(); ++i)
    if (!away_[i] && !wellPlaced(world, i, i == kicker)) {
      placeRobot(world, i, kickOffPose(i));
      record(world, GameEventType::placedRobot, players_[i].teamColor, players_[i].number());
    }
  if (world.ballCount() > 0) world.placeBall(0, {0, 0});
}

Referee::BallPlace Referee::ballPlace(const World& world) const {
  const Vector2d ball = world.ball(0).position.cwiseAbs();
  const double behindLine = ball.x() - field_.xGroundline;
  if (ball.y() < field_.yGoal)
    return behindLine > field_.ballRadius ? BallPlace::inGoal : BallPlace::onField;
  return behindLine > 0 || ball.y() > field_.ySideline ? BallPlace::out : BallPlace::onField;
}

void Referee::updatePlaying(World& world) {
  if (parameters_.penalties) penalizeFouls(world);
  if (world.ballCount() == 0) return;
  const BallPlace place = ballPlace(world);
  if (place == BallPlace::inGoal) return countGoal(world);
  if (place == BallPlace::out) {
    record(world, GameEventType::ballOut, TeamColor::red);
    world.placeBall(0, {0, 0});
  }
  kickedOff_ |= world.ball(0).position.norm() > stuckMm;
  watchShots(world);
  watchStuckBall(world);
}

void Referee::watchShots(const World& world) {
  const BallState& ball = world.ball(0);
  if (ball.lastToucher < 0 || ball.speed.norm() < shotSpeed) return;
  const TeamColor team = players_[static_cast<std::size_t>(ball.lastToucher)].teamColor;
  const double line = team == TeamColor::red ? field_.xGroundline : -field_.xGroundline;
  const double seconds = (line - ball.position.x()) / ball.speed.x();
  if (seconds > 0 && std::abs(ball.position.y() + seconds * ball.speed.y()) < field_.yGoal)
    shot_ = {ball.lastToucher, world.time()};
}

void Referee::countGoal(World& world) {
  const TeamColor scorer = world.ball(0).position.x() > 0 ? TeamColor::red : TeamColor::blue;
  const bool shot = shot_.robot >= 0 && world.time() - shot_.time < shotMs &&
                    players_[static_cast<std::size_t>(shot_.robot)].teamColor == scorer;
  const int toucher = shot ? shot_.robot : world.ball(0).lastToucher;
  shot_ = {};
  const bool touched = toucher >= 0;
  const std::size_t player = static_cast<std::size_t>(std::max(toucher, 0));
  ++score_[scorer];
  record(world, GameEventType::goal, scorer, touched ? players_[player].number() : 0).ownGoal =
      touched && players_[player].teamColor != scorer;
  kickOff_ = opponent(scorer);
  world.placeBall(0, {0, 0});
  beginReady(world);
}

void Referee::watchStuckBall(World& world) {
  const Vector2d ball = world.ball(0).position;
  if ((ball - ballReference_).norm() > stuckMm) {
    ballReference_ = ball;
    ballMovedAt_ = world.time();
  }
  if (world.time() - ballMovedAt_ < toMs(parameters_.stuckTime)) return;
  const double x = field_.xGroundline / 2, y = field_.ySideline / 2;
  const std::array<Vector2d, 5> spots{Vector2d{0, 0}, Vector2d{x, y}, Vector2d{x, -y},
                                      Vector2d{-x, y}, Vector2d{-x, -y}};
  Vector2d best = spots[0];
  double nearest = std::numeric_limits<double>::max();
  for (const Vector2d& spot : spots) {
    const double distance = (spot - ball).norm();
    if (distance < 2 * robotRadius || distance >= nearest || !free(world, spot, world.robotCount()))
      continue;
    nearest = distance;
    best = spot;
  }
  record(world, GameEventType::stuckBall, TeamColor::red);
  world.placeBall(0, best);
  ballReference_ = world.ball(0).position;
  ballMovedAt_ = world.time();
}

void Referee::endHalf(World& world) {
  if (half_ == 2) {
    const bool draw = score_[TeamColor::red] == score_[TeamColor::blue];
    if (draw && parameters_.shootOut == ShootOutMode::afterDraw) return startShootOut(world);
    return finish(world);
  }
  record(world, GameEventType::halfTime, TeamColor::red);
  half_ = 2;
  clockRuns_ = false;
  kickOff_ = opponent(parameters_.kickOff);
  changeState(GameState::initial, world.time());
}

void Referee::finish(World& world) {
  GameEvent& event = record(world, GameEventType::gameOver, TeamColor::red);
  if (shootOut_) setShots(event);
  changeState(GameState::finished, world.time());
}

GameEvent& Referee::record(const World& world, GameEventType type, TeamColor team, int number) {
  GameEvent event;
  event.type = type;
  event.time = world.time();
  event.team = team;
  event.number = number;
  if (world.ballCount() > 0) event.ballPosition = world.ball(0).position;
  event.scoreRed = score_[TeamColor::red];
  event.scoreBlue = score_[TeamColor::blue];
  events_.push_back(event);
  return events_.back();
}

void Referee::notifyRobots(Time now) {
  for (std::size_t i = 0; i < players_.size(); ++i) {
    const TeamColor team = players_[i].teamColor;
    GameControlData& data = data_[i];
    const bool watches = shootOut_ && i != shooter_ && i != keeper_;
    const GameState state = penalties_[i] != Penalty::none ? GameState::penalized
                            : watches                      ? GameState::finished
                                                           : state_;
    if (data.state != state) data.timeOfLastChange = now;
    data.state = state;
    data.kickOff = team == kickOff_ ? KickOff::own : KickOff::opponent;
    data.penalty = penalties_[i];
    data.ownScore = score_[team];
    data.opponentScore = score_[opponent(team)];
  }
}

}  // namespace gt
