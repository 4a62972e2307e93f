#include "simulation/world/BallPhysics.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace gt {
namespace {

/// Balls that are further away than this from all points a robot can reach do not touch the robot
/// in the next tick (mm).
constexpr double mayTouchWithin = 600;
/// Greatest distance by which a robot pushes a ball out of itself in a tick (mm), so that the ball
/// never gets so deep into a wall that it would leave the wall on the far side.
constexpr double longestPush = 25;
/// A part whose contact normal is steeper than this presses the ball down and does not push it.
constexpr double flattestNormal = 0.3;
/// A contact that pushes a ball along the ground.
struct Push {
  Vector2d normal;
  double depth;  ///< mm
};
/// The push by a contact; empty if it does not push along the ground.
std::optional<Push> pushOf(const mjContact& contact) {
  const Vector2d toBall{-contact.frame[0], -contact.frame[1]};
  const double flat = toBall.norm();
  if (contact.dist >= 0 || flat < flattestNormal) return std::nullopt;
  return Push{toBall / flat, -1000 * contact.dist / flat};
}
/// Greatest speed of a part of a robot (mm/s).
constexpr double fastestSurface = 3000;

}  // namespace

BallPhysics::BallPhysics(const BallParameters& parameters, const mjModel& model,
                         std::uint64_t carpetSeed)
    : parameters_(parameters),
      model_(model),
      carpetSeed_(carpetSeed),
      positions_(static_cast<std::size_t>(3 * model.ngeom)),
      rotations_(static_cast<std::size_t>(9 * model.ngeom)) {}

void BallPhysics::rememberGeoms(const mjData& data, std::span<const RobotParts> parts,
                                std::span<const RobotBody> robots,
                                std::span<const BallState> balls) {
  for (std::size_t i = 0; i < robots.size(); ++i) {
    const double within = parts[i].reach + mayTouchWithin;
    const auto mayTouch = [&](const BallState& ball) {
      return (robots[i].pose.translation - ball.position).squaredNorm() < within * within;
    };
    if (std::none_of(balls.begin(), balls.end(), mayTouch)) continue;
    const int first = parts[i].firstGeom, count = parts[i].lastGeom - first;
    std::copy_n(data.geom_xpos + 3 * first, 3 * count, positions_.begin() + 3 * first);
    std::copy_n(data.geom_xmat + 9 * first, 9 * count, rotations_.begin() + 9 * first);
  }
}

void BallPhysics::step(BallState& ball, const BallParts& parts, mjData& data,
                       const Surroundings& around) {
  const Vector2d start = ball.position;
  if (parameters_.dents > 0 && ball.speed.squaredNorm() > 0)
    ball.speed += parameters_.dents * tickSeconds *
                  Carpet{carpetSeed_, parameters_.dentSize}.pull(ball.position);
  const double speed = ball.speed.norm();
  const double slower = std::max(0., speed - parameters_.deceleration * tickSeconds);
  if (speed > 0) ball.speed *= slower / speed;
  ball.position += ball.speed * tickSeconds;
  bounceOffWalls(ball, parts.radius, around.obstacles);

  // Walls come last in each round: whatever robots do, the ball is not pushed through.
  constexpr int rounds = 4;
  double pushLeft = longestPush;
  bool touched = true;
  for (int round = 0; round < rounds && touched; ++round) {
    touched = touchRobots(ball, parts, data, around, pushLeft);
    bounceOffWalls(ball, parts.radius, around.obstacles);
  }
  if (const double fast = ball.speed.norm(); fast > parameters_.maxSpeed)
    ball.speed *= parameters_.maxSpeed / fast;

  // It rolls without sliding.
  const Vector2d way = ball.position - start;
  if (const double length = way.norm(); length > 0) {
    const mjtNum axis[3] = {-way.y() / length, way.x() / length, 0};
    mjtNum turn[4], result[4];
    mjtNum* rotation = data.qpos + parts.poseAddress + 3;
    mju_axisAngle2Quat(turn, axis, length / parts.radius);
    mju_mulQuat(result, turn, rotation);
    mju_normalize4(result);
    mju_copy4(rotation, result);
  }
}

