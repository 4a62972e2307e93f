#include "measure/worlds/SimulatedWalker.h"

#include <algorithm>
#include <cmath>

#include "colors/ColorTableFile.h"
#include "measure/worlds/GameViews.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "modules/perception/processors/DefaultSensorDataProcessor.h"
#include "modules/perception/processors/GT2003ImageProcessor.h"
#include "simulation/scene/ProfileTable.h"
#include "streams/Config.h"

namespace gt {

/// The robot's program: walks as requested, turns the head, looks at images.
class SimulatedWalker::Body : public RobotController {
 public:
  Body(ColorTable64 colors, const InvKinWalkingEngine::Parameters& walk,
       const DefaultSensorDataProcessor::Parameters& sensors, const WalkerWorld& world)
      : colors_{std::move(colors)}, walkType_{world.walkType} {
    engine_.parameters = walk;
    sensorDataProcessor_.parameters = sensors;
  }

  void cycle(const RobotInput& input, RobotOutput& output) override {
    if (input.image) look(input);
    MotionRequest request;
    request.type = moves_ ? MotionType::walk : MotionType::stand;
    request.walkType = walkType_;
    request.walk = speed_;
    engine_.update({input.now}, request, {}, {}, {motion_}, walk_);
    motion_.executed = request;
    output.joints = walk_.joints;
    setHead(input.now, output.joints.angles);
    odometry.pose = odometry.pose * walk_.odometryStep;
    output.odometry = odometry;
  }

  void order(const Pose2D& speed) {
    speed_ = speed;
    moves_ = speed.translation.norm() + 200 * std::abs(speed.rotation) > 1;
  }

  OdometryData odometry;
  LandmarksPercept landmarks;
  LinesPercept lines;
  CameraMatrix matrix;

 private:
  void look(const RobotInput& input) {
    sensorDataProcessor_.update({input.now}, input.sensors, *input.image, RobotDimensions{},
                                RobotCalibration{}, FieldDimensions{}, motion_, odometry,
                                Previous<BallPercept>{ball_}, Previous<LandmarksPercept>{landmarks},
                                matrix, body_, psd_, learned_);
    imageProcessor_.update(*input.image, matrix, colors_, FieldDimensions{},
                           {ball_, landmarks, lines, players_, obstacles_}, debug_);
  }
  /// From left to right and back.
  static void setHead(Time now, JointAngles& angles) {
    constexpr double widest = 85 * pi / 180, speed = 2, tilt = -0.3;  // rad, rad/s
    const double phase = std::fmod(static_cast<double>(now.ms) / 1000 * speed / (4 * widest), 1);
    angles[Joint::headPan] = widest * (phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase);
    angles[Joint::headTilt] = tilt;
    angles[Joint::headRoll] = 0;
  }

  ColorTable64 colors_;
  InvKinWalkingEngine engine_;
  WalkingEngineOutput walk_;
  MotionInfo motion_;
  WalkType walkType_;
  Pose2D speed_;
  bool moves_ = false;
  DefaultSensorDataProcessor sensorDataProcessor_;
  GT2003ImageProcessor imageProcessor_;
  BodyPercept body_;
  PsdPercept psd_;
  LearnedCalibration learned_;
  BallPercept ball_;
  PlayersPercept players_;
  ObstaclesPercept obstacles_;
  Debug debug_{1024};
};

Result<std::unique_ptr<SimulatedWalker>> SimulatedWalker::make(const DataRoot& root,
                                                               std::uint64_t seed,
                                                               const WalkerWorld& world) {
  auto scene = loadScene(root.path("scenes/match.scene"));
  if (!scene) return scene.error();
  auto colors = readColorTable(root.path("config/coltable.c64"));
  if (!colors) return colors.error();
  InvKinWalkingEngine::Parameters walk;
  if (auto read = readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), walk); !read)
    return read.error();
  DefaultSensorDataProcessor::Parameters sensors;
  const std::string learned = root.path("config/modules/SensorDataProcessor.Default.cfg");
  if (world.legsOnly)
    sensors.lean.learns = false;
  else if (auto read = readConfig(learned, sensors); !read)
    return read.error();
  setProfile(*scene, world.profile);
  if (world.change) world.change(*scene);
  scene->noise.slip = std::max(world.slip, scene->noise.slip);
  scene->noise.motion = std::max(world.motion, scene->noise.motion);
  scene->flags = world.flags;
  scene->game.referee = false;
  scene->robots.resize(1 + std::min(world.others, scene->robots.size() - 1));
  scene->balls.clear();
  auto simulation = Simulation::make(*scene, seed);
  if (!simulation) return simulation.error();
  std::unique_ptr<SimulatedWalker> walker{new SimulatedWalker{seed, world}};
  walker->simulation_ = *std::move(simulation);
  walker->player.teamColor = walker->simulation_->players()[0].teamColor;
  auto body = std::make_unique<Body>(*std::move(colors), walk, sensors, world);
  walker->body_ = body.get();
  walker->simulation_->attach(0, std::move(body));
  walker->placeFlags();
  walker->kidnap();
  return walker;
}

