#include "simulation/world/DynamicWorld.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

constexpr int stepsPerTick = 2;
constexpr double stepSeconds = tickSeconds / stepsPerTick;
constexpr double gravity = 9.81;       // m/s^2
constexpr double gearInertia = 6e-4;   // kg m^2, of a motor as seen from behind its gear; ESTIMATE
constexpr double groundGap = 0.0005;   // m: the floor lies that far below the carpet's surface
constexpr std::int64_t heldMs = 3000;  // how long robots are held at most when they are switched on
constexpr int restTicks = 4;           // for which their legs rest before they are put down
constexpr double fastest = 20, widestTurn = 100;  // m/s, rad/s: no body moves faster
constexpr double fastestRobot = 2;                // m/s: as after a fall from 20 cm
constexpr double rollingMass = 1.4;  // share of its mass that a rolling ball's inertia feels like

// Bits of a geom's contype, which state what it is: one for each robot, since all robots collide
// with all others.
constexpr int floorBit = 1, wallBit = 2, ballBit = 4, firstRobotBit = 8;
static_assert(maxSceneRobots <= 28);

Vector3d threeOf(const mjtNum* numbers) {
  return Eigen::Map<const Vector3d>(numbers);
}

/// How far the lowest point of a geom lies below its center (m).
double reachDown(const mjModel& model, const mjData& data, int geom) {
  const mjtNum* size = model.geom_size + 3 * geom;
  const mjtNum* toWorld = data.geom_xmat + 9 * geom;
  const double x = std::abs(toWorld[6]), y = std::abs(toWorld[7]), z = std::abs(toWorld[8]);
  switch (model.geom_type[geom]) {
    case mjGEOM_SPHERE:
      return size[0];
    case mjGEOM_CAPSULE:
      return size[0] + z * size[1];
    case mjGEOM_CYLINDER:
      return std::hypot(x, y) * size[0] + z * size[1];
    case mjGEOM_BOX:
      return x * size[0] + y * size[1] + z * size[2];
    default:
      return model.geom_rbound[geom];
  }
}

}  // namespace

DynamicWorld::DynamicWorld(const SceneDescription& scene, Model model, const Random& random)
    : World(scene, std::move(model)),
      noise_(scene.noise),
      ballParameters_(scene.physics),
      carpetSeed_(random.fork("carpet")()) {}

Result<std::unique_ptr<World>> DynamicWorld::make(const SceneDescription& scene, Model model,
                                                  const Random& random) {
  std::unique_ptr<DynamicWorld> world{new DynamicWorld{scene, std::move(model), random}};
  if (auto found = world->findParts(scene); !found) return found.error();
  world->prepareModel(random);
  world->prepareContacts();
  world->setDynamics(scene.dynamics);
  // The robots begin as they would stand up from the power-on pose: on straight legs.
  world->putAll();
  world->putByHand();
  for (std::size_t i = 0; i < world->robots_.size(); ++i) world->readRobot(i);
  world->placed_.assign(world->robots_.size(), false);
  return std::unique_ptr<World>{std::move(world)};
}

void DynamicWorld::prepareModel(const Random& random) {
  mjModel& model = *model_;
  model.opt.timestep = stepSeconds;
  model.opt.solver = mjSOL_NEWTON;  // three rounds on average, where the others need ten to twenty
  model.opt.gravity[2] = -gravity;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    Motors motors{.noise = StepNoise{random.fork("steps " + std::to_string(i))}};
    motors.firstDof = model.body_dofadr[parts_[i].body];
    for (std::size_t j = 0; j < enumCount<Joint>; ++j)
      motors.servos.emplace_back(static_cast<Joint>(j));
    motors_.push_back(std::move(motors));
  }
  for (std::size_t i = 0; i < motors_.size(); ++i)
    for (std::size_t j = 0; j < enumCount<Joint>; ++j)
      model.dof_armature[jointDof(i, j)] = gearInertia;
  setFriction();
}

