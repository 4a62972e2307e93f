#include "simulation/world/KinematicWorld.h"

#include <algorithm>
#include <cmath>

#include "representations/infrastructure/RobotDimensions.h"
#include "representations/infrastructure/RobotFootprint.h"
#include "simulation/world/Servo.h"
#include "simulation/world/Stance.h"

namespace gt {
namespace {

constexpr double footprintRadius = RobotFootprint::radius;
constexpr auto footprintX = RobotFootprint::middles;

/// The motion of a joint without load in a tick.
struct FreeMotion {
  double share;    ///< of the distance to its target, in a tick
  double fastest;  ///< rad, in a tick
};

EnumArray<Joint, FreeMotion> freeMotions() {
  EnumArray<Joint, FreeMotion> motions;
  for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
    const auto joint = static_cast<Joint>(j);
    motions.values[j] = {1 - std::exp(-tickSeconds / Servo{joint}.lag()),
                         motorOf(joint).noLoadSpeed * tickSeconds};
  }
  return motions;
}

/// Points of the trunk that rest on the ground when the legs do not reach it, and the radius of a
/// knee.
const GroundPoint chest{{66, 0, -12}, 28}, rump{{-82, 0, -38}, 0};
constexpr double kneeRadius = 14;

/// Greatest speed of a ball that a kick can play: a faster one is not where the kick will play it.
constexpr double slowBall = 100;  // mm/s

Vector2d disc(const Pose2D& pose, double x) {
  return pose.translation + x * direction(pose.rotation);
}

}  // namespace

KinematicWorld::KinematicWorld(const SceneDescription& scene, Model model, const Random& random)
    : World(scene, std::move(model)),
      noise_(scene.noise),
      body_(scene.body),
      walkingParameters_(scene.walking),
      ballPhysics_(scene.physics, *model_, random.fork("carpet")()) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Walking walking{.noise = StepNoise{random.fork("steps " + std::to_string(i))},
                    .gait = Gait{random.fork("gait " + std::to_string(i))}};
    Random slip = random.fork("walking " + std::to_string(i));
    for (double* factor : {&walking.forward, &walking.sideways, &walking.turn})
      *factor = 1 + noise_.slip * slip.symmetric();
    walking_.push_back(walking);
    kicking_.push_back({.from = {}, .random = random.fork("kicks " + std::to_string(i))});
  }
  plays_.resize(robots_.size());
  clear_.resize(robots_.size());
  from_.resize(robots_.size());
  ways_.resize(robots_.size());
}

Result<std::unique_ptr<World>> KinematicWorld::make(const SceneDescription& scene, Model model,
                                                    const Random& random) {
  std::unique_ptr<KinematicWorld> world{new KinematicWorld{scene, std::move(model), random}};
  if (auto found = world->findParts(scene); !found) return found.error();
  // The robots begin as they would stand up from the power-on pose: on straight legs.
  for (std::size_t i = 0; i < world->balls_.size(); ++i) world->writeBall(i);
  for (std::size_t i = 0; i < world->robots_.size(); ++i) world->setStance(i, true);
  world->updateKinematics();
  world->putAll();
  return std::unique_ptr<World>{std::move(world)};
}

void KinematicWorld::change(const SceneDescription& scene) {
  World::change(scene);
  noise_ = scene.noise;
  body_ = scene.body;
  walkingParameters_ = scene.walking;
  ballPhysics_.change(scene.physics);
}

void KinematicWorld::step(std::span<const RobotCommand> commands) {
  ballPhysics_.rememberGeoms(*data_, parts_, robots_, balls_);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    from_[i] = robots_[i].pose.translation;
    ways_[i].setZero();
    robots_[i].pushes = -1;
  }
  for (std::size_t i = 0; i < std::min(activeRobots(), commands.size()); ++i) {
    moveJoints(robots_[i], commands[i].joints);
    walk(i, possibleStep(commands[i].step));
  }
  partRobots();
  for (std::size_t i = 0; i < robots_.size(); ++i) noteBlocked(i);
  for (std::size_t i = 0; i < robots_.size(); ++i) setStance(i, true);
  updateKinematics();
  for (std::size_t i = 0; i < std::min(activeRobots(), commands.size()); ++i)
    kick(i, commands[i].kick);
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const BallPhysics::Surroundings around{parts_, robots_, placed_, plays_, obstacles_, time()};
    ballPhysics_.step(balls_[i], ballParts_[i], *data_, around);
    writeBall(i);
  }
  advanceTime();
}

