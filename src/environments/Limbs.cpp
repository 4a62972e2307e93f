#include "environments/Limbs.h"

#include <algorithm>
#include <cmath>

namespace gt {

/// Turns the joints to `angles`, and keeps the measurements of the body.
class Limbs::Motors : public RobotController {
 public:
  void cycle(const RobotInput& input, RobotOutput& output) override {
    measured = input.sensors.newest();
    output.joints.angles = angles;
  }

  JointAngles angles{};
  SensorData measured;
};

Limbs::Limbs(EnvironmentOptions options, SceneDescription scene, std::vector<Joint> joints,
             bool ball)
    : Environment{std::move(options), std::move(scene)},
      joints_{std::move(joints)},
      withBall_{ball} {
  scene_.game.referee = false;
  scene_.robots.resize(1);
  scene_.balls.resize(ball ? 1 : 0);
  agents_ = {scene_.robots.front().name};
  if (this->actions() == ActionKind::joints) addJoints(actionSpace_, joints_);
  if (observations() == ObservationKind::image) return;
  Space& space = observationSpace_;
  const bool truth = observations() == ObservationKind::state;
  if (truth) {
    space.add("height", "m", -1, 10, "of the body's origin above the ground");
    space.add("tilt", "rad", -pi, pi, "+ nose up");
    space.add("roll", "rad", -pi, pi, "+ right side down");
    space.add("heading", "rad", -pi, pi, "against the x axis of the field");
    for (const char* axis : {"ahead", "left", "up"})
      space.add(std::string{"speed."} + axis, "m/s", -20, 20, "of the body, in its heading");
    for (const char* axis : {"x", "y", "z"})
      space.add(std::string{"turn."} + axis, "rad/s", -100, 100, "about the body's axis");
    addJoints(space, joints_, "angle", "rad", pi);
    addJoints(space, joints_, "angleSpeed", "rad/s", 1000);
    for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
      space.add("foot." + std::string{enumName(leg)}, "", 0, 1, "1: on the ground");
  } else {
    for (const char* axis : {"x", "y", "z"})
      space.add(std::string{"acceleration."} + axis, "m/s^2", -1000, 1000, "as measured");
    space.add("distance", "m", 0, 1, "as the distance sensor measures it");
    addJoints(space, joints_, "angle", "rad", pi);
    for (const Leg leg : {Leg::foreRight, Leg::foreLeft, Leg::hindRight, Leg::hindLeft})
      space.add("paw." + std::string{enumName(leg)}, "", 0, 1, "1: its switch is pressed");
  }
  addJoints(space, joints_, "requested", "rad", pi);
  if (!withBall_ || !truth) return;
  for (const char* axis : {"ahead", "left"})
    space.add(std::string{"ball."} + axis, "m", -10, 10, "relative to the robot");
  for (const char* axis : {"ahead", "left"})
    space.add(std::string{"ballSpeed."} + axis, "m/s", -20, 20, "in the robot's heading");
}

Result<void> Limbs::put(Random& random, const Pose2D& pose, Posture posture, int ticks) {
  constexpr double variety = 0.05;  // rad
  auto motors = std::make_unique<Motors>();
  motors_ = motors.get();
  simulation().attach(0, std::move(motors));
  simulation().takeImages(observations() == ObservationKind::image);
  requested_ = standingAngles();
  for (const Joint joint : joints_) requested_[joint] += variety * random.symmetric();
  world().placeRobot(0, pose);
  for (std::size_t j = 0; j < enumCount<Joint>; ++j)
    world().turnJoint(0, static_cast<Joint>(j), requested_.values[j]);
  if (posture != Posture::standing) world().throwOver(0, posture);
  for (int i = 0; i < ticks; ++i) drive(requested_);
  return {};
}

void Limbs::drive(const JointAngles& angles) {
  before_ = requested_;
  requested_ = angles;
  motors_->angles = angles;
  tick();
}

void Limbs::act(std::span<const float> actions) {
  drive(anglesOf(actions, joints_));
}

const mjtNum* Limbs::speeds() const {
  return world().data().qvel + world().model().body_dofadr[world().parts(0).body];
}

double Limbs::jointSpeed(Joint joint) const {
  const RobotParts& parts = world().parts(0);
  return speeds()[parts.jointAddress[joint] - parts.poseAddress - 1];
}

Vector3d Limbs::speed() const {
  return Eigen::Map<const Vector3d>{speeds()};
}

double Limbs::effort() const {
  double sum = 0;
  for (const Joint joint : joints_) {
    const double change = requested_[joint] - before_[joint];
    sum += change * change;
  }
  return sum / static_cast<double>(joints_.size());
}

void Limbs::observe(std::size_t, std::span<float> numbers) {
  observations() == ObservationKind::state ? observeState(numbers) : observeBeliefs(numbers);
}

void Limbs::observeState(std::span<float> numbers) const {
  auto next = numbers.begin();
  const auto add = [&](double number) { *next++ = static_cast<float>(number); };
  const RobotBody& robot = body();
  add(robot.height / 1000);
  add(robot.tilt);
  add(robot.roll);
  add(robot.pose.rotation);
  const Vector3d onField = speed();
  const Vector2d ahead = rotated(onField.head<2>(), -robot.pose.rotation);
  add(ahead.x());
  add(ahead.y());
  add(onField.z());
  for (int k = 3; k < 6; ++k) add(speeds()[k]);
  for (const Joint joint : joints_) add(robot.joints[joint]);
  for (const Joint joint : joints_) add(jointSpeed(joint));
  for (const bool foot : robot.footOnGround) add(foot);
  for (const Joint joint : joints_) add(requested_[joint]);
  if (!withBall_) return;
  const BallState& ball = world().ball(0);
  const Vector2d place = relative(robot.pose, ball.position) / 1000;
  const Vector2d rolls = rotated(ball.speed, -robot.pose.rotation) / 1000;
  for (const double number : {place.x(), place.y(), rolls.x(), rolls.y()}) add(number);
}

void Limbs::observeBeliefs(std::span<float> numbers) const {
  auto next = numbers.begin();
  const auto add = [&](double number) { *next++ = static_cast<float>(number); };
  const SensorData& measured = motors_->measured;
  for (int k = 0; k < 3; ++k) add(measured.acceleration[k] / 1000);
  add(measured.psd / 1000);
  for (const Joint joint : joints_) add(measured.joints[joint]);
  for (std::size_t leg = 0; leg < enumCount<Leg>; ++leg)
    add(measured.switches.values[static_cast<std::size_t>(Switch::pawFR) + leg]);
  for (const Joint joint : joints_) add(requested_[joint]);
}

SceneCamera Limbs::camera() const {
  SceneCamera camera = Environment::camera();
  const Vector2d& at = body().pose.translation;
  camera.from = {at.x() + 150, at.y() - 700, 350};
  camera.at = {at.x(), at.y(), 80};
  camera.openingAngle = 50;
  return camera;
}

}  // namespace gt