bool BallPhysics::touchRobots(BallState& ball, const BallParts& parts, mjData& data,
                              const Surroundings& around, double& pushLeft) {
  bool touched = false;
  for (std::size_t i = 0; i < around.robots.size(); ++i) {
    if (around.apart[i]) continue;
    const Vector2d& center = around.robots[i].pose.translation;
    const double reach = around.parts[i].reach + parts.radius;
    if ((center - ball.position).squaredNorm() > reach * reach) continue;
    bool byThis = false;
    for (int geom = around.parts[i].firstGeom; geom < around.parts[i].lastGeom; ++geom)
      byThis |= touchGeom(ball, parts, data, geom, around.placed[i], center, pushLeft);
    if (!byThis) continue;
    ball.lastToucher = static_cast<int>(i);
    ball.lastTouched = around.time;
    touched = true;
  }
  return touched;
}

int BallPhysics::contactsWith(const mjData& data, int ballGeom, int geom,
                              mjContact* contacts) const {
  const mjtNum reach = model_.geom_rbound[geom] + model_.geom_rbound[ballGeom];
  mjtNum between[3];
  mju_sub3(between, data.geom_xpos + 3 * geom, data.geom_xpos + 3 * ballGeom);
  if (mju_dot3(between, between) > reach * reach) return 0;
  const mjfCollision collide = mjCOLLISIONFUNC[mjGEOM_SPHERE][model_.geom_type[geom]];
  return collide ? collide(&model_, &data, contacts, ballGeom, geom, 0) : 0;
}

bool BallPhysics::overlaps(const BallParts& ball, const mjData& data, const RobotParts& robot,
                           double depth) const {
  mjContact contacts[mjMAXCONPAIR];
  for (int geom = robot.firstGeom; geom < robot.lastGeom; ++geom) {
    const int count = contactsWith(data, ball.geom, geom, contacts);
    if (std::any_of(contacts, contacts + count, [&](const mjContact& contact) {
          const auto push = pushOf(contact);
          return push && push->depth > depth;
        }))
      return true;
  }
  return false;
}

bool BallPhysics::touchGeom(BallState& ball, const BallParts& parts, mjData& data, int geom,
                            bool still, const Vector2d& robotCenter, double& pushLeft) {
  mjtNum* position = data.geom_xpos + 3 * parts.geom;
  position[0] = ball.position.x() / 1000;
  position[1] = ball.position.y() / 1000;
  mjContact contacts[mjMAXCONPAIR];
  const int count = contactsWith(data, parts.geom, geom, contacts);
  bool touched = false;
  for (int i = 0; i < count; ++i) {
    const auto found = pushOf(contacts[i]);
    if (!found) continue;
    const auto& [normal, depth] = *found;
    const double push = std::min(depth, pushLeft);
    pushLeft -= push;
    ball.position += push * normal;
    if (depth - push > 1) {
      // Squeezed: it slips out sideways, away from the robot's middle.
      const Vector2d side{-normal.y(), normal.x()};
      ball.position += ((ball.position - robotCenter).dot(side) < 0 ? -2. : 2.) * side;
    }
    bounce(ball, normal, still ? Vector2d{0, 0} : speedOfGeom(data, geom, contacts[i].pos),
           parameters_.bounceRobot);
    touched = true;
  }
  return touched;
}

void BallPhysics::bounceOffWalls(BallState& ball, double radius, const Obstacles& obstacles) const {
  for (int i = 0; i < 2; ++i)  // a corner's second wall may push into the first
    obstacles.pushOut(ball.position, radius, [&](const Vector2d& normal) {
      bounce(ball, normal, {0, 0}, parameters_.bounceWall);
    });
}

void BallPhysics::bounce(BallState& ball, const Vector2d& normal, const Vector2d& surfaceSpeed,
                         double restitution) const {
  const Vector2d relative = ball.speed - surfaceSpeed;
  const double into = relative.dot(normal);
  if (into >= 0) return;
  const Vector2d sliding = relative - into * normal;
  ball.speed -= (1 + restitution) * into * normal + parameters_.friction * sliding;
}

Vector2d BallPhysics::speedOfGeom(const mjData& data, int geom, const mjtNum* point) const {
  const std::size_t g = static_cast<std::size_t>(geom);
  mjtNum fromCenter[3], inGeom[3], before[3];
  mju_sub3(fromCenter, point, data.geom_xpos + 3 * geom);
  mju_rotVecMatT(inGeom, fromCenter, data.geom_xmat + 9 * geom);
  mju_rotVecMat(before, inGeom, rotations_.data() + 9 * g);
  mju_addTo3(before, positions_.data() + 3 * g);
  Vector2d speed{1000 * (point[0] - before[0]) / tickSeconds,
                 1000 * (point[1] - before[1]) / tickSeconds};
  if (const double fast = speed.norm(); fast > fastestSurface) speed *= fastestSurface / fast;
  return speed;
}

}  // namespace gt