void DynamicWorld::setDynamics(const DynamicsParameters& dynamics) {
  if (dynamics == dynamics_) return;
  mjModel& model = *model_;
  const double mass = dynamics.mass / dynamics_.mass;
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    for (int geom = parts_[i].firstGeom; geom < parts_[i].lastGeom; ++geom)
      model.geom_friction[3 * geom] *= dynamics.friction / dynamics_.friction;
    for (int body = parts_[i].body; body < model.nbody && model.body_rootid[body] == parts_[i].body;
         ++body) {
      model.body_mass[body] *= mass;
      for (int k = 0; k < 3; ++k) model.body_inertia[3 * body + k] *= mass;
    }
    for (Servo& servo : motors_[i].servos) servo.setStrength(dynamics.strength);
  }
  dynamics_ = dynamics;
  // MuJoCo derives values from masses in a separate state, so that this one is not changed.
  const ModelData scratch = makeData(model);
  mj_setConst(&model, scratch.get());
}

void DynamicWorld::setFriction() {
  // A force of rolling friction m g c / r on the ball slows it down by 5/7 g c / r.
  for (const BallParts& ball : ballParts_)
    model_->geom_friction[3 * ball.geom + 2] =
        ballParameters_.deceleration / 1000 * rollingMass * ball.radius / 1000 / gravity;
}

void DynamicWorld::change(const SceneDescription& scene) {
  World::change(scene);
  noise_ = scene.noise;
  ballParameters_ = scene.physics;
  setFriction();
  setDynamics(scene.dynamics);
}

void DynamicWorld::prepareContacts() {
  mjModel& model = *model_;
  robotOfBody_.assign(static_cast<std::size_t>(model.nbody), -1);
  ballOfBody_ = robotOfBody_;
  for (std::size_t i = 0; i < parts_.size(); ++i)
    robotOfBody_[static_cast<std::size_t>(parts_[i].body)] = static_cast<int>(i);
  for (std::size_t i = 0; i < ballParts_.size(); ++i)
    ballOfBody_[static_cast<std::size_t>(ballParts_[i].body)] = static_cast<int>(i);
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (model.geom_contype[geom] == 0) continue;
    const auto root = static_cast<std::size_t>(model.body_rootid[model.geom_bodyid[geom]]);
    model.geom_conaffinity[geom] = 0;
    if (const int robot = robotOfBody_[root]; robot >= 0) {
      model.geom_contype[geom] = firstRobotBit << robot;
      motors_[static_cast<std::size_t>(robot)].solidGeoms.push_back(geom);
    } else if (ballOfBody_[root] >= 0) {
      model.geom_contype[geom] = ballBit;
      model.geom_conaffinity[geom] = floorBit | wallBit | ballBit;
    } else if (model.geom_type[geom] == mjGEOM_PLANE) {
      model.geom_contype[geom] = floorBit;
    } else {
      walls_.push_back(geom);
    }
  }
}

void DynamicWorld::lookAround() {
  // MuJoCo tests all pairs of geoms that their bits allow, so the bits allow only near ones.
  // It also sorts all bodies that could touch any other, so walls are solid only if one is near.
  constexpr double furthest = 1000 * fastest * tickSeconds;  // mm: way of a ball in a tick
  bool anyWall = false;
  for (std::size_t b = 0; b < balls_.size(); ++b)
    anyWall |= std::ranges::any_of(walls_, [&](int wall) {
      return wallIsNear(wall, balls_[b].position, ballParts_[b].radius + furthest);
    });
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    const Vector2d& center = robots_[i].pose.translation;
    const double reach = parts_[i].reach;
    int bits = floorBit;
    Vector2d pushed = center;
    obstacles_.pushOut(pushed, reach, [&](const Vector2d&) { bits |= wallBit; });
    for (std::size_t b = 0; b < balls_.size(); ++b)
      if ((balls_[b].position - center).norm() < reach + ballParts_[b].radius) bits |= ballBit;
    for (std::size_t other = 0; other < i; ++other)
      if ((robots_[other].pose.translation - center).norm() < reach + parts_[other].reach)
        bits |= firstRobotBit << other;
    for (const int geom : motors_[i].solidGeoms) model_->geom_conaffinity[geom] = bits;
    anyWall |= (bits & wallBit) != 0;
  }
  for (const int geom : walls_) model_->geom_contype[geom] = anyWall ? wallBit : 0;
}

