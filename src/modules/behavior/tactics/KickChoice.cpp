#include "modules/behavior/tactics/KickChoice.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <tuple>

#include "base/WideInstructions.h"
#include "modules/behavior/tactics/FreeSpace.h"

namespace gt {
namespace {

/// A normal distribution by five of its values.
constexpr std::array<std::pair<double, double>, 5> outcomes{
    {{-1.6, 0.1}, {-0.8, 0.25}, {0, 0.3}, {0.8, 0.25}, {1.6, 0.1}}};

double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// The angle of a vector, to a hundred thousandth if it points ahead rather than aside (Abramowitz
/// and Stegun 1964, 4.4.47).
double aboutAngleOf(double x, double y) {
  if (!(std::abs(y) <= x)) return std::atan2(y, x);
  const double slope = y / x, square = slope * slope;
  return slope *
         (0.9998660 + square * (-0.3302995 +
                                square * (0.1801410 + square * (-0.0851330 + square * 0.0208351))));
}

double nearest(const std::vector<Vector2d>& players, const Vector2d& place, double otherwise) {
  double square = otherwise * otherwise;
  for (const Vector2d& player : players) square = std::min(square, (player - place).squaredNorm());
  return std::sqrt(square);
}

}  // namespace

KickChoice::KickChoice(const Parameters& parameters) : p_{parameters} {
  for (int i = 0; i < directions; ++i) {
    Facing& facing = facings_[static_cast<std::size_t>(i)];
    facing.angle = normalize(i * step);
    facing.along = direction(i * step);
  }
}

void KickChoice::update(const WorldState& world, const ObstaclesModel& obstacles,
                        const Vector2d& ball, std::int64_t unseen, bool plays) {
  world_ = &world;
  ball_ = ball;
  ballOnField_ = world.self.pose * ball;
  const MotionRequest& executed = world.motion.executed;
  if (executed.type == MotionType::specialAction) {
    const int running = world.motions.find(executed.specialAction);
    const bool kicks =
        running > 0 && world.motions.motions[static_cast<std::size_t>(running)].isKick();
    now_ = kicks ? running : 0;
    if (kicks) lastKick_ = world.frame.time;
    decided_ = planned_ = never();
  } else if (plays) {
    if (needsPlan()) {
      look(obstacles);
      choosePlan();
      planned_ = world.frame.time;
      plannedBall_ = ballOnField_;
    }
    if (now_ == 0) aim_ = aimOf(plan_);
    decide(unseen);
  } else {
    now_ = 0;
    aim_ = ballOnField_;
    planned_ = never();
  }
}

/// Returns whether a new plan is needed. Far from the ball another plan changes the robot's path
/// only little.
bool KickChoice::needsPlan() const {
  const double distance = ball_.norm();
  const double lasts = 1000 * p_.lasts * (distance - p_.nearBall) / p_.walkSpeed;  // ms
  return distance < p_.nearBall || planned_ == never() ||
         (ballOnField_ - plannedBall_).norm() > p_.lasts * distance ||
         static_cast<double>(world_->frame.time - planned_) >= lasts;
}

void KickChoice::decide(std::int64_t unseen) {
  const Time time = world_->frame.time;
  const bool atBall = ball_.norm() < p_.nearBall;
  if (!atBall)
    atBallSince_ = never();
  else if (atBallSince_ == never())
    atBallSince_ = time;
  constexpr std::int64_t seen = 250;  // ms
  const bool seesBall = unseen <= seen;
  // A kick begins when the robot stands: until then it is chosen anew, for only then the ball lies
  // where it will be hit.
  const bool stopping = decided_ != never() && static_cast<double>(time - decided_) < p_.begins;
  if (stopping && !seesBall) return;
  const int begun = stopping ? now_ : 0;
  now_ = 0;
  if (!stopping) decided_ = never();
  if (!atBall || !seesBall) return;
  const double waited = static_cast<double>(time - atBallSince_) / 1000;
  const Plan possible = worthNow(begun);
  const double enough =
      plan_.worth - haste().enough - haste().impatience * waited - (stopping ? p_.otherPlan : 0);
  if (possible.motion == 0 || possible.worth < enough) return;
  now_ = possible.motion;
  target_ = ballOnField_ + direction(possible.direction) * p_.follows;
  aim_ = aimOf(possible);
  if (!stopping) decided_ = time;
}

Vector2d KickChoice::aimOf(const Plan& plan) const {
  if (plan.motion == 0) return ballOnField_;
  const auto motion = static_cast<std::size_t>(plan.motion);
  return ballOnField_ + direction(plan.direction) * world_->motions.motions[motion].kick.length;
}

void KickChoice::look(const ObstaclesModel& obstacles) {
  const WorldState& world = *world_;
  own_ = {world.self.pose.translation};
  for (const LocatedPlayer& player : world.players.ownTeam) own_.push_back(player.position);
  opponents_.clear();
  for (const LocatedPlayer& player : world.players.opponents) opponents_.push_back(player.position);
  opponentArrives_ = opponentArrival(obstacles);
  const double widest = std::min(p_.widestGoal, pi);
  widest_ = {std::sin(widest), std::cos(widest)};
  stays_ = worthOf(ballOnField_) - p_.blocked;
  const Vector2d begin = clampedToField(ballOnField_);
  const End start{begin, worthOf(begin)};
  const bool obstaclesCount = ball_.norm() < p_.handled;
  const double rotation = world.self.pose.rotation;
  const double sine = std::sin(rotation), cosine = std::cos(rotation);
  for (int i = 0; i < directions; ++i) {
    Facing& facing = facings_[static_cast<std::size_t>(i)];
    const Vector2d& along = facing.along;
    facing.turn = normalize(i * step - rotation);
    facing.turned = {cosine * along.x() + sine * along.y(), cosine * along.y() - sine * along.x()};
    facing.hasRoom = hasRoom(facing);
    judgePaths(i, start,
               obstaclesCount ? corridor(obstacles, facing.turn, p_.ballCorridor, ball_)
                              : ObstaclesModel::farAway);
  }
}

/// The angle of a goal as seen from a point, limited to `widestGoal`.
KickChoice::GoalAngle KickChoice::angleOfGoal(double x, const Vector2d& end) const {
  const double yGoal = world_->field.yGoal;
  const Vector2d left = Vector2d{x, yGoal} - end, right = Vector2d{x, -yGoal} - end;
  const GoalAngle angle{std::abs(cross(left, right)), left.dot(right)};
  const bool isWider = angle.sine * widest_.cosine > angle.cosine * widest_.sine;
  return isWider ? widest_ : angle;
}

double KickChoice::worthOf(const Vector2d& end) const {
  const FieldDimensions& field = world_->field;
  const double contest =
      nearest(opponents_, end, p_.opponentFar) - nearest(own_, end, 2 * p_.opponentFar);
  if (!world_->values.empty())
    return world_->values.worth(end, contest, {field.xGroundline, field.ySideline});
  const GoalAngle theirs = angleOfGoal(field.xGroundline, end),
                  ours = angleOfGoal(-field.xGroundline, end);
  const double wider = aboutAngleOf(theirs.cosine * ours.cosine + theirs.sine * ours.sine,
                                    theirs.sine * ours.cosine - theirs.cosine * ours.sine);
  const double ahead = end.x() / field.xGroundline;
  return p_.ahead * ahead + p_.shot * wider + p_.possession * std::clamp(contest / 1000, -1., 1.);
}

Vector2d KickChoice::clampedToField(const Vector2d& place) const {
  const FieldDimensions& field = world_->field;
  return {std::clamp(place.x(), -field.xGroundline, field.xGroundline),
          std::clamp(place.y(), -field.ySideline, field.ySideline)};
}

/// Computes the worth of the ball's paths in a direction, by increasing length: into a goal,
/// against a wall, to another player, or to its end. Many paths end at the same point.
void KickChoice::judgePaths(int direction, const End& start, double free) {
  const FieldDimensions& field = world_->field;
  const Vector2d& along = facings_[static_cast<std::size_t>(direction)].along;
  const double toLine =
      std::abs(along.x()) < 1e-6
          ? 1e9
          : (std::copysign(field.xGroundline, along.x()) - ballOnField_.x()) / along.x();
  constexpr double atLine = 150;  // mm: obstacles there are posts, walls and the goal
  const bool isBlocked = free < ObstaclesModel::farAway && free < toLine - atLine;
  const double clearance = std::copysign(p_.postClearance, along.x());
  const bool hitsGoal = std::abs(ballOnField_.y() + along.y() * toLine) < field.yGoal - clearance;
  End last = start;
  for (int i = 0; i < lengths; ++i) {
    const double length = i * lengthStep;
    double worth = 0;
    const bool stopped = isBlocked && free < length;
    if (!stopped && length > toLine && hitsGoal) {
      worth = along.x() > 0 ? 1 : ownGoal;
    } else {
      const Vector2d end =
          clampedToField(ballOnField_ + along * std::min(length, stopped ? free : length));
      if (end != last.place) last = {end, worthOf(end)};
      worth = last.worth - (stopped ? p_.blocked : 0);
    }
    Paths& paths = paths_[static_cast<std::size_t>(i)];
    paths[static_cast<std::size_t>(direction)] = worth;
    paths[static_cast<std::size_t>(direction + directions)] = worth;
  }
}

KickChoice::About KickChoice::about(const KickDescription& kick, const Vector2d& place) const {
  const std::array<Vector2d, 5> offs{
      {{0, 0}, {p_.misplaced, 0}, {-p_.misplaced, 0}, {0, p_.misplaced}, {0, -p_.misplaced}}};
  About about;
  about.spread = std::hypot(p_.aim, p_.sees);
  std::ranges::transform(offs, about.places.begin(), [&](const Vector2d& off) {
    return kick.at(place + off).value_or(KickedPlace{});
  });
  return about;
}

bool KickChoice::About::operator==(const About& other) const {
  const auto effects = [](const KickedPlace& at) {
    return std::tie(at.hits, at.direction, at.spread, at.length, at.lengthDeviation);
  };
  return spread == other.spread && std::ranges::equal(places, other.places, {}, effects, effects);
}

void KickChoice::imagine(const About& about, double facing, Imagined& imagined) {
  std::array<double, directions * lengths> shares{};
  // Between what was computed the worth is linear.
  const auto enter = [&](double direction, double length, double share) {
    const double turns = std::floor(direction / step),
                 far = std::clamp(length / lengthStep, 0., lengths - 1.001);
    const auto k = static_cast<int>(far);
    for (const int nextPath : {0, 1})
      for (const int nextLength : {0, 1}) {
        const double across = direction / step - turns, along = far - k;
        const int i = ((static_cast<int>(turns) + nextPath) % directions + directions) % directions;
        shares[static_cast<std::size_t>(i * lengths + k + nextLength)] +=
            share * (nextPath ? across : 1 - across) * (nextLength ? along : 1 - along);
      }
  };
  imagined.missed = 0;
  for (const KickedPlace& at : about.places) {
    imagined.missed += (1 - at.hits) / static_cast<double>(about.places.size());
    if (at.hits == 0) continue;
    const double sigma = fromDegrees(std::hypot(at.spread, about.spread));
    for (const auto& [astray, share] : outcomes)
      for (const double side : {-1., 1.})
        enter(facing + fromDegrees(at.direction) + astray * sigma,
              at.length + side * at.lengthDeviation,
              at.hits / static_cast<double>(about.places.size()) * share / 2);
  }
  imagined.paths.clear();
  for (int i = 0; i < directions * lengths; ++i)
    if (const double share = shares[static_cast<std::size_t>(i)]; share > 0)
      imagined.paths.push_back({i / lengths, i % lengths, share});
}

const KickChoice::Imagined& KickChoice::fromBestPlace(int motion) {
  const auto& motions = world_->motions.motions;
  fromBestPlace_.resize(motions.size());
  const KickDescription& kick = motions[static_cast<std::size_t>(motion)].kick;
  auto& [known, imagined] = fromBestPlace_[static_cast<std::size_t>(motion)];
  if (const About best = about(kick, {kick.x, kick.y}); known != best) {
    known = best;
    imagine(best, 0, imagined);
  }
  return imagined;
}

template <std::size_t count>
[[gnu::always_inline]] inline void KickChoice::addTurned(const Imagined& imagined,
                                                         std::array<double, count>& worth) const {
  constexpr std::size_t together = std::min<std::size_t>(count, 24);  // sums that registers hold
  static_assert(count % together == 0);
  for (std::size_t first = 0; first < count; first += together) {
    std::array<double, together> some;
    std::copy_n(&worth[first], together, some.begin());
    for (const Imagined::Path& path : imagined.paths) {
      const double* const turned = worthOf(path) + first;
      for (std::size_t i = 0; i < together; ++i) some[i] += path.share * turned[i];
    }
    std::ranges::copy(some, &worth[first]);
  }
}

template <std::size_t count>
std::array<double, count> KickChoice::worthTurned(const Imagined& imagined) const {
  std::array<double, count> worth;
  worth.fill(imagined.missed * stays_);
  withWideInstructions([&]() __attribute__((always_inline)) { addTurned(imagined, worth); });
  return worth;
}

double KickChoice::ownGoals(const Imagined& imagined, std::size_t turned) const {
  double share = 0;
  for (const Imagined::Path& path : imagined.paths)
    if (worthOf(path)[turned] <= ownGoal) share += path.share;
  return share;
}

double KickChoice::worthIn(double seconds, double worth) const {
  const double share = disturbed(seconds);
  return (1 - share) * worth + share * stays_;
}

/// The time (s, from now) until the first opponent is at the ball: a known one, or an obstacle that
/// is neither teammate nor wall.
double KickChoice::opponentArrival(const ObstaclesModel& obstacles) const {
  constexpr double far = 1e4, body = 300, border = 150;  // mm
  const FieldDimensions& field = world_->field;
  double distance = nearest(opponents_, ballOnField_, far);
  for (const ObstaclesModel::Sector& sector : obstacles.sectors) {
    if (!sector.obstacle) continue;
    const Vector2d place = world_->self.pose * sector.representative;
    const bool isInside = std::abs(place.x()) < field.xGroundline - border &&
                          std::abs(place.y()) < field.ySideline - border;
    const auto mates = std::span{own_}.subspan(1);
    const bool isMate = std::ranges::any_of(
        mates, [&](const Vector2d& mate) { return (mate - place).norm() < body; });
    if (isInside && !isMate) distance = std::min(distance, (place - ballOnField_).norm());
  }
  return (distance - p_.opponentReach) / p_.opponentSpeed;
}

/// The share of balls that do not move after a time (s), because an opponent has arrived.
double KickChoice::disturbed(double seconds) const {
  return p_.disturbed * std::clamp((seconds - opponentArrives_) / p_.arrives + 0.5, 0., 1.);
}

bool KickChoice::isUsed(const KickDescription& kick) const {
  return kick.falls <= p_.mostFalls && kick.seconds <= p_.longest;
}

/// The time (s) until the robot stands at the best position for a kick. `kickAngle` is the
/// direction of the ball relative to the robot at that position, minus its present direction (rad).
double KickChoice::timeTo(const KickDescription& kick, double kickAngle,
                          const Facing& facing) const {
  const Vector2d& turned = facing.turned;
  const Vector2d place = ball_ - Vector2d{turned.x() * kick.x - turned.y() * kick.y,
                                          turned.y() * kick.x + turned.x() * kick.y};
  const double off = std::abs(facing.turn + kickAngle);
  const double around = off > pi ? 2 * pi - off : off;
  constexpr double direct = fromDegrees(25);
  return std::max(place.norm() / p_.walkSpeed, std::abs(facing.turn) / fromDegrees(p_.turnSpeed)) +
         std::max(0., around - direct) / fromDegrees(p_.aroundSpeed);
}

/// Returns whether a kick of a ball at a position is reliable, strong and accurate enough; `demand`
/// is the share of the thresholds that is required.
bool KickChoice::isSure(const KickDescription& kick, const Vector2d& place, double demand) const {
  const auto at = kick.at(place);
  return at && at->hits >= demand * haste().reliable &&
         at->length >= demand * haste().strong * kick.length && demand * at->spread <= p_.accurate;
}

/// Returns whether a robot that stands behind the ball and faces a direction has room between the
/// walls; a field player outside of its own penalty area, a goalie also in its goal.
bool KickChoice::hasRoom(const Facing& facing) const {
  const FieldDimensions& field = world_->field;
  const Vector2d back = ballOnField_ - facing.along * p_.bodyLength;
  if (isGoalie()) {
    if (back.x() < 0 && back.x() > p_.wallClearance - field.xGoalBack &&
        std::abs(back.y()) < field.yGoal - p_.wallClearance)
      return true;
  } else if (back.x() < -field.xPenaltyArea && std::abs(back.y()) < field.yPenaltyArea) {
    return false;
  }
  const bool insideWalls = std::abs(back.x()) < field.xGroundline - p_.wallClearance &&
                           std::abs(back.y()) < field.ySideline - p_.wallClearance;
  const double corner =
      (field.xGroundline - std::abs(back.x())) + (field.ySideline - std::abs(back.y()));
  return insideWalls &&
         corner > field.xGroundline - field.xSideCorner + p_.wallClearance * p_.cornerClearance;
}

/// Chooses the best kick from its best position; keeps the present plan unless another one is
/// better by `otherPlan`.
void KickChoice::choosePlan() {
  const auto isSame = [before = plan_](int motion, double facing) {
    return motion == before.motion && std::abs(normalize(facing - before.facing)) < step / 2;
  };
  const bool needsRoom = std::ranges::any_of(facings_, &Facing::hasRoom);
  const double ballAngle = angleOf(ball_);
  plan_ = {};
  plan_.worth = -1e9;
  for (int motion = 1; motion < static_cast<int>(world_->motions.motions.size()); ++motion) {
    const MotionNet::Motion& described = world_->motions.motions[static_cast<std::size_t>(motion)];
    const KickDescription& kick = described.kick;
    if (!described.isKick() || !isUsed(kick)) continue;
    const Imagined& kicked = fromBestPlace(motion);
    const auto imagined = worthTurned<directions>(kicked);
    const double kickAngle = normalize(angleOf({kick.x, kick.y}) - ballAngle);
    for (std::size_t turned = 0; turned < directions; ++turned) {
      const Facing& there = facings_[turned];
      if (needsRoom && !there.hasRoom) continue;
      const double most =
          std::max(imagined[turned], stays_) - haste().second * kick.seconds + p_.otherPlan;
      if (most <= plan_.worth) continue;
      const double way = timeTo(kick, kickAngle, there);
      double worth = worthIn(way + kick.strike, imagined[turned]) -
                     haste().second * (way + kick.seconds) +
                     (isSame(motion, there.angle) ? p_.otherPlan : 0);
      if (worth <= plan_.worth) continue;
      if (isGoalie() && ownGoals(kicked, turned) > p_.ownGoalRisk) worth += ownGoal;
      if (worth > plan_.worth)
        plan_ = {motion, normalize(there.angle + fromDegrees(kick.direction)), there.angle, worth};
    }
  }
  if (isSame(plan_.motion, plan_.facing)) plan_.worth -= p_.otherPlan;
}

/// The best kick from the robot's present pose. It must also hit the ball at its present position,
/// because a robot that has only begun to walk stops at once. A kick that is about to begin is not
/// canceled because of noise in the ball's position.
KickChoice::Plan KickChoice::worthNow(int begun) {
  const Pose2D& walk = world_->motion.executed.walk;
  const bool walks = world_->motion.executed.type == MotionType::walk;
  const Pose2D stops =
      walks ? Pose2D{walk.rotation * p_.stopping, walk.translation * p_.stopping} : Pose2D{};
  const Vector2d ball = relative(stops, ball_);
  const double facing = world_->self.pose.rotation + stops.rotation;
  Plan best;
  best.worth = -1e9;
  for (int i = 1; i < static_cast<int>(world_->motions.motions.size()); ++i) {
    const MotionNet::Motion& described = world_->motions.motions[static_cast<std::size_t>(i)];
    const KickDescription& kick = described.kick;
    if (!described.isKick() || !isUsed(kick)) continue;
    const double demand = i == begun ? p_.holds : 1;
    if (!isSure(kick, ball, demand) || !isSure(kick, ball_, demand)) continue;
    imagine(about(kick, ball), facing, imagined_);
    if (isGoalie() && ownGoals(imagined_, 0) > p_.ownGoalRisk) continue;
    const double worth =
        worthIn(kick.strike, worthTurned<1>(imagined_).front()) - haste().second * kick.seconds;
    if (worth > best.worth)
      best = {i, normalize(facing + fromDegrees(kick.at(ball)->direction)), facing, worth};
  }
  return best;
}

}  // namespace gt
