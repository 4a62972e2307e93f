#include "colortable/GameViews.h"

#include <algorithm>

namespace gt {

Result<GameViews> GameViews::make(const std::string& file, std::uint64_t seed) {
  auto scene = loadScene(file);
  if (!scene) return scene.error();
  auto world = makeWorld(*scene, Random{seed}.fork("world"));
  if (!world) return world.error();
  return GameViews{*std::move(scene), *std::move(world), seed};
}

GameViews::GameViews(SceneDescription scene, std::unique_ptr<World> world, std::uint64_t seed)
    : scene_(std::move(scene)),
      world_(std::move(world)),
      random_(Random{seed}.fork("views")),
      cameraScene_(std::make_unique<CameraScene>(world_->model())),
      renderer_(*cameraScene_),
      buffers_(world_->activeRobots()),
      commands_(world_->activeRobots()) {
  for (std::size_t i = 0; i < world_->activeRobots(); ++i)
    sensors_.emplace_back(scene_.noise, random_.fork("sensors" + std::to_string(i)));
}

void GameViews::shuffle() {
  const auto somewhere = [&](double x, double y) {
    return Vector2d{random_.uniform(-x, x), random_.uniform(-y, y)};
  };
  for (std::size_t i = 0; i < commands_.size(); ++i) {
    // Not too many robots on each other's toes: the world parts those.
    world_->placeRobot(i, {random_.uniform(-pi, pi), somewhere(1950, 1150)});
    JointAngles& joints = commands_[i].joints;
    const double fore = random_.uniform(-0.25, 0.1), foreKnee = random_.uniform(0.4, 1.0);
    const double hind = random_.uniform(-0.4, -0.1), hindKnee = random_.uniform(0.6, 1.1);
    for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
      joints[legJoint(leg, 1)] = isFore(leg) ? fore : hind;
      joints[legJoint(leg, 2)] = 0.1;
      joints[legJoint(leg, 3)] = isFore(leg) ? foreKnee : hindKnee;
    }
    joints[Joint::headTilt] = random_.uniform(-0.9, 0.25);
    joints[Joint::headPan] = random_.uniform(-1.5, 1.5);
  }
  // Most of the time the ball is of interest: close to one of the robots.
  const RobotBody& near = world_->robot(random_.index(commands_.size()));
  const Vector2d ball =
      random_.chance(0.5)
          ? Vector2d{near.pose * Vector2d{random_.uniform(150, 1200), random_.uniform(-500, 500)}}
          : somewhere(2000, 1250);
  world_->placeBall(0,
                    {std::clamp(ball.x(), -2050.0, 2050.0), std::clamp(ball.y(), -1300.0, 1300.0)});
  // Heads are still on their way in some of the pictures.
  const std::size_t ticks = SensorDataBuffer::capacity + random_.index(40);
  for (std::size_t t = 0; t < ticks; ++t) step();
}

void GameViews::step() {
  world_->step(commands_);
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
  const CameraView camera = cameraView(*world_, robot, CameraInfo{});
  renderer_.render(world_->data(), camera, effects, random_(), view_.image, &view_.truth);
  view_.image.time = world_->time();
  const Pose2D& pose = world_->robot(robot).pose;
  const Pose3D origin{rotationZ(pose.rotation), {pose.translation.x(), pose.translation.y(), 0}};
  const Pose3D between{Eigen::Quaterniond(camera.first.rotation)
                           .slerp(0.5, Eigen::Quaterniond(camera.last.rotation))
                           .toRotationMatrix(),
                       (camera.first.translation + camera.last.translation) / 2};
  view_.camera = origin.inverse() * between;
  return view_;
}

}  // namespace gt
