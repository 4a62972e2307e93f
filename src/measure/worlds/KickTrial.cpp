#include "measure/worlds/KickTrial.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "base/Statistics.h"
#include "modules/kinematics/HeadKinematics.h"

namespace gt {
namespace {

constexpr double hitsFrom = 150;  // mm: a shorter way is no hit
constexpr double reliably = 0.9;  // share of hits
constexpr double stands = 0.02;   // share of falls around the best place, if there is such a place
constexpr double anywhere = 45;   // degrees, a standard deviation: the ball goes anywhere
constexpr double degreeCosts = 200;  // mm of length that a degree of spread is worth

/// Whether the robot's head touches the ball, and no other part of it.
bool touchesByHeadAlone(const World& world) {
  const RobotParts& parts = world.parts(0);
  bool byHead = false;
  for (int i = 0; i < world.data().ncon; ++i) {
    const mjContact& contact = world.data().contact[i];
    const int first = world.model().geom_bodyid[contact.geom1];
    const int second = world.model().geom_bodyid[contact.geom2];
    if (first != world.ballBody(0) && second != world.ballBody(0)) continue;
    const int other = first == world.ballBody(0) ? second : first;
    const bool ofRobot = world.model().body_rootid[other] == parts.body;
    if (ofRobot && other != parts.headBody) return false;
    byHead |= ofRobot;
  }
  return byHead;
}

/// Has the head look at a ball that lies at a place (mm) before a robot that stands.
void lookAtBall(MovedRobot& robot, const Vector2d& place) {
  const Pose3D body{rotationY(-robot.body().tilt), {0, 0, robot.body().height}};
  const Vector3d ball{place.x(), place.y(), robot.world().ballRadius(0)};
  const CameraInfo camera;
  const HeadAngles head = lookAt({}, body, ball, camera, {camera.centerX, camera.centerY});
  robot.head = {.tilt = head.tilt, .pan = head.pan};
}

double round(double value, double unit) {
  return std::round(value / unit) * unit;
}

double apart(double a, double b) {
  return toDegrees(normalize(fromDegrees(a - b)));
}

double deviation(const std::vector<double>& values) {
  RunningStatistics all;
  for (const double value : values) all.add(value);
  return all.standardDeviation();
}

/// What is known of one place of the grid.
struct Place {
  std::vector<double> hits, falls, lengths, directions;
};
using Places = std::map<std::pair<int, int>, Place>;

/// The place as a row of the table, if the ball goes one way from there.
std::optional<KickedPlace> rowOf(int x, int y, const Place& place) {
  if (place.lengths.size() < 2) return {};
  Vector2d sum = Vector2d::Zero();
  for (const double angle : place.directions) sum += direction(fromDegrees(angle));
  const double middle = toDegrees(angleOf(sum));
  double squares = 0;
  for (const double angle : place.directions) squares += std::pow(apart(angle, middle), 2);
  const double spread = std::sqrt(squares / static_cast<double>(place.directions.size()));
  if (spread >= anywhere) return {};
  return KickedPlace{1. * x,
                     1. * y,
                     mean(place.hits),
                     middle,
                     spread,
                     mean(place.lengths),
                     deviation(place.lengths)};
}

bool isNear(const KickedPlace& a, const KickedPlace& b, double distance) {
  return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) <= distance;
}

/// What a place is worth (mm), and why.
std::pair<double, std::string> worthOf(const KickedPlace& place,
                                       const std::vector<KickedPlace>& rows) {
  std::vector<double> lengths, astray(4, place.spread);  // its own counts most
  double sure = 1;
  for (const KickedPlace& row : rows) {
    if (!isNear(row, place, KickGrid::step)) continue;
    lengths.push_back(row.length);
    astray.push_back(std::hypot(apart(row.direction, place.direction), row.spread));
    sure = std::min(sure, row.hits);
  }
  constexpr std::size_t around = 9;
  const std::size_t missing = around - lengths.size();
  if (missing > 0) sure = 0.5;
  const std::string hits =
      missing == 0 ? fmt::format("hits at least {:.0f} %", 100 * sure)
                   : fmt::format("{} of the places around it are no hits (50 %)", missing);
  const double length = mean(lengths), off = mean(astray);
  return {sure * length - degreeCosts * off,
          fmt::format("{} x {:.0f} mm with the places around it - {:.1f} degrees astray x {} mm",
                      hits, length, off, degreeCosts)};
}

double fallsAround(const KickedPlace& row, const Places& places) {
  std::vector<double> falls;
  for (const auto& [at, place] : places)
    if (isNear({1. * at.first, 1. * at.second}, row, 1.5 * KickGrid::step))
      falls.insert(falls.end(), place.falls.begin(), place.falls.end());
  return mean(falls);
}

/// The best of the rows; null if the ball is hit reliably from none.
const KickedPlace* bestOf(const std::vector<KickedPlace>& rows, const Places& places) {
  const KickedPlace* best = nullptr;
  std::pair<bool, double> most;
  for (const KickedPlace& row : rows) {
    if (row.hits < reliably) continue;
    const std::pair worth{fallsAround(row, places) <= stands, worthOf(row, rows).first};
    if (!best || worth > most) best = &row, most = worth;
  }
  return best;
}

}  // namespace

