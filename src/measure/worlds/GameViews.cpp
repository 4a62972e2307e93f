#include "measure/worlds/GameViews.h"

#include <algorithm>

namespace gt {

CameraMatrix trueMatrix(const CameraView& camera, const Pose2D& robot) {
  const Pose3D origin{rotationZ(robot.rotation), {robot.translation.x(), robot.translation.y(), 0}};
  const Eigen::AngleAxisd turn{camera.last.rotation * camera.first.rotation.transpose()};
  const Matrix3d halfway = Eigen::AngleAxisd{turn.angle() / 2, turn.axis()} * camera.first.rotation;
  CameraMatrix matrix;
  matrix.info = camera.info;
  matrix.pose =
      origin.inverse() * Pose3D{halfway, (camera.first.translation + camera.last.translation) / 2};
  const double seconds = (camera.info.height - 1) * camera.info.rowTime / 1000;
  matrix.turning = origin.rotation.transpose() * turn.axis() * turn.angle() / seconds;
  matrix.valid = true;
  return matrix;
}

Result<GameViews> GameViews::make(const SceneDescription& scene, std::uint64_t seed) {
  auto world = makeWorld(scene, Random{seed}.fork("world"));
  if (!world) return world.error();
  return GameViews{scene, *std::move(world), seed};
}

GameViews::GameViews(SceneDescription scene, std::unique_ptr<World> world, std::uint64_t seed)
    : scene_(std::move(scene)),
      world_(std::move(world)),
      random_(Random{seed}.fork("views")),
      cameraScene_(std::make_unique<CameraScene>(world_->model())),
      renderer_(*cameraScene_),
      buffers_(world_->activeRobots()),
      commands_(world_->activeRobots()) {
  for (std::size_t i = 0; i < world_->activeRobots(); ++i) {
    const std::string number = std::to_string(i);
    sensors_.emplace_back(
        scene_.noise, random_.fork("sensors" + number),
        RobotBuild::draw(scene_.body, scene_.robots[i], random_.fork("build" + number)));
    delays_.push_back(random_.fork("delays" + number));
  }
  driven_ = commands_;
}

Vector2d GameViews::somewhere(double x, double y) {
  return {random_.uniform(-x, x), random_.uniform(-y, y)};
}

void GameViews::placeRobot(std::size_t robot) {
  // Not too many robots on each other's toes: the world parts those.
  world_->placeRobot(robot, {random_.uniform(-pi, pi), somewhere(1950, 1150)});
  if (robot >= commands_.size()) return;
  JointAngles& joints = commands_[robot].joints;
  const double fore = random_.uniform(-0.25, 0.1), foreKnee = random_.uniform(0.4, 1.0);
  const double hind = random_.uniform(-0.4, -0.1), hindKnee = random_.uniform(0.6, 1.1);
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    joints[legJoint(leg, 1)] = isFore(leg) ? fore : hind;
    joints[legJoint(leg, 2)] = 0.1;
    joints[legJoint(leg, 3)] = isFore(leg) ? foreKnee : hindKnee;
  }
  joints[Joint::headTilt] = random_.uniform(-0.9, 0.25);
  joints[Joint::headPan] = random_.uniform(-1.5, 1.5);
  const bool walks = random_.chance(0.5);
  constexpr double mostSpeed = 200, mostTurning = 1;  // mm/s, rad/s
  const Vector2d speed = somewhere(mostSpeed, mostSpeed);
  const double turning = random_.uniform(-mostTurning, mostTurning);
  commands_[robot].step = walks ? Pose2D{turning * tickSeconds, speed * tickSeconds} : Pose2D{};
}

// Most of the time the ball is of interest: close to one of the robots.
void GameViews::placeBall() {
  const RobotBody& near = world_->robot(random_.index(commands_.size()));
  const Vector2d ball =
      random_.chance(0.5)
          ? Vector2d{near.pose * Vector2d{random_.uniform(150, 1200), random_.uniform(-500, 500)}}
          : somewhere(2000, 1250);
  world_->placeBall(0,
                    {std::clamp(ball.x(), -2050.0, 2050.0), std::clamp(ball.y(), -1300.0, 1300.0)});
}

// Legs stand anywhere; a leg's own height stays.
void GameViews::placeReferees() {
  const mjModel& model = world_->model();
  for (int i = 0; i < scene_.referees; ++i) {
    const Vector2d at = somewhere(1950, 1200), apart = direction(random_.uniform(-pi, pi)) * 110;
    for (const bool left : {true, false}) {
      const std::string name = "referee" + std::to_string(i) + (left ? "/left" : "/right");
      const int geom = mj_name2id(&model, mjOBJ_GEOM, name.c_str());
      const Vector2d leg = left ? Vector2d{at + apart} : Vector2d{at - apart};
      world_->moveGeom(geom, {leg.x(), leg.y(), 1000 * model.geom_pos[3 * geom + 2]});
    }
  }
}

void GameViews::shuffle() {
  placeReferees();
  for (std::size_t i = 0; i < world_->robotCount(); ++i) placeRobot(i);
  placeBall();
  // Heads are still on their way in some of the images.
  const std::size_t ticks = SensorDataBuffer::capacity + random_.index(40);
  for (std::size_t t = 0; t < ticks; ++t) step();
}

void GameViews::step() {
  for (std::size_t i = 0; i < commands_.size(); ++i)
    driven_[i] = {sensors_[i].build().driven(commands_[i].joints), commands_[i].step};
  world_->step(driven_);
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    SensorData readings;
    sensors_[i].read(*world_, i, readings);
    readings.time = world_->time();
    buffers_[i].push(readings);
  }
}

const GameView& GameViews::look(std::size_t robot, const CameraEffects& effects) {
  view_.robot = robot;
  view_.sensors = buffers_[robot];
  view_.step = commands_[robot].step;
  const RobotBuild& build = sensors_[robot].build();
  double delay = effects.delay;
  if (effects.delayJitter > 0) delay += effects.delayJitter * delays_[robot].gaussian();
  const CameraView camera =
      build.leaning(cameraView(*world_, robot, scene_.optics,
                               std::clamp(delay, 0.0, CameraEffects::longestDelay)),
                    world_->robot(robot));
  renderer_.render(world_->data(), camera, build.seen(effects.at(world_->time())), random_(),
                   view_.image, &view_.truth);
  view_.image.time = world_->time();
  view_.camera = trueMatrix(camera, world_->robot(robot).pose);
  view_.camera.time = world_->time();
  return view_;
}

}  // namespace gt
