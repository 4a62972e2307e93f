#include "simulation/world/World.h"

#include <algorithm>
#include <cmath>

#include "simulation/scene/SceneModel.h"
#include "simulation/world/DynamicWorld.h"
#include "simulation/world/KinematicWorld.h"

namespace gt {

Lean leanOf(Posture posture) {
  switch (posture) {
    case Posture::onLeftSide:
      return {0, -pi / 2};
    case Posture::onRightSide:
      return {0, pi / 2};
    case Posture::onNose:
      return {fromDegrees(-60), 0};
    case Posture::onBack:
      return {0, pi};
    case Posture::sitting:
      return {fromDegrees(35), 0};
    default:
      return {};
  }
}

Posture postureOf(const Matrix3d& rotation) {
  constexpr double lying = 0.5;    // share of the body's z axis that points up, or down
  constexpr double leaning = 0.6;  // rad, of the body's x axis against the ground
  const double x = rotation(2, 0), y = rotation(2, 1), z = rotation(2, 2);
  if (z < -lying) return Posture::onBack;
  if (std::abs(x) > std::sin(leaning) && std::abs(x) > std::abs(y))
    return x > 0 ? Posture::sitting : Posture::onNose;
  if (z > lying) return Posture::standing;
  return y > 0 ? Posture::onRightSide : Posture::onLeftSide;
}

Pose2D possibleStep(const Pose2D& step) {
  constexpr double longest = 8, widestTurn = 0.1;
  if (!std::isfinite(step.rotation) || !step.translation.allFinite()) return {};
  Pose2D result{std::clamp(step.rotation, -widestTurn, widestTurn), step.translation};
  if (const double length = step.translation.norm(); length > longest)
    result.translation *= longest / length;
  return result;
}

Pose3D RobotBody::origin() const {
  Pose3D origin;
  origin.translation = {pose.translation.x(), pose.translation.y(), height};
  origin.rotation = rotationZ(pose.rotation) * rotationY(-tilt) * rotationX(roll);
  return origin;
}

World::World(const SceneDescription& scene, Model model)
    : model_(std::move(model)),
      data_(makeData(*model_)),
      active_(scene.robots.size()),
      fastestBall_(scene.physics.maxSpeed) {
  updateKinematics();
  obstacles_ = Obstacles{*model_, *data_};
  for (const SceneRobot* robot : scene.allRobots()) robots_.emplace_back().pose = robot->pose();
  for (const SceneBall& ball : scene.balls) balls_.emplace_back().position = ball.position();
  placed_.resize(robots_.size(), true);
  placedBalls_.resize(balls_.size(), true);
  robotCounts_.resize(robots_.size(), true);
  ballCounts_.resize(balls_.size(), true);
  puts_.reserve(robots_.size() + balls_.size() + 1);
  cameras_.resize(robots_.size());
  emission_.assign(model_->light_diffuse, model_->light_diffuse + 3 * model_->nlight);
  shares_.assign(static_cast<std::size_t>(model_->nlight), 1);
}

Result<void> World::findParts(const SceneDescription& scene) {
  for (const SceneRobot* robot : scene.allRobots()) {
    const auto parts = findRobotParts(*model_, robot->name, scene.resolve(robot->model));
    if (!parts) return parts.error();
    parts_.push_back(*parts);
  }
  for (std::size_t i = 0; i < scene.balls.size(); ++i) {
    const auto parts = findBallParts(*model_, i, scene.resolve(scene.balls[i].model));
    if (!parts) return parts.error();
    ballParts_.push_back(*parts);
  }
  return {};
}

const Pose3D& World::camera(std::size_t robot, std::size_t ticksAgo) const {
  return cameras_[robot][std::min(ticksAgo, cameraHistory - 1)];
}

void World::moveJoint(int joint, std::span<const double> coordinates) {
  std::copy(coordinates.begin(), coordinates.end(), data_->qpos + model_->jnt_qposadr[joint]);
  const int dofs = model_->jnt_type[joint] == mjJNT_FREE ? 6 : 1;
  std::fill_n(data_->qvel + model_->jnt_dofadr[joint], dofs, 0);
  updateKinematics();
}

void World::moveGeom(int geom, const Vector3d& position) {
  const int body = model_->geom_bodyid[geom];
  const Matrix3d rotation = rotationFromMuJoCo(data_->xmat + 9 * body);
  const Vector3d local = rotation.transpose() * (position - fromMuJoCo(data_->xpos + 3 * body));
  for (int k = 0; k < 3; ++k) model_->geom_pos[3 * geom + k] = local[k] / 1000;
  model_->geom_sameframe[geom] = 0;  // no longer where its body's frame or middle is
  updateKinematics();
  obstacles_ = Obstacles{*model_, *data_};
}

void World::emit(int light, double share) {
  share = std::clamp(share, 0., 1.);
  shares_[static_cast<std::size_t>(light)] = share;
  for (int k = 3 * light; k < 3 * light + 3; ++k)
    model_->light_diffuse[k] = static_cast<float>(share) * emission_[static_cast<std::size_t>(k)];
}

void World::setAmbient(const Vector3d& rgb) {
  for (int k = 0; k < 3; ++k)
    model_->vis.headlight.ambient[k] = static_cast<float>(std::clamp(rgb[k], 0., 1.));
}

void World::measureSensors() {
  mj_comPos(model_.get(), data_.get());
  mj_camlight(model_.get(), data_.get());
  mj_sensorPos(model_.get(), data_.get());
}

void World::change(const SceneDescription& scene) {
  fastestBall_ = scene.physics.maxSpeed;
}

void World::continueFrom(const World& other) {
  robots_ = other.robots_;
  balls_ = other.balls_;
  time_ = other.time_;
  cameras_ = other.cameras_;
  std::fill(placed_.begin(), placed_.end(), true);
  std::fill(placedBalls_.begin(), placedBalls_.end(), true);
  std::copy_n(other.model_->geom_pos, 3 * model_->ngeom, model_->geom_pos);
  std::copy_n(other.model_->geom_sameframe, model_->ngeom, model_->geom_sameframe);
  std::copy_n(other.data_->qpos, model_->nq, data_->qpos);
  for (int light = 0; light < model_->nlight; ++light) emit(light, other.emission(light));
  const float* ambient = other.model_->vis.headlight.ambient;
  setAmbient({ambient[0], ambient[1], ambient[2]});
  updateKinematics();
  // Subclasses that store data about immobile geoms update them.
  if (model_->ngeom > 0) moveGeom(0, fromMuJoCo(data_->geom_xpos));
  putAll();
}

bool geomsTouch(const World& world, int a, int b, double gap) {
  const mjModel& model = world.model();
  const mjData& data = world.data();
  if (model.geom_type[a] > model.geom_type[b]) std::swap(a, b);
  const mjfCollision collide = mjCOLLISIONFUNC[model.geom_type[a]][model.geom_type[b]];
  if (!collide) return false;
  const bool bounded = model.geom_rbound[a] > 0 && model.geom_rbound[b] > 0;  // no planes
  const double reach = model.geom_rbound[a] + model.geom_rbound[b] + std::max(gap, 0.);
  mjtNum between[3];
  mju_sub3(between, data.geom_xpos + 3 * a, data.geom_xpos + 3 * b);
  if (bounded && mju_dot3(between, between) > reach * reach) return false;
  mjContact contacts[mjMAXCONPAIR];
  const int count = collide(&model, &data, contacts, a, b, std::max(gap, 0.));
  return std::any_of(contacts, contacts + count,
                     [&](const mjContact& contact) { return contact.dist < gap; });
}

void World::writeRobot(std::size_t i) {
  const RobotBody& robot = robots_[i];
  const Pose3D origin = robot.origin();
  const Eigen::Quaterniond q{origin.rotation};
  mjtNum* pose = data_->qpos + parts_[i].poseAddress;
  for (int k = 0; k < 3; ++k) pose[k] = origin.translation[k] / 1000;
  pose[3] = q.w();
  pose[4] = q.x();
  pose[5] = q.y();
  pose[6] = q.z();
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    data_->qpos[parts_[i].jointAddress.values[j]] = robot.joints.values[j];
}

void World::writeBall(std::size_t i) {
  const BallParts& parts = ballParts_[i];
  mjtNum* pose = data_->qpos + parts.poseAddress;
  pose[0] = balls_[i].position.x() / 1000;
  pose[1] = balls_[i].position.y() / 1000;
  pose[2] = parts.radius / 1000;
  // The poses of the ball's geoms are updated at once, since it moves after the robots in a tick.
  mju_copy3(data_->xpos + 3 * parts.body, pose);
  mju_quat2Mat(data_->xmat + 9 * parts.body, pose + 3);
  const auto [first, last] = geomsBelow(*model_, parts.body);
  for (int geom = first; geom < last; ++geom)
    mj_local2Global(data_.get(), data_->geom_xpos + 3 * geom, data_->geom_xmat + 9 * geom,
                    model_->geom_pos + 3 * geom, model_->geom_quat + 4 * geom, parts.body, 0);
}

void World::updateKinematics() {
  mj_kinematics(model_.get(), data_.get());
}

void World::advanceTime() {
  puts_.clear();
  time_ = time_ + tickMs;
  data_->time = static_cast<double>(time_.ms) / 1000;
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    auto& history = cameras_[i];
    const Pose3D now = sitePose(*data_, parts_[i].cameraSite);
    if (placed_[i])
      history.fill(now);
    else {
      std::copy_backward(history.begin(), history.end() - 1, history.end());
      history.front() = now;
    }
    placed_[i] = false;
  }
}

Result<std::unique_ptr<World>> makeWorld(const SceneDescription& scene, const Random& random) {
  auto model = composeModel(scene, random.fork("audience"));
  if (!model) return model.error();
  return makeWorld(scene, std::move(*model), random);
}

Result<std::unique_ptr<World>> makeWorld(const SceneDescription& scene, Model model,
                                         const Random& random) {
  if (scene.fidelity == Fidelity::dynamic)
    return DynamicWorld::make(scene, std::move(model), random);
  return KinematicWorld::make(scene, std::move(model), random);
}

}  // namespace gt