SimulatedWalker::SimulatedWalker(std::uint64_t seed, const WalkerWorld& world)
    : world_{world}, random_{Random{seed}.fork("walker")} {}

SimulatedWalker::~SimulatedWalker() = default;

Pose2D SimulatedWalker::placeOnField() {
  const double x = (field.xGroundline - 350) * random_.symmetric();
  const double y = (field.ySideline - 250) * random_.symmetric();
  return {pi * random_.symmetric(), x, y};
}

void SimulatedWalker::kidnap() {
  // In its own team's coordinates; the world's are those of the red team.
  const Pose2D place = placeOnField();
  simulation_->world().placeRobot(0, place);
  goal_ = chooseGoal();
}

bool SimulatedWalker::hasFallen() const {
  return simulation_->world().robot(0).posture != Posture::standing;
}

Vector2d SimulatedWalker::chooseGoal() {
  Vector2d goal = placeOnField().translation;
  if (!world_.leansOnWalls || random_.chance(0.5)) return goal;
  constexpr double beyond = 600;  // mm
  if (random_.chance(0.5))
    goal.x() = std::copysign(field.xGroundline + beyond, goal.x());
  else
    goal.y() = std::copysign(field.ySideline + beyond, goal.y());
  return goal;
}

void SimulatedWalker::placeFlags() {
  if (!world_.flags) return;
  World& simulated = simulation_->world();
  for (std::size_t i = 0; i < enumCount<FlagType>; ++i) {
    const Vector2d aside = world_.misplacedFlags * direction(pi * random_.symmetric());
    constexpr double outOfSight = 1e6;  // mm
    for (const char* part : {"Base", "Lower", "Upper"}) {
      const std::string name = std::string{enumName(static_cast<FlagType>(i))} + part;
      const int geom = mj_name2id(&simulated.model(), mjOBJ_GEOM, name.c_str());
      if (geom < 0) continue;
      Vector3d place = fromMuJoCo(simulated.data().geom_xpos + 3 * geom);
      place.head<2>() += i < world_.missingFlags ? Vector2d{outOfSight, 0} : aside;
      if (i < world_.missingFlags || world_.misplacedFlags > 0) simulated.moveGeom(geom, place);
    }
  }
}

/// Others stand here and there, but not on the robot itself.
void SimulatedWalker::placeOthers() {
  if (simulation_->world().robotCount() < 2 || simulation_->time() < othersMoveAt_) return;
  othersMoveAt_ = simulation_->time() + static_cast<std::int64_t>(random_.uniform(1000, 3000));
  const std::size_t other = 1 + random_.index(simulation_->world().robotCount() - 1);
  Pose2D place = placeOnField();
  for (int i = 0; i < 20 && (place.translation - pose.translation).norm() < 400; ++i)
    place = placeOnField();
  simulation_->world().placeRobot(other, place);
}

/// Adds errors to the percepts: wrong names, wrong directions.
void SimulatedWalker::disturbPercepts() {
  if (random_.chance(world_.lostPictures)) {
    percept.numberOfFlags = percept.numberOfGoals = 0;
    for (auto& points : lines.points) points.clear();
  }
  if (world_.wrong == 0) return;
  constexpr double farOff = 0.3;  // rad
  for (int i = 0; i < percept.numberOfFlags; ++i) {
    FlagPercept& flag = percept.flags[static_cast<std::size_t>(i)];
    if (random_.chance(world_.wrong))
      flag.type = static_cast<FlagType>(random_.index(enumCount<FlagType>));
  }
  for (int i = 0; i < percept.numberOfGoals; ++i)
    if (random_.chance(world_.wrong))
      percept.goals[static_cast<std::size_t>(i)].boundary.left += farOff * random_.symmetric();
  for (auto& points : lines.points)
    for (Vector2d& point : points)
      if (random_.chance(world_.wrong)) point = rotated(point, farOff * random_.symmetric());
}

void SimulatedWalker::step() {
  Pose2D speed;
  if (world_.walks) {
    const Vector2d toGoal = relative(pose, goal_);
    if (toGoal.norm() < 100 || random_.chance(world_.leansOnWalls ? 0.005 : 0.002))
      goal_ = chooseGoal();
    speed = {std::clamp(angleOf(toGoal), -0.8, 0.8), toGoal.normalized() * world_.walkingSpeed};
  }
  step(speed);
}

void SimulatedWalker::step(const Pose2D& speed) {
  body_->order(speed);
  placeOthers();
  const Time before = percept.time;
  for (int i = 0; i < 2 * Simulation::ticksPerImage && body_->landmarks.time == before; ++i)
    simulation_->step();
  time = simulation_->time();
  pose = simulation_->world().robot(0).pose;
  odometry = body_->odometry;
  percept = body_->landmarks;
  lines = body_->lines;
  camera = body_->matrix;
  trueCamera = trueMatrix(simulation_->lastView(0), pose);
  disturbPercepts();
}

}  // namespace gt