bool DynamicWorld::wallIsNear(int wall, const Vector2d& point, double distance) const {
  const mjtNum* size = model_->geom_size + 3 * wall;
  const mjtNum* toWorld = data_->geom_xmat + 9 * wall;
  for (int k = 0; k < 2; ++k) {
    double half = model_->geom_rbound[wall];
    if (model_->geom_type[wall] == mjGEOM_BOX) {
      half = 0;
      for (int i = 0; i < 3; ++i) half += std::abs(toWorld[3 * k + i]) * size[i];
    }
    if (std::abs(point[k] - 1000 * data_->geom_xpos[3 * wall + k]) > 1000 * half + distance)
      return false;
  }
  return true;
}

int DynamicWorld::jointDof(std::size_t robot, std::size_t joint) const {
  // Behind the 7 coordinates and 6 degrees of freedom of the body each joint has one of both.
  const RobotParts& parts = parts_[robot];
  return motors_[robot].firstDof + parts.jointAddress.values[joint] - parts.poseAddress - 1;
}

void DynamicWorld::step(std::span<const RobotCommand> commands) {
  for (std::size_t i = 0; i < std::min(activeRobots(), commands.size()); ++i)
    for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
      Servo& servo = motors_[i].servos[j];
      servo.setTarget(commands[i].joints.values[j]);
      servo.setGains(commands[i].gains.gains.values[j]);
    }
  holdRobots();
  putByHand();
  lookAround();
  for (std::size_t i = 0; i < std::min(activeRobots(), commands.size()); ++i)
    drag(i, possibleStep(commands[i].step));
  pullBalls();
  forgetContacts();
  for (int n = 0; n < stepsPerTick; ++n) {
    drive();
    mj_step(model_.get(), data_.get());
    readContacts();
  }
  for (const RobotParts& parts : parts_) std::fill_n(data_->xfrc_applied + 6 * parts.body, 6, 0);
  undoIfBroken();
  updateKinematics();
  for (std::size_t i = 0; i < robots_.size(); ++i) readRobot(i);
  for (std::size_t i = 0; i < balls_.size(); ++i) readBall(i);
  advanceTime();
}

void DynamicWorld::push(std::size_t robot, const Vector3d& force, const Vector3d& at) {
  const int body = parts_[robot].body;
  const Matrix3d rotation = rotationFromMuJoCo(data_->xmat + 9 * body);
  const Vector3d lever =
      threeOf(data_->xpos + 3 * body) + rotation * at / 1000 - threeOf(data_->xipos + 3 * body);
  Eigen::Map<Vector3d>{data_->xfrc_applied + 6 * body} += force;
  Eigen::Map<Vector3d>{data_->xfrc_applied + 6 * body + 3} += lever.cross(force);
}

void DynamicWorld::drive() {
  for (std::size_t i = 0; i < motors_.size(); ++i)
    for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
      const int dof = jointDof(i, j);
      const double angle = data_->qpos[parts_[i].jointAddress.values[j]];
      const Drive drive = motors_[i].servos[j].drive(angle, data_->qvel[dof], stepSeconds);
      data_->qfrc_applied[dof] = drive.torque;
      model_->dof_damping[dof] = drive.damping;
    }
}

