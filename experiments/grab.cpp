// Grabs the ball with the fore legs, turns with it, and kicks it: how often that succeeds.
#include <algorithm>
#include <cmath>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "Profiles.h"
#include "base/Statistics.h"
#include "measure/worlds/MovedRobot.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {
namespace {

/// What the robot is asked to do.
struct GrabTask {
  Vector2d place;  ///< mm, where the ball lies before the robot
  double window;   ///< mm by which it lies elsewhere at most
  double turn;     ///< rad
  std::string kick;
};

/// What became of one ball.
struct Grabbed {
  double turned = 0;                   ///< rad, towards where it shall go
  Vector2d before = Vector2d::Zero();  ///< mm, of the ball to the robot, when it is grabbed
  Vector2d after = Vector2d::Zero();   ///< when the robot has turned
  Vector2d way = Vector2d::Zero();     ///< mm, of the kicked ball, x in the direction requested
  Pose2D grabbing, kicking;            ///< By which the robot moves meanwhile.
  double odometryError = 0;            ///< mm, from the grab to the end
  double seconds = 0;
  bool fell = false;

  /// Between the fore legs, so that the kick reaches it.
  bool held() const {
    constexpr double nearest = 80, farthest = 170, aside = 40;  // mm
    return !fell && after.x() > nearest && after.x() < farthest && std::abs(after.y()) < aside;
  }
  bool succeeded() const {
    constexpr double shortest = 1000, widest = fromDegrees(25);  // mm, rad
    return !fell && way.norm() >= shortest && std::abs(angleOf(way)) <= widest;
  }
};

/// Somewhere on the field, so that no wall stops the ball before the robot stands again.
Pose2D startOf(double turn, Random& random) {
  const FieldDimensions field;
  constexpr double border = 300, rolls = 1500;  // mm
  const auto isFree = [&](const Vector2d& place) {
    return std::abs(place.x()) < field.xGroundline - border &&
           std::abs(place.y()) < field.ySideline - border;
  };
  for (;;) {
    const Pose2D start{pi * random.symmetric(), field.xGroundline * random.symmetric(),
                       field.ySideline * random.symmetric()};
    const Vector2d kicked = start.translation + rolls * direction(start.rotation + turn);
    if (isFree(start.translation) && isFree(kicked)) return start;
  }
}

/// Performs the steps of the play with a robot, and keeps the time.
class Play {
 public:
  Play(MovedRobot& robot, Grabbed& grabbed) : robot_{robot}, grabbed_{grabbed} {}

  /// From the stance of a walk type, until the action has begun.
  void perform(const std::string& action, WalkType stance) {
    request(MotionType::specialAction);
    robot_.request.walkType = stance;
    robot_.request.specialAction = action;
    while (robot_.motion().executed.specialAction != action && step()) continue;
  }
  /// Ends an action, and turns by an angle as the odometry counts it.
  void turn(double angle) {
    request(MotionType::walk);
    robot_.request.walkType = WalkType::turnWithBall;
    while (isActing() && step()) continue;
    const double from = robot_.odometry().pose.rotation;
    constexpr double slowing = 0.4, precise = fromDegrees(2), fastest = 3;  // s, rad, rad/s
    double done = 0;
    while (std::abs(angle - done) > precise) {
      robot_.request.walk.rotation = std::clamp((angle - done) / slowing, -fastest, fastest);
      if (!step()) return;
      // A turn by more than half of the circle is counted on.
      done = nearestTo(done, robot_.odometry().pose.rotation - from);
    }
    robot_.request.walk = {};
    robot_.request.type = MotionType::stand;
    while (robot_.motion().executed.type != MotionType::stand && step()) continue;
  }
  /// Ends an action.
  void end() {
    robot_.request = {};
    while (isActing() && step()) continue;
  }

 private:
  static double nearestTo(double before, double angle) {
    return before + normalize(angle - before);
  }
  void request(MotionType type) {
    robot_.request = {};
    robot_.request.type = type;
  }
  bool isActing() const { return robot_.motion().executed.type == MotionType::specialAction; }
  /// False if it takes too long.
  bool step() {
    constexpr double longest = 20;  // s
    robot_.step();
    grabbed_.seconds += tickSeconds;
    grabbed_.fell |= robot_.hasFallen();
    return grabbed_.seconds < longest;
  }