void KinematicWorld::moveJoints(RobotBody& robot, const JointAngles& targets) const {
  static const EnumArray<Joint, FreeMotion> free = freeMotions();
  const double held = robot.blocked ? 1 - walkingParameters_.contactLag : 1;
  for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
    if (!std::isfinite(targets.values[j])) continue;
    const JointLimits limits = limitsOf(static_cast<Joint>(j));
    const auto [share, fastest] = free.values[j];
    const double moves = isOfLeg(static_cast<Joint>(j)) ? held : 1;
    double& angle = robot.joints.values[j];
    const double target = std::clamp(targets.values[j], limits.low, limits.high);
    angle += moves * std::clamp(share * (target - angle), -fastest, fastest);
  }
}

void KinematicWorld::walk(std::size_t i, const Pose2D& step) {
  RobotBody& robot = robots_[i];
  Walking& walking = walking_[i];
  const double length = step.translation.norm();
  constexpr double turnCounts = 100;  // mm/rad
  walking.speed = (length + turnCounts * std::abs(step.rotation)) / tickSeconds;
  walking.ahead = walking.speed > 0 ? step.translation.x() / tickSeconds / walking.speed : 0;
  if (robot.posture != Posture::standing || walking.speed == 0) return;
  const double progress = walking.gait.progress(walkingParameters_, walking.speed);
  Pose2D real{progress * walking.turn * step.rotation,
              {progress * walking.forward * step.translation.x(),
               progress * walking.sideways * step.translation.y()}};
  const Pose2D noise = walking.noise.next(noise_, step);
  real.translation += noise.translation;
  real.rotation += noise.rotation;
  real.rotation += walking.gait.contactTurn(walkingParameters_, robot.blocked);
  robot.pose = robot.pose * real;
  ways_[i] = robot.pose.translation - from_[i];
  robot.walked += real.translation.norm();
}

void KinematicWorld::kick(std::size_t i, const KickDescription* kick) {
  Kicking& kicking = kicking_[i];
  const bool again = kick && kick == kicking.kick && kicking.ticks * tickSeconds > kick->seconds;
  if (kick != kicking.kick || again) {
    kicking.kick = kick;
    kicking.ticks = 0;
    kicking.from = robots_[i].pose;
    kicking.hasStruck = false;
  }
  plays_[i] = false;
  if (!kick || robots_[i].posture != Posture::standing) return;
  const bool strikes = kicking.ticks++ == static_cast<int>(std::lround(kick->strike / tickSeconds));
  for (BallState& ball : balls_) {
    const auto place = kick->at(relative(kicking.from, ball.position));
    if (kicking.hasStruck ? ball.lastToucher == static_cast<int>(i)
                          : place && ball.speed.norm() < slowBall)
      plays_[i] = true;
    if (!place || !strikes || kicking.random.uniform() >= place->hits) continue;
    const double length =
        std::max(0., place->length + place->lengthDeviation * kicking.random.gaussian());
    const double angle = place->direction + place->spread * kicking.random.gaussian();
    ball.speed = std::sqrt(2 * ballPhysics_.deceleration() * length) *
                 direction(kicking.from.rotation + fromDegrees(angle));
    ball.lastToucher = static_cast<int>(i);
    ball.lastTouched = time();
    kicking.hasStruck = true;
    plays_[i] = true;
  }
}

bool KinematicWorld::partPair(std::size_t a, std::size_t b) {
  constexpr double reach = 2 * (footprintRadius + footprintX[0]);
  RobotBody &first = robots_[a], &second = robots_[b];
  if ((first.pose.translation - second.pose.translation).squaredNorm() > reach * reach)
    return false;
  bool touched = false;
  for (const double x1 : footprintX)
    for (const double x2 : footprintX) {
      Overlap overlap;
      if (!discsOverlap(disc(first.pose, x1), disc(second.pose, x2), 2 * footprintRadius, overlap))
        continue;
      if (ways_[a].dot(overlap.normal) < 0) first.pushes = static_cast<int>(b);
      if (ways_[b].dot(overlap.normal) > 0) second.pushes = static_cast<int>(a);
      first.pose.translation += overlap.depth / 2 * overlap.normal;
      second.pose.translation -= overlap.depth / 2 * overlap.normal;
      touched = true;
    }
  return touched;
}

void KinematicWorld::putDown(std::size_t robot) {
  setStance(robot, false);
  updateKinematics();
}

bool KinematicWorld::robotsOverlap(std::size_t a, std::size_t b) const {
  constexpr double near = 2 * footprintRadius - touching;
  return std::ranges::any_of(footprintX, [&](double x1) {
    return std::ranges::any_of(footprintX, [&](double x2) {
      return (disc(robots_[a].pose, x1) - disc(robots_[b].pose, x2)).norm() < near;
    });
  });
}

