#include "simulation/Simulation.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>

#include "base/Guarded.h"
#include "base/Hash.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/scene/SceneModel.h"
#include "simulation/world/Oracle.h"
#include "streams/Config.h"

namespace gt {
namespace {

std::vector<Player> playersOf(const SceneDescription& scene) {
  std::vector<Player> players;
  for (const SceneRobot* robot : scene.allRobots()) players.push_back(robot->player());
  return players;
}

}  // namespace

CameraView cameraView(const World& world, std::size_t robot, const CameraInfo& info, double delay) {
  const auto poseAgo = [&](double milliseconds) {
    const double ticks = milliseconds / static_cast<double>(tickMs);
    const auto whole = static_cast<std::size_t>(ticks);
    return interpolated(world.camera(robot, whole), world.camera(robot, whole + 1),
                        ticks - static_cast<double>(whole));
  };
  CameraView view;
  view.info = info;
  view.first = poseAgo((info.height - 1) * info.rowTime + delay);
  view.last = delay > 0 ? poseAgo(delay) : world.camera(robot);
  view.hiddenBody = world.parts(robot).headBody;
  return view;
}

Simulation::Simulation(const SceneDescription& scene, std::unique_ptr<World> world,
                       const Random& random, std::size_t threads, const FieldDimensions& field)
    : scene_(scene),
      players_(playersOf(scene)),
      random_(random),
      world_(std::move(world)),
      referee_(scene.game, scene.rules, field, players_),
      radio_(scene.radio, players_, random.fork("radio")),
      actuators_(*world_),
      fieldSensors_(*world_, random.fork("field sensors")),
      commands_(scene.robots.size()),
      pool_(threads) {
  prepareCameras();
  if (scene.ceilingCamera)
    ceilingCamera_.emplace(*scene.ceilingCamera, players_, random.fork("ceiling camera"));
  for (std::size_t i = 0; i < scene.robots.size(); ++i) {
    const std::string& name = scene.robots[i].name;
    robots_.push_back({nullptr,
                       Sensors{scene.noise, random.fork("sensors " + name), buildOf(i)},
                       nullptr,
                       true,
                       random.fork("pictures " + name),
                       scene.camera,
                       {},
                       {},
                       {},
                       {},
                       random.fork("delays " + name)});
    order_.push_back(i);
  }
}

Result<std::unique_ptr<Simulation>> Simulation::make(const SceneDescription& scene,
                                                     std::uint64_t seed, std::size_t threads,
                                                     const FieldDimensions& field) {
  std::vector<Error> warnings;
  auto model = composeModel(scene, Random{seed}.fork("world").fork("audience"), &warnings);
  if (!model) return model.error();
  auto simulation = make(scene, std::move(*model), seed, threads, field);
  if (simulation) (*simulation)->modelWarnings_ = std::move(warnings);
  return simulation;
}

Result<std::unique_ptr<Simulation>> Simulation::make(const SceneDescription& scene, Model model,
                                                     std::uint64_t seed, std::size_t threads,
                                                     const FieldDimensions& field) {
  const Random random{seed};
  auto world = makeWorld(scene, std::move(model), random.fork("world"));
  if (!world) return world.error();
  if (auto done = checkFieldSensors((*world)->model(), scene.resolve(scene.field)); !done)
    return done.error();
  const auto kicks = std::make_shared<KickTable>();
  const std::string table = scene.resolve(scene.config) + "/kicks.cfg";
  if (std::filesystem::exists(table))
    if (auto read = readConfig(table, *kicks); !read) return read.error();
  std::unique_ptr<Simulation> simulation{
      new Simulation{scene, std::move(*world), random, threads, field}};
  for (Hardware& robot : simulation->robots_) robot.kicks = kicks;
  return simulation;
}

void Simulation::prepareCameras() {
  renderers_.clear();
  cameraScene_ = std::make_unique<CameraScene>(world_->model());
  for (std::size_t i = 0; i < pool_.threads(); ++i) renderers_.emplace_back(*cameraScene_);
}

Result<void> Simulation::changeFidelity(Fidelity fidelity) {
  if (fidelity == scene_.fidelity) return {};
  SceneDescription changed = scene_;
  changed.fidelity = fidelity;
  auto world = makeWorld(changed, random_.fork("world"));
  if (!world) return world.error();
  (*world)->continueFrom(*world_);
  world_ = std::move(*world);
  scene_.fidelity = fidelity;
  prepareCameras();
  return {};
}

RobotBuild Simulation::buildOf(std::size_t robot) const {
  const SceneRobot& setup = scene_.robots[robot];
  return RobotBuild::draw(scene_.body, setup, random_.fork("build " + setup.name));
}

void Simulation::change(const SceneDescription& scene) {
  scene_.profile = scene.profile;
  scene_.noise = scene.noise;
  scene_.body = scene.body;
  scene_.walking = scene.walking;
  scene_.dynamics = scene.dynamics;
  scene_.physics = scene.physics;
  scene_.radio = scene.radio;
  const bool sameCamera = scene_.camera == scene.camera;
  scene_.camera = scene.camera;
  world_->change(scene_);
  radio_.change(scene_.radio);
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i].sensors.change(scene_.noise, buildOf(i));
    if (!sameCamera) setCamera(i, robots_[i].settings);
  }
}