void DynamicWorld::pullBalls() {
  if (ballParameters_.dents == 0) return;
  constexpr double rolls = 20;  // mm/s: more slowly it would creep, not rest
  const Carpet carpet{carpetSeed_, ballParameters_.dentSize};
  for (std::size_t i = 0; i < balls_.size(); ++i) {
    const int body = ballParts_[i].body;
    const Vector2d pull = balls_[i].speed.norm() > rolls
                              ? Vector2d{ballParameters_.dents * carpet.pull(balls_[i].position)}
                              : Vector2d{0, 0};
    for (int k = 0; k < 2; ++k)
      data_->xfrc_applied[6 * body + k] = rollingMass * model_->body_mass[body] * pull[k] / 1000;
  }
}

void DynamicWorld::drag(std::size_t robot, const Pose2D& step) {
  if (placed_[robot] || robots_[robot].posture != Posture::standing) return;
  const Pose2D drag = motors_[robot].noise.next(noise_, step);
  mjtNum* pose = data_->qpos + parts_[robot].poseAddress;
  const Vector2d way = rotated(drag.translation, robots_[robot].pose.rotation);
  for (int k = 0; k < 2; ++k) pose[k] += way[k] / 1000;
  const mjtNum up[3] = {0, 0, 1};
  mjtNum turn[4], turned[4];
  mju_axisAngle2Quat(turn, up, drag.rotation);
  mju_mulQuat(turned, turn, pose + 3);
  std::copy_n(turned, 4, pose + 3);
}

void DynamicWorld::holdRobots() {
  // A robot that was switched on is put down once its legs have reached their targets, even if it
  // was put elsewhere meanwhile; a robot that was thrown over lies.
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Motors& motors = motors_[i];
    JointAngles& angles = robots_[i].joints;
    if (robots_[i].posture != Posture::standing || time().ms >= heldMs) motors.rested = restTicks;
    if (motors.rested >= restTicks) continue;
    bool rests = true;
    for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
      Servo& servo = motors.servos[j];
      if (placed_[i]) servo.rest(angles.values[j]);  // its joints may have been turned by hand, too
      rests &= servo.atTarget() || !isOfLeg(static_cast<Joint>(j));
      angles.values[j] = servo.turnFreely(tickSeconds);
    }
    motors.rested = rests ? motors.rested + 1 : 0;
    placed_[i] = true;
  }
}

void DynamicWorld::putByHand() {
  bool any = false;
  for (std::size_t i = 0; i < robots_.size(); ++i)
    if (placed_[i]) {
      putRobot(i);
      any = true;
    }
  for (std::size_t i = 0; i < balls_.size(); ++i)
    if (placedBalls_[i]) {
      putBall(i);
      placedBalls_[i] = false;
      any = true;
    }
  if (!any) return;
  updateKinematics();
  goodPositions_.assign(data_->qpos, data_->qpos + model_->nq);
}

void DynamicWorld::putBall(std::size_t i) {
  const BallState& ball = balls_[i];
  writeBall(i);
  // The ball rolls. The turn of a free body is along its own axes.
  const Vector3d turn = Vector3d{-ball.speed.y(), ball.speed.x(), 0} / ballParts_[i].radius;
  const int body = ballParts_[i].body;
  mjtNum* speed = data_->qvel + model_->body_dofadr[body];
  Eigen::Map<Vector3d>{speed} = Vector3d{ball.speed.x(), ball.speed.y(), 0} / 1000;
  Eigen::Map<Vector3d>{speed + 3} = rotationFromMuJoCo(data_->xmat + 9 * body).transpose() * turn;
}

void DynamicWorld::putRobot(std::size_t i) {
  RobotBody& robot = robots_[i];
  const Lean lean = leanOf(robot.posture);
  robot.tilt = lean.tilt;
  robot.roll = lean.roll;
  writeRobot(i);
  updateKinematics();
  robot.height -= 1000 * (lowestPoint(i) + groundGap);
  writeRobot(i);
  std::fill_n(data_->qvel + motors_[i].firstDof, 6 + enumCount<Joint>, 0);
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    motors_[i].servos[j].rest(robot.joints.values[j]);
}