bool KinematicWorld::robotOverlapsField(std::size_t robot) const {
  return std::ranges::any_of(footprintX, [&](double x) {
    return obstacles_.distanceTo(disc(robots_[robot].pose, x)) < footprintRadius - touching;
  });
}

bool KinematicWorld::ballOverlapsRobot(std::size_t ball, std::size_t robot) const {
  return ballPhysics_.overlaps(ballParts_[ball], *data_, parts_[robot], touching);
}

bool KinematicWorld::ballOverlapsField(std::size_t ball) const {
  return obstacles_.distanceTo(balls_[ball].position) < ballParts_[ball].radius - touching;
}

bool KinematicWorld::mayMeetObstacle(std::size_t i) {
  constexpr double reach = footprintRadius + footprintX[0];
  const Vector2d& at = robots_[i].pose.translation;
  Clearance& clear = clear_[i];
  constexpr double worthLooking = 25;  // mm: beside a wall it is not measured anew all the time
  const double gone = (at - clear.from).norm();
  if (gone + reach < clear.distance) return false;
  if (gone > worthLooking || clear.distance == 0) clear = {at, obstacles_.distanceTo(at)};
  return (at - clear.from).norm() + reach >= clear.distance;
}

void KinematicWorld::noteBlocked(std::size_t i) {
  constexpr double slip = 0.1;  // mm
  const Vector2d missing = from_[i] + ways_[i] - robots_[i].pose.translation;
  robots_[i].blocked = ways_[i].dot(missing) > slip * ways_[i].norm();
}

void KinematicWorld::partRobots() {
  constexpr int rounds = 10;
  for (int round = 0; round < rounds; ++round) {
    bool touched = false;
    for (std::size_t a = 0; a < robots_.size(); ++a)
      for (std::size_t b = a + 1; b < robots_.size(); ++b) touched |= partPair(a, b);
    // Walls come last, so that no robot is pushed through one by others.
    for (std::size_t i = 0; i < robots_.size(); ++i) {
      if (!mayMeetObstacle(i)) continue;
      RobotBody& robot = robots_[i];
      for (const double x : footprintX) {
        const Vector2d before = disc(robot.pose, x);
        Vector2d center = before;
        obstacles_.pushOut(center, footprintRadius, [&](const Vector2d&) { touched = true; });
        robot.pose.translation += center - before;
      }
    }
    if (!touched) return;
  }
}

void KinematicWorld::setStance(std::size_t i, bool goesOn) {
  RobotBody& robot = robots_[i];
  const RobotParts& parts = parts_[i];
  const Lean lean = leanOf(robot.posture);
  robot.roll = lean.roll;
  if (robot.posture != Posture::standing) {
    robot.height =
        62 + 110 * std::abs(std::sin(lean.tilt));  // the trunk lies on its legs, or leans
    robot.tilt = lean.tilt;
    robot.footOnGround.fill(false);
  } else {
    std::array<GroundPoint, 5> fore, hind;
    const auto point = [&](std::size_t leg, std::size_t n) -> GroundPoint& {
      return leg < 2 ? fore[2 * leg + n] : hind[2 * (leg - 2) + n];
    };
    for (std::size_t leg = 0; leg < 4; ++leg) {
      const LegPose pose = legPose(*model_, parts, robot.joints, leg);
      point(leg, 0) = {pose.foot, 1000 * model_->site_size[3 * parts.footSites[leg]]};
      point(leg, 1) = {pose.knee, kneeRadius};
    }
    fore[4] = chest;
    hind[4] = rump;
    const Stance stance = stand(fore, hind, robot.tilt);
    std::array<double, 4> lifts;
    for (std::size_t leg = 0; leg < 4; ++leg) {
      lifts[leg] = clearance(point(leg, 0), stance);
      robot.footOnGround[leg] = lifts[leg] < 1;
    }
    Gait& gait = walking_[i].gait;
    const Sway& sway =
        goesOn ? gait.sway(body_, lifts, stance.height, walking_[i].speed, walking_[i].ahead)
               : gait.sway();
    robot.height = stance.height + sway.height;
    robot.tilt = stance.tilt + sway.tilt;
    robot.roll += sway.roll;
  }
  // Only things in the way are felt, not the body's own motion, which follows no forces.
  robot.specificForce = robot.origin().rotation.transpose() * Vector3d{0, 0, 9810};
  if (goesOn)
    robot.specificForce += walking_[i].gait.contactShaking(walkingParameters_, robot.blocked);
  writeRobot(i);
}

}  // namespace gt