KickTrial tryKick(MovedRobot& robot, const std::string& motion, const Vector2d& place,
                  Random& random) {
  robot.request = {};
  robot.world().placeBall(0, {1900, 1200});
  robot.world().placeRobot(0, {pi * random.symmetric(), 0, 0});
  robot.run(0.6);
  lookAtBall(robot, place);
  robot.request.type = MotionType::walk;
  robot.request.walkType = WalkType::fast;
  robot.request.walk = {0.2 * random.symmetric(), 100 * random.uniform(), 40 * random.symmetric()};
  robot.run(1 + 0.5 * random.uniform());
  robot.request = {};
  robot.request.type = MotionType::specialAction;
  robot.request.specialAction = motion;
  constexpr double longest = 8;  // s
  double waited = 0;
  for (; robot.motion().executed.specialAction != motion && waited < longest; waited += tickSeconds)
    robot.step();
  const Pose2D from = robot.body().pose;
  robot.world().placeBall(0, from * place);
  KickTrial kick;
  robot.step();
  constexpr double pushed = 30;  // mm/s
  kick.overlaps = robot.world().ball(0).speed.norm() > pushed;
  if (kick.overlaps) return kick;
  double fastest = 0, gained = 0, before = 0;  // mm/s
  const auto step = [&] {
    robot.step();
    kick.seconds += tickSeconds;
    const double speed = robot.world().ball(0).speed.norm();
    const double gain = std::max(0., speed - std::exchange(before, speed));
    gained += gain;
    if (touchesByHeadAlone(robot.world())) kick.byHead += gain;
    if (speed > fastest) kick.strike = kick.seconds;
    fastest = std::max(fastest, speed);
  };
  robot.request = {};
  while (robot.motion().executed.type == MotionType::specialAction && kick.seconds < longest)
    step();
  if (gained > 0) kick.byHead /= gained;
  kick.moved = robot.body().pose.relativeTo(from);
  const BallState& ball = robot.world().ball(0);
  const double slowing = robot.simulation().scene().physics.deceleration;
  const Vector2d rolls = ball.speed * ball.speed.norm() / (2 * slowing);
  kick.way = relative(from, Vector2d{ball.position + rolls}) - place;
  // What rolls over on purpose stands again now; others fall only when they stand again.
  for (double after = 0; after < 1; after += tickSeconds) {
    robot.step();
    kick.fell |= robot.hasFallen();
  }
  return kick;
}

std::vector<GridTrial> tryGrid(MovedRobot& robot, const std::string& motion, Random& random,
                               const std::vector<GridTrial>* near) {
  using Grid = KickGrid;
  const auto isWorthIt = [&](int x, int y) {
    if (!near) return (x - Grid::nearest) % (2 * Grid::step) == 0 && y % (2 * Grid::step) == 0;
    return std::ranges::any_of(*near, [&](const GridTrial& trial) {
      return trial.kick.way.norm() > hitsFrom &&
             std::max(std::abs(x - trial.x), std::abs(y - trial.y)) <= Grid::step;
    });
  };
  std::vector<GridTrial> trials;
  for (int x = Grid::nearest; x <= Grid::farthest; x += Grid::step)
    for (int y = -Grid::widest; y <= Grid::widest; y += Grid::step) {
      if (!isWorthIt(x, y)) continue;
      const auto around = [&](int middle) { return middle + Grid::step / 2. * random.symmetric(); };
      const double ahead = around(x), left = around(y);
      trials.push_back({x, y, tryKick(robot, motion, {ahead, left}, random)});
    }
  return trials;
}

DescribedKick describeKick(const std::string& motion, const std::vector<GridTrial>& trials) {
  Places places;
  std::vector<double> strikes, seconds;
  for (const GridTrial& trial : trials) {
    if (trial.kick.overlaps) continue;
    Place& place = places[{trial.x, trial.y}];
    const double length = trial.kick.way.norm();
    place.hits.push_back(length > hitsFrom ? 1 : 0);
    place.falls.push_back(trial.kick.fell ? 1 : 0);
    seconds.push_back(trial.kick.seconds);
    if (length <= hitsFrom) continue;
    place.lengths.push_back(length);
    place.directions.push_back(toDegrees(angleOf(trial.kick.way)));
    strikes.push_back(trial.kick.strike);
  }
  std::vector<KickedPlace> rows;
  for (const auto& [at, place] : places)
    if (const auto row = rowOf(at.first, at.second, place)) rows.push_back(*row);
  DescribedKick described{{}, "hits 90 % of the balls from no place"};
  KickDescription& kick = described.kick;
  kick.motion = motion;
  const KickedPlace* best = bestOf(rows, places);
  if (!best) return described;
  const auto [worth, why] = worthOf(*best, rows);
  described.why = fmt::format(
      "best place {}, {}: {:.0f} mm to {:.0f} degrees, spread {:.1f}; worth {:.0f} = {}", best->x,
      best->y, best->length, best->direction, best->spread, worth, why);
  kick.x = best->x;
  kick.y = best->y;
  kick.direction = round(best->direction, 0.1);
  kick.length = round(best->length, 1);
  kick.seconds = round(mean(seconds), 0.001);
  kick.strike = round(quantile(strikes, 0.5), 0.001);
  kick.falls = round(fallsAround(*best, places), 0.0001);
  kick.step = KickGrid::step;
  for (const KickedPlace& row : rows)
    kick.places.push_back({row.x, row.y, round(row.hits, 0.01), round(row.direction, 0.1),
                           round(row.spread, 0.1), round(row.length, 1),
                           round(row.lengthDeviation, 1)});
  return described;
}

}  // namespace gt