void DynamicWorld::putDown(std::size_t robot) {
  putRobot(robot);
  updateKinematics();
}

bool DynamicWorld::robotsOverlap(std::size_t a, std::size_t b) const {
  return std::ranges::any_of(motors_[a].solidGeoms, [&](int first) {
    return std::ranges::any_of(motors_[b].solidGeoms, [&](int second) {
      return geomsTouch(*this, first, second, -touching / 1000);
    });
  });
}

bool DynamicWorld::robotOverlapsField(std::size_t robot) const {
  return std::ranges::any_of(walls_, [&](int wall) {
    return wallIsNear(wall, robots_[robot].pose.translation, parts_[robot].reach) &&
           std::ranges::any_of(motors_[robot].solidGeoms, [&](int geom) {
             return geomsTouch(*this, geom, wall, -touching / 1000);
           });
  });
}

bool DynamicWorld::ballOverlapsRobot(std::size_t ball, std::size_t robot) const {
  return std::ranges::any_of(motors_[robot].solidGeoms, [&](int geom) {
    return geomsTouch(*this, geom, ballParts_[ball].geom, -touching / 1000);
  });
}

bool DynamicWorld::ballOverlapsField(std::size_t ball) const {
  return std::ranges::any_of(walls_, [&](int wall) {
    return wallIsNear(wall, balls_[ball].position, ballParts_[ball].radius) &&
           geomsTouch(*this, ballParts_[ball].geom, wall, -touching / 1000);
  });
}

double DynamicWorld::lowestPoint(std::size_t i) const {
  double lowest = std::numeric_limits<double>::max();
  for (int geom = parts_[i].firstGeom; geom < parts_[i].lastGeom; ++geom)
    if (model_->geom_contype[geom] != 0)
      lowest = std::min(lowest, data_->geom_xpos[3 * geom + 2] - reachDown(*model_, *data_, geom));
  return lowest;
}

Vector3d DynamicWorld::speedOf(std::size_t robot) const {
  return threeOf(data_->qvel + motors_[robot].firstDof);
}

void DynamicWorld::readRobot(std::size_t i) {
  RobotBody& robot = robots_[i];
  const RobotParts& parts = parts_[i];
  const Matrix3d rotation = rotationFromMuJoCo(data_->xmat + 9 * parts.body);
  const Vector3d origin = fromMuJoCo(data_->xpos + 3 * parts.body);
  const Vector2d before = robot.pose.translation;
  robot.pose = {std::atan2(rotation(1, 0), rotation(0, 0)), origin.head<2>()};
  robot.height = origin.z();
  robot.tilt = std::asin(std::clamp(rotation(2, 0), -1., 1.));
  robot.roll = std::atan2(rotation(2, 1), rotation(2, 2));
  if (!placed_[i]) robot.walked += (robot.pose.translation - before).norm();
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    robot.joints.values[j] = data_->qpos[parts.jointAddress.values[j]];
  robot.posture = postureOf(rotation);
  const Vector3d speed = speedOf(i);
  const Vector3d change = placed_[i] ? Vector3d{0, 0, 0} : Vector3d{speed - motors_[i].speed};
  motors_[i].speed = speed;
  const Vector3d felt = 1000 * (change / tickSeconds + Vector3d{0, 0, gravity});
  robot.specificForce = rotation.transpose() * felt;
}

void DynamicWorld::readBall(std::size_t i) {
  const mjtNum* position = data_->qpos + ballParts_[i].poseAddress;
  const mjtNum* speed = data_->qvel + model_->body_dofadr[ballParts_[i].body];
  balls_[i].position = {1000 * position[0], 1000 * position[1]};
  balls_[i].speed = {1000 * speed[0], 1000 * speed[1]};
}

void DynamicWorld::forgetContacts() {
  for (RobotBody& robot : robots_) {
    robot.footOnGround.fill(false);
    robot.pushes = -1;
    robot.blocked = false;
  }
}