void Simulation::attach(std::size_t robot, std::unique_ptr<RobotController> controller) {
  robots_[robot].controller = std::move(controller);
}

void Simulation::takeImages(std::size_t robot, bool on) {
  if (!on) robots_[robot].image = image(robot);
  robots_[robot].cameraOn = on;
}

const Image& Simulation::image(std::size_t robot) const {
  const Hardware& r = robots_[robot];
  const Image* own = r.controller ? r.controller->lastImage() : nullptr;
  return own ? *own : r.image;
}

void Simulation::keepTruth(std::size_t robot) {
  if (!robots_[robot].truth) robots_[robot].truth = std::make_unique<ImageTruth>();
}

const ImageTruth* Simulation::truth(std::size_t robot) const {
  const ImageTruth* kept = robots_[robot].truth.get();
  return kept && !kept->classes.empty() ? kept : nullptr;
}

namespace {

/// Calls a robot's controller. If the controller throws, the error is noted, its robot stays as it
/// stood, and the other robots continue.
template <typename Hardware, typename Work>
void let(Hardware& robot, Work&& work) {
  if (!robot.controller || !robot.failure.empty()) return;
  try {
    work();
  } catch (const std::exception& exception) {
    robot.failure = "its program failed: " + errorOf(exception).text();
  } catch (...) {
    robot.failure = "its program failed";
  }
}

}  // namespace

void Simulation::step() {
  {
    const Stopwatch::Lap lap{worldTime_};
    for (const auto& controller : sceneControllers_) controller->control(*this);
    actuators_.step(*world_);
    world_->step(commands_);
    actuators_.hold(*world_);
    referee_.update(*world_);
    fieldSensors_.step(*world_, *cameraScene_);
    lookFromTheCeiling();
  }
  const bool imageDue = takeImages_ && tick_ % ticksPerImage == 0;
  if (imageDue) orderByWork();
  pool_.forEach(robots_.size(), [&](std::size_t i, std::size_t worker) {
    run(order_[i], imageDue ? &renderers_[worker] : nullptr);
  });
  for (Hardware& r : robots_) let(r, [&] { r.controller->finish(r.output); });
  act();
  ++tick_;
}

void Simulation::orderByWork() {
  if (pool_.threads() > 1)
    std::ranges::sort(order_, std::greater{},
                      [this](std::size_t robot) { return robots_[robot].imageTime.lastMs; });
}

void Simulation::run(std::size_t robot, CameraRenderer* renderer) {
  Hardware& r = robots_[robot];
  std::optional<Stopwatch::Lap> lap;
  if (renderer) lap.emplace(r.imageTime);
  r.input.image = nullptr;
  r.output.message.reset();
  r.output.camera.reset();
  if (!r.controller || !r.failure.empty()) return;
  sense(robot);
  if (renderer) takeImage(robot, *renderer);
  let(r, [&] { r.controller->cycle(r.input, r.output); });
}

void Simulation::lookFromTheCeiling() {
  if (ceilingCamera_ && ceilingCamera_->look(*world_, ceilingPercept_))
    ceilingTracker_.update(ceilingPercept_);
}

void Simulation::sense(std::size_t robot) {
  Hardware& r = robots_[robot];
  const Stopwatch::Lap lap{r.sensorTime};
  SensorData readings;
  r.sensors.read(*world_, robot, readings);
  const bool first = r.input.now == Time{};  // no past yet: as if it had always been like this
  if (first) r.input.sensors.frames.fill(readings);
  r.input.sensors.push(readings);
  r.input.now = world_->time();
  r.input.game = referee_.dataFor(robot);
  radio_.receive(robot, r.input.now, r.input.team);
  const Player& player = players_[robot];
  const bool measured =
      ceilingCamera_ && ceilingCamera_->parameters().oracle &&
      ceilingTracker_.fill(player.teamColor, player.number(), r.input.now, r.input.oracle);
  if (!measured) askOracle(*world_, players_, robot, r.input.oracle);
}

