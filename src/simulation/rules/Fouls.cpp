#include "simulation/rules/Fouls.h"

#include <algorithm>
#include <cmath>

#include "simulation/world/Oracle.h"

namespace gt {
namespace {

/// A ball that a robot holds lies before its chest and moves with it (mm).
constexpr double holdingLength = 240, holdingWidth = 120, holdingPlay = 40;
constexpr std::int64_t touchedMs = 400;  // how long ago it was felt at most
/// A robot that is further away from the ball than this does not play it (mm).
constexpr double playingDistance = 500;

}  // namespace

FoulWatch::FoulWatch(const RuleParameters& rules, const FieldDimensions& field,
                     const std::vector<Player>& players)
    : rules_(rules),
      field_(field),
      players_(players),
      records_(players.size()),
      offends_(players.size()) {
  fouls_.reserve(players.size());
}

void FoulWatch::reset() {
  std::fill(records_.begin(), records_.end(), Record{});
}

const std::vector<Foul>& FoulWatch::update(const World& world, const std::vector<bool>& away,
                                           const TeamColor* kickOff) {
  fouls_.clear();
  for (auto& offends : offends_) offends.values.fill(false);
  for (std::size_t i = 0; i < world.activeRobots(); ++i)
    if (!away[i]) look(world, i, kickOff, offends_[i]);
  for (std::size_t i = 0; i < world.activeRobots(); ++i) {
    Record& record = records_[i];
    if (away[i]) record = {};
    for (std::size_t p = 0; p < enumCount<Penalty>; ++p) {
      const auto penalty = static_cast<Penalty>(p);
      double& seconds = record.seconds[penalty];
      seconds = std::max(0., seconds + (offends_[i][penalty] ? tickSeconds : -2 * tickSeconds));
      const double most = limit(i, penalty, world);
      if (most <= 0 || seconds < most) continue;
      fouls_.push_back({i, penalty});
      record = {};
      break;
    }
  }
  return fouls_;
}

double FoulWatch::limit(std::size_t robot, Penalty penalty, const World& world) const {
  switch (penalty) {
    case Penalty::ballHolding:
      return players_[robot].role == PlayerRole::goalie && inOwnArea(world, robot)
                 ? rules_.keeperBallHolding
                 : rules_.ballHolding;
    case Penalty::keeperCharge:
      return rules_.keeperCharge;
    case Penalty::fieldPlayerCharge:
      return rules_.fieldPlayerCharge;
    case Penalty::illegalDefender:
      return rules_.illegalDefender;
    case Penalty::illegalDefense:
      return rules_.illegalDefense;
    case Penalty::obstruction:
      return rules_.obstruction;
    case Penalty::requestForPickup:
      return rules_.requestForPickup;
    case Penalty::none:
      break;
  }
  return 0;
}

void FoulWatch::look(const World& world, std::size_t robot, const TeamColor* kickOff,
                     EnumArray<Penalty, bool>& offends) {
  const RobotBody& body = world.robot(robot);
  const Player& player = players_[robot];
  offends[Penalty::requestForPickup] = body.posture != Posture::standing;
  if (holdsBall(world, robot)) offends[Penalty::ballHolding] = true;
  if (player.role != PlayerRole::goalie && inOwnArea(world, robot))
    offends[Penalty::illegalDefender] = true;
  if (kickOff && player.teamColor != *kickOff &&
      body.pose.translation.norm() < field_.centerCircleRadius)
    offends[Penalty::illegalDefense] = true;
  if (body.pushes < 0) return;
  const auto other = static_cast<std::size_t>(body.pushes);
  if (players_[other].teamColor == player.teamColor) return;
  if (players_[other].role == PlayerRole::goalie && inOwnArea(world, other))
    offends[Penalty::keeperCharge] = true;
  else if (obstructs(world, robot, other))
    offends_[other][Penalty::obstruction] = true;
  else
    offends[Penalty::fieldPlayerCharge] = true;
}

bool FoulWatch::holdsBall(const World& world, std::size_t robot) {
  Record& record = records_[robot];
  for (std::size_t i = 0; i < world.ballCount(); ++i) {
    const BallState& ball = world.ball(i);
    const Vector2d seen = relative(world.robot(robot).pose, ball.position);
    if (ball.lastToucher != static_cast<int>(robot) ||
        world.time() - ball.lastTouched > touchedMs || seen.x() < 0 || seen.x() > holdingLength ||
        std::abs(seen.y()) > holdingWidth)
      continue;
    double& seconds = record.seconds[Penalty::ballHolding];
    if (seconds == 0 || (seen - record.heldAt).norm() > holdingPlay) {
      record.heldAt = seen;
      seconds = 0;
    }
    return true;
  }
  return false;
}

bool FoulWatch::inOwnArea(const World& world, std::size_t robot) const {
  const Vector2d p = toTeam(players_[robot].teamColor, world.robot(robot).pose.translation);
  return p.x() < -field_.xPenaltyArea && std::abs(p.y()) < field_.yPenaltyArea;
}

bool FoulWatch::obstructs(const World& world, std::size_t robot, std::size_t pushed) const {
  if (world.ballCount() == 0 || world.robot(pushed).pushes >= 0) return false;
  const Vector2d& ball = world.ball(0).position;
  const Vector2d way = ball - world.robot(robot).pose.translation;
  const Vector2d between =
      world.robot(pushed).pose.translation - world.robot(robot).pose.translation;
  return way.dot(between) > 0 && between.norm() < way.norm() &&
         (ball - world.robot(pushed).pose.translation).norm() > playingDistance;
}

}  // namespace gt