void DynamicWorld::readContacts() {
  for (int n = 0; n < data_->ncon; ++n) {
    const mjContact& contact = data_->contact[n];
    touch(contact.geom1, contact.geom2);
    touch(contact.geom2, contact.geom1);
  }
}

void DynamicWorld::touch(int geom, int other) {
  const auto rootOf = [&](int g) {
    return static_cast<std::size_t>(model_->body_rootid[model_->geom_bodyid[g]]);
  };
  const int robot = robotOfBody_[rootOf(geom)];
  if (robot < 0) return;
  const auto i = static_cast<std::size_t>(robot);
  if (const int ball = ballOfBody_[rootOf(other)]; ball >= 0) {
    balls_[static_cast<std::size_t>(ball)].lastToucher = robot;
    balls_[static_cast<std::size_t>(ball)].lastTouched = time();
  } else if (model_->geom_type[other] != mjGEOM_PLANE)
    meet(i, robotOfBody_[rootOf(other)]);
  if (model_->geom_type[other] != mjGEOM_PLANE || model_->geom_type[geom] != mjGEOM_SPHERE) return;
  for (std::size_t leg = 0; leg < parts_[i].footSites.size(); ++leg)
    if (model_->geom_bodyid[geom] == model_->site_bodyid[parts_[i].footSites[leg]])
      robots_[i].footOnGround[leg] = true;
}

void DynamicWorld::meet(std::size_t robot, int other) {
  robots_[robot].blocked = true;
  if (other < 0) return;
  constexpr double walking = 0.02;  // m/s
  const Vector2d way =
      robots_[static_cast<std::size_t>(other)].pose.translation - robots_[robot].pose.translation;
  if (speedOf(robot).head<2>().dot(way) > walking * way.norm()) robots_[robot].pushes = other;
}

void DynamicWorld::undoIfBroken() {
  // MuJoCo resets to the model's pose when numbers diverge; then everything resumes from its last
  // good position, at rest.
  const auto coordinates = static_cast<std::size_t>(model_->nq);
  bool broken = false;
  for (const mjtWarning warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    broken |= data_->warning[warning].number > 0;
    data_->warning[warning].number = 0;
  }
  divergences_ += broken;
  if (broken && goodPositions_.size() == coordinates) {
    std::copy_n(goodPositions_.begin(), coordinates, data_->qpos);
    std::fill_n(data_->qvel, model_->nv, 0);
    std::fill_n(data_->qacc_warmstart, model_->nv, 0);
  }
  for (const RobotParts& parts : parts_) {
    slowDown(parts.poseAddress, parts.body);
    Eigen::Map<Vector3d> speed{data_->qvel + model_->body_dofadr[parts.body]};
    if (const double tooFast = speed.norm() / fastestRobot; tooFast > 1) speed /= tooFast;
  }
  for (const BallParts& ball : ballParts_) slowDown(ball.poseAddress, ball.body);
  goodPositions_.assign(data_->qpos, data_->qpos + coordinates);
}

void DynamicWorld::slowDown(int poseAddress, int body) {
  // A squeezed body is pushed out of the others, and may be shot across the field.
  mjtNum* speed = data_->qvel + model_->body_dofadr[body];
  const double tooFast =
      std::max(threeOf(speed).norm() / fastest, threeOf(speed + 3).norm() / widestTurn);
  if (tooFast <= 1) return;
  int dofs = 6;  // of the body, then one of each joint
  while (model_->body_dofadr[body] + dofs < model_->nv &&
         model_->body_rootid[model_->dof_bodyid[model_->body_dofadr[body] + dofs]] == body)
    ++dofs;
  std::fill_n(speed, dofs, 0);
  if (!goodPositions_.empty())
    std::copy_n(goodPositions_.begin() + poseAddress, dofs + 1, data_->qpos + poseAddress);
}

}  // namespace gt