  MovedRobot& robot_;
  Grabbed& grabbed_;
};

/// A robot somewhere walks some steps as it does on its way to a ball, and grabs; the ball is put
/// down as the grab begins.
Grabbed grab(MovedRobot& robot, const GrabTask& task, Random& random) {
  World& world = robot.world();
  const FieldDimensions field;
  const Pose2D start = startOf(task.turn, random);
  robot.request = {};
  world.placeBall(0, {start.translation.x() > 0 ? -field.xSideCorner : field.xSideCorner, 0});
  world.placeRobot(0, start);
  robot.run(0.6);
  robot.request.type = MotionType::walk;
  robot.request.walk = {0.5 * random.symmetric(), 100 * random.uniform(), 60 * random.symmetric()};
  robot.run(1 + 0.5 * random.uniform());

  Grabbed grabbed;
  Play play{robot, grabbed};
  play.perform("grab", WalkType::normal);
  grabbed.seconds = 0;
  const Pose2D from = robot.body().pose, counted = robot.odometry().pose;
  world.placeBall(
      0, from * (task.place + task.window * Vector2d{random.symmetric(), random.symmetric()}));
  const auto ball = [&] { return relative(robot.body().pose, world.ball(0).position); };
  play.turn(0);
  grabbed.before = ball();
  grabbed.grabbing = robot.body().pose.relativeTo(from);
  play.turn(task.turn);
  grabbed.turned = normalize(robot.body().pose.rotation - from.rotation);
  grabbed.after = ball();
  const Vector2d lies = world.ball(0).position;
  const Pose2D stood = robot.body().pose;
  play.perform(task.kick, WalkType::turnWithBall);
  play.end();
  grabbed.kicking = robot.body().pose.relativeTo(stood);
  const Pose2D moved = robot.body().pose.relativeTo(from);
  grabbed.odometryError =
      (robot.odometry().pose.relativeTo(counted).translation - moved.translation).norm();
  const BallState& kicked = world.ball(0);
  const double slowing = robot.simulation().scene().physics.deceleration;
  const Vector2d rolls = kicked.speed * kicked.speed.norm() / (2 * slowing);
  const Pose2D wanted{from.rotation + task.turn, lies};
  grabbed.way = relative(wanted, Vector2d{kicked.position + rolls});
  for (double after = 0; after < 1; after += tickSeconds) {  // s: some fall when they stand again
    robot.step();
    grabbed.fell |= robot.hasFallen();
  }
  return grabbed;
}

Result<Measurement> grabAll(const Job& job, const DataRoot& root) {
  auto scene = dynamicScene(job, root);
  if (!scene) return scene.error();
  scene->balls.resize(1);
  auto robot = MovedRobot::make(root, *scene, job.seed);
  if (!robot) return robot.error();
  (*robot)->standUp();
  Random random = Random{job.seed}.fork("grab");
  const int times = static_cast<int>(job.number("times"));
  int succeeded = 0, held = 0, falls = 0;
  RunningStatistics turned, seconds, ahead, astray, before, beforeAside, after, afterAside;
  RunningStatistics grabbing, kicking, odometry;
  for (int i = 0; i < times; ++i) {
    const double angle = fromDegrees(job.number("angle")) * (random.chance(0.5) ? 1 : -1);
    const GrabTask task{{job.number("x"), 0}, job.number("window"), angle, job.parameter("kick")};
    const Grabbed grabbed = grab(**robot, task, random);
    succeeded += grabbed.succeeded();
    held += grabbed.held();
    falls += grabbed.fell;
    turned.add(toDegrees(grabbed.turned) * (angle > 0 ? 1 : -1));
    seconds.add(grabbed.seconds);
    ahead.add(grabbed.way.x());
    astray.add(std::abs(toDegrees(angleOf(grabbed.way))));
    before.add(grabbed.before.x());
    beforeAside.add(std::abs(grabbed.before.y()));
    after.add(grabbed.after.x());
    afterAside.add(std::abs(grabbed.after.y()));
    grabbing.add(grabbed.grabbing.translation.x());
    kicking.add(grabbed.kicking.translation.x());
    odometry.add(grabbed.odometryError);
    if (grabbed.fell) (*robot)->world().standUp(0);
  }
  Measurement measurement;
  const auto share = [&](int count) { return 100. * count / times; };
  measurement.add("motion.grab.success", "%", share(succeeded), Aim::atLeast(80));
  measurement.add("motion.grab.held", "%", share(held));
  measurement.add("motion.grab.falls", "%", share(falls));
  measurement.add("motion.grab.turned", "deg", turned.mean());
  measurement.add("motion.grab.seconds", "s", seconds.mean());
  measurement.add("motion.grab.ahead", "mm", ahead.mean());
  measurement.add("motion.grab.astray", "deg", astray.mean());
  measurement.add("motion.grab.before.x", "mm", before.mean());
  measurement.add("motion.grab.before.y", "mm", beforeAside.mean());
  measurement.add("motion.grab.after.x", "mm", after.mean());
  measurement.add("motion.grab.after.y", "mm", afterAside.mean());
  measurement.add("motion.grab.grabbing.x", "mm", grabbing.mean());
  measurement.add("motion.grab.kicking.x", "mm", kicking.mean());
  measurement.add("motion.grab.odometryError", "mm", odometry.mean());
  return measurement;
}

}  // namespace

Experiment grabExperiment() {
  return {"motion.grab",
          "Grabs the ball, turns with it to a side of chance, and kicks it in the new direction",
          {profileParameter(),
           changeParameter(),
           fidelityParameter(),
           varietyParameter(),
           {"kick", "the special action that kicks", Parameter::Kind::text, {"grabKick"}},
           {"x", "mm ahead, where the ball lies", Parameter::Kind::number, {"112"}},
           {"window", "mm by which it lies elsewhere at most", Parameter::Kind::number, {"15"}},
           {"angle", "degrees by which the robot turns", Parameter::Kind::number, {"90"}},
           {"times", "each robot does it", Parameter::Kind::number, {"5"}},
           valuesParameter()},
          withValues<grabAll>};
}

}  // namespace gt