void Simulation::takeImage(std::size_t robot, CameraRenderer& renderer) {
  Hardware& r = robots_[robot];
  const Stopwatch::Lap lap{r.cameraTime};
  Image* const place = r.controller->nextImage();
  Image& image = place ? *place : r.image;
  if (r.cameraOn) {
    takeImage(robot, renderer, image, r.truth.get());
  } else {
    if (r.image.pixels.empty()) {
      r.image.info = scene_.optics;
      r.image.allocate();
    }
    if (place) image = r.image;
  }
  image.time = r.input.now;
  r.input.image = &image;
}

void Simulation::takeImage(std::size_t robot, CameraRenderer& renderer, Image& image,
                           ImageTruth* truth) {
  Hardware& r = robots_[robot];
  r.view = viewOf(robot);
  const CameraEffects effects = r.sensors.build().seen(r.camera.at(time()));
  renderer.render(world_->data(), r.view, effects, r.imageSeeds(), image, truth);
  image.time = time();
}

CameraView Simulation::viewOf(std::size_t robot) {
  Hardware& r = robots_[robot];
  double delay = r.camera.delay;
  if (r.camera.delayJitter > 0) delay += r.camera.delayJitter * r.delays.gaussian();
  delay = std::clamp(delay, 0.0, CameraEffects::longestDelay);
  return r.sensors.build().leaning(cameraView(*world_, robot, scene_.optics, delay),
                                   world_->robot(robot));
}

void Simulation::command(std::size_t robot, const RobotCommand& command) {
  const auto ticks =
      static_cast<std::size_t>(std::lround(scene_.body.commandDelay / static_cast<double>(tickMs)));
  Hardware& r = robots_[robot];
  r.due[r.commands % mostDue] = command;
  if (r.commands >= ticks) commands_[robot] = r.due[(r.commands - ticks) % mostDue];
  ++r.commands;
}

void Simulation::act() {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    Hardware& r = robots_[i];
    if (!r.controller) continue;
    command(i, {r.sensors.build().driven(r.output.joints.angles),
                r.output.odometry.pose.relativeTo(r.odometry),
                r.kicks->kickOf(r.output.specialAction), r.output.gains});
    r.odometry = r.output.odometry.pose;
    if (r.output.message) radio_.send(i, *r.output.message, world_->time());
    if (r.output.camera) setCamera(i, *r.output.camera);
  }
}

std::uint64_t Simulation::fingerprint() const {
  Fingerprint sum;
  const mjModel& model = world_->model();
  const mjData& data = world_->data();
  sum.add(data.qpos, static_cast<std::size_t>(model.nq));
  sum.add(data.qvel, static_cast<std::size_t>(model.nv));
  for (std::size_t i = 0; i < world_->ballCount(); ++i) {
    sum.add(world_->ball(i).position.data(), 2);
    sum.add(world_->ball(i).speed.data(), 2);
  }
  for (const TeamColor team : {TeamColor::red, TeamColor::blue})
    sum.add(static_cast<double>(referee_.score(team)));
  sum.add(static_cast<double>(referee_.state()));
  sum.add(static_cast<double>(time().ms));
  sum.add(static_cast<double>(radio_.lost()));
  for (const Hardware& robot : robots_) {
    const SensorData& sensors = robot.input.sensors.newest();
    sum.add(sensors.joints.values.data(), enumCount<Joint>);
    sum.add(sensors.acceleration.data(), 3);
    sum.add(sensors.psd);
    sum.add(robot.output.joints.angles.values.data(), enumCount<Joint>);
    sum.add(robot.output.odometry.pose.rotation);
    sum.add(robot.output.odometry.pose.translation.data(), 2);
  }
  return sum.value();
}

std::vector<const Stopwatch*> Simulation::times() const {
  std::vector<const Stopwatch*> times{&worldTime_};
  for (const Hardware& robot : robots_) {
    times.push_back(&robot.sensorTime);
    times.push_back(&robot.cameraTime);
  }
  return times;
}

}  // namespace gt
