#include "measure/worlds/GameViews.h"

#include <algorithm>

#include "modules/motion/control/DefaultMotionControl.h"
#include "streams/Config.h"

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

/// A robot's program: walks or stands, and looks in one direction.
class GameViews::Body : public RobotController {
 public:
  explicit Body(const WalkTypes& walk) { engine_.parameters = walk; }

  void cycle(const RobotInput& input, RobotOutput& output) override {
    MotionRequest request;
    request.type = walks ? MotionType::walk : MotionType::stand;
    request.walk = speed;
    engine_.update({input.now}, request, {}, {}, {motion_}, walk_);
    motion_.executed = request;
    output.joints = walk_.joints;
    step = walk_.odometryStep;
    if (!walks) {
      output.joints.angles = stance;
      step = {};
    }
    // As fast as motion control lets a head turn.
    const auto turn = [](double& angle, double wanted, double fastest) {
      return angle += std::clamp(wanted - angle, -fastest * tickSeconds, fastest * tickSeconds);
    };
    const DefaultMotionControl::Parameters most;
    output.joints.angles[Joint::headTilt] = turn(tilt_, headTilt, most.headTiltSpeed);
    output.joints.angles[Joint::headPan] = turn(pan_, headPan, most.headPanSpeed);
    output.joints.angles[Joint::headRoll] = 0;
    odometry = odometry * step;
    output.odometry.pose = odometry;
  }

  bool walks = false;
  Pose2D speed;                      ///< mm/s, rad/s: if it walks.
  JointAngles stance;                ///< rad: of the legs, if it stands.
  double headTilt = 0, headPan = 0;  ///< rad, where the head turns to.
  Pose2D odometry;                   ///< Of all ticks.
  Pose2D step;                       ///< Of the last tick.

 private:
  InvKinWalkingEngine engine_;
  WalkingEngineOutput walk_;
  MotionInfo motion_;
  double tilt_ = 0, pan_ = 0;  ///< rad, where the head is told to be.
};

Result<GameViews> GameViews::make(const DataRoot& root, const SceneDescription& scene,
                                  std::uint64_t seed) {
  WalkTypes walk;
  if (auto read = readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), walk); !read)
    return read.error();
  SceneDescription unruled = scene;
  unruled.game.referee = false;
  auto simulation = Simulation::make(unruled, seed);
  if (!simulation) return simulation.error();
  return GameViews{*std::move(simulation), walk, seed};
}

GameViews::GameViews(std::unique_ptr<Simulation> simulation, const WalkTypes& walk,
                     std::uint64_t seed)
    : simulation_(std::move(simulation)),
      random_(Random{seed}.fork("views")),
      cameraScene_(std::make_unique<CameraScene>(simulation_->world().model())),
      renderer_(*cameraScene_) {
  simulation_->takeImages(false);
  for (std::size_t i = 0; i < world().activeRobots(); ++i) {
    auto body = std::make_unique<Body>(walk);
    bodies_.push_back(body.get());
    simulation_->attach(i, std::move(body));
  }
}

Vector2d GameViews::somewhere(double x, double y) {
  return {random_.uniform(-x, x), random_.uniform(-y, y)};
}

void GameViews::placeRobot(std::size_t robot) {
  // Not too many robots on each other's toes: the world parts those.
  simulation_->world().placeRobot(robot, {random_.uniform(-pi, pi), somewhere(1950, 1150)});
  if (robot >= bodies_.size()) return;
  Body& body = *bodies_[robot];
  const double fore = random_.uniform(-0.25, 0.1), foreKnee = random_.uniform(0.4, 1.0);
  const double hind = random_.uniform(-0.4, -0.1), hindKnee = random_.uniform(0.6, 1.1);
  for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft}) {
    body.stance[legJoint(leg, 1)] = isFore(leg) ? fore : hind;
    body.stance[legJoint(leg, 2)] = 0.1;
    body.stance[legJoint(leg, 3)] = isFore(leg) ? foreKnee : hindKnee;
  }
  body.walks = random_.chance(0.5);
  constexpr double mostSpeed = 200, mostTurning = 1;  // mm/s, rad/s
  const Vector2d speed = somewhere(mostSpeed, mostSpeed);
  body.speed = {random_.uniform(-mostTurning, mostTurning), speed};
}

// Most of the time the ball is of interest: close to one of the robots.
void GameViews::placeBall() {
  const RobotBody& near = world().robot(random_.index(bodies_.size()));
  const Vector2d ball =
      random_.chance(0.5)
          ? Vector2d{near.pose * Vector2d{random_.uniform(150, 1200), random_.uniform(-500, 500)}}
          : somewhere(2000, 1250);
  simulation_->world().placeBall(
      0, {std::clamp(ball.x(), -2050.0, 2050.0), std::clamp(ball.y(), -1300.0, 1300.0)});
}

// Legs stand anywhere; a leg's own height stays.
void GameViews::placeReferees() {
  const mjModel& model = world().model();
  for (int i = 0; i < scene().referees; ++i) {
    const Vector2d at = somewhere(1950, 1200), apart = direction(random_.uniform(-pi, pi)) * 110;
    for (const bool left : {true, false}) {
      const std::string name = "referee" + std::to_string(i) + (left ? "/left" : "/right");
      const int geom = mj_name2id(&model, mjOBJ_GEOM, name.c_str());
      const Vector2d leg = left ? Vector2d{at + apart} : Vector2d{at - apart};
      simulation_->world().moveGeom(geom, {leg.x(), leg.y(), 1000 * model.geom_pos[3 * geom + 2]});
    }
  }
}

void GameViews::shuffle() {
  placeReferees();
  for (std::size_t i = 0; i < world().robotCount(); ++i) placeRobot(i);
  // Until all walk at full speed, and on, to any moment of the steps.
  constexpr std::size_t accelerating = 60, oneStep = 44;  // ticks
  run(accelerating + random_.index(oneStep));
  placeBall();
  for (Body* body : bodies_) {
    body->headTilt = random_.uniform(-0.9, 0.25);
    body->headPan = random_.uniform(-1.5, 1.5);
  }
  // Heads are still on their way in some of the images: it takes them up to a second.
  constexpr std::size_t second = 125;  // ticks
  run(SensorDataBuffer::capacity + random_.index(second));
}

void GameViews::waitForImage() {
  constexpr std::size_t period = 5;  // ticks
  run(period);
}

void GameViews::run(std::size_t ticks) {
  for (std::size_t i = 0; i < ticks; ++i) simulation_->step();
}

const GameView& GameViews::look(std::size_t robot, const CameraEffects& effects) {
  view_.robot = robot;
  view_.sensors = simulation_->input(robot).sensors;
  view_.odometry = bodies_[robot]->odometry;
  view_.step = bodies_[robot]->step;
  simulation_->setCamera(robot, effects);
  simulation_->takeImage(robot, renderer_, view_.image, &view_.truth);
  view_.camera = trueMatrix(simulation_->lastView(robot), world().robot(robot).pose);
  view_.camera.time = view_.image.time;
  return view_;
}

}  // namespace gt
