#include "CollisionWatch.h"

#include <cmath>

#include "Profiles.h"
#include "base/Random.h"
#include "match/Match.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr int ticksPerSecond = 1000 / static_cast<int>(tickMs);

/// The program of a robot that walks about blindly.
class Walker : public RobotController {
 public:
  Walker(const Random& random, const InvKinWalkingEngine::Parameters& walk) : random_{random} {
    engine_.parameters = walk;
  }

  void cycle(const RobotInput& input, RobotOutput& output) override {
    if (input.now >= changeAt_) choose(input.now);
    engine_.update({input.now}, request_, {}, {}, {motion}, walk_);
    motion.executed = request_;
    if (request_.type == MotionType::stand &&
        (walk_.speed.rotation != 0 || !walk_.speed.translation.isZero()))
      motion.executed.type = MotionType::walk;
    motion.executed.walkType = walk_.walkType;
    motion.executed.walk = walk_.speed;
    sensors = input.sensors;
    output.joints = joints = walk_.joints;
    output.odometry.pose = output.odometry.pose * walk_.odometryStep;
  }

  SensorDataBuffer sensors;
  JointData joints;
  MotionInfo motion;

 private:
  /// Another walk for some seconds, mostly ahead, as in a game.
  void choose(Time now) {
    changeAt_ = now + static_cast<std::int64_t>(random_.uniform(500, 4000));
    request_.type = random_.chance(0.07) ? MotionType::stand : MotionType::walk;
    const double type = random_.uniform();
    request_.walkType = type < 0.45   ? WalkType::normal
                        : type < 0.88 ? WalkType::fast
                        : type < 0.93 ? WalkType::backward
                                      : WalkType::dribble;
    const double fastest =
        request_.walkType == WalkType::fast || request_.walkType == WalkType::backward ? 360 : 250;
    const double speed = random_.uniform(60, fastest), side = random_.chance(0.5) ? 1 : -1;
    const double way = random_.uniform();
    request_.walk = {0.7 * random_.symmetric(), speed, 40 * random_.symmetric()};
    if (way < 0.2)
      request_.walk = {side * random_.uniform(0.4, 2), 0, 0};
    else if (way > 0.85)
      request_.walk = {0.3 * random_.symmetric(), 50 * random_.symmetric(), side * speed};
    else if (way > 0.75 || request_.walkType == WalkType::backward)
      request_.walk = {0.3 * random_.symmetric(), -speed, 0};
  }

  Random random_;
  InvKinWalkingEngine engine_;
  WalkingEngineOutput walk_;
  MotionRequest request_;
  Time changeAt_ = Time{1000};
};

/// Puts a robot elsewhere when it has fallen, or has been at the field's border for long.
class Keeper {
 public:
  Keeper(std::size_t robot, const Random& random) : robot_{robot}, random_{random} {}

  /// Whether it has moved it.
  bool keep(World& world) {
    constexpr double x = 1900, y = 1150;  // mm
    const RobotBody& body = world.robot(robot_);
    const bool out =
        std::abs(body.pose.translation.x()) > x || std::abs(body.pose.translation.y()) > y;
    outside_ = out ? outside_ + 1 : 0;
    if (body.posture == Posture::standing && outside_ < 2 * ticksPerSecond) return false;
    outside_ = 0;
    world.placeRobot(robot_, {pi * random_.symmetric(),
                              {0.9 * x * random_.symmetric(), 0.9 * y * random_.symmetric()}});
    return true;
  }

 private:
  std::size_t robot_;
  Random random_;
  int outside_ = 0;
};

}  // namespace

HoldUp::Ended HoldUp::add(const CollisionFrame& frame) {
  constexpr int gap = ticksPerSecond / 4;
  constexpr double least = 40, share = 0.5;  // mm: slower ones do not press
  move(frame.body.pose, frame.motion.executed);
  untouched_ = frame.body.blocked || !frame.counts ? 0 : untouched_ + 1;
  free_ = untouched_ > ticksPerSecond;
  if (untouched_ > gap || !frame.counts) touching_ = 0, held_ = false;
  if (touching_ == 0 && !(frame.body.blocked && frame.counts)) return Ended::none;
  if (touching_++ == 0) made_ = wanted_ = 0;
  if (touching_ < window) return Ended::none;
  touching_ = 1;
  const bool holds = made_ < share * wanted_ && wanted_ > least;
  made_ = wanted_ = 0;
  if (!holds) return Ended::none;
  const Ended ended = held_ ? Ended::goesOn : Ended::collision;
  held_ = true;
  return ended;
}

/// Adds the way of a tick: that of the legs, and how much of it was made.
void HoldUp::move(const Pose2D& pose, const MotionRequest& walk) {
  constexpr double arm = 150;  // mm: a turn moves the feet
  const auto lengths = [](const Pose2D& way) {
    return Vector3d{way.translation.x(), way.translation.y(), arm * way.rotation};
  };
  const Vector3d way = lengths(pose.relativeTo(last_));
  last_ = pose;
  if (walk.type != MotionType::walk) return;
  const Vector3d speed = lengths(walk.walk);
  wanted_ += speed.norm() * tickSeconds;
  if (!speed.isZero()) made_ += way.dot(speed.normalized());
}

Result<void> observeWalks(const Job& job, const DataRoot& root, double minutes,
                          const CollisionObserver& observe) {
  auto scene = loadScene(job, root);
  if (!scene) return scene.error();
  scene->fidelity = *enumValue<Fidelity>(job.parameter("fidelity"));
  scene->game.referee = false;
  scene->balls.clear();
  InvKinWalkingEngine::Parameters parameters;
  if (auto read = readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), parameters);
      !read)
    return read.error();
  auto simulation = Simulation::make(*scene, job.seed);
  if (!simulation) return simulation.error();
  (*simulation)->takeImages(false);
  World& world = (*simulation)->world();
  std::vector<const Walker*> walkers;  // owned by the simulation
  std::vector<Keeper> keepers;
  for (std::size_t i = 0; i < world.robotCount(); ++i) {
    const Random random = Random{job.seed}.fork("walker " + std::to_string(i));
    auto walker = std::make_unique<Walker>(random, parameters);
    walkers.push_back(walker.get());
    keepers.emplace_back(i, random.fork("keeper"));
    (*simulation)->attach(i, std::move(walker));
  }
  const int ticks = static_cast<int>(minutes * 60) * ticksPerSecond;
  for (int tick = 0; tick < ticks; ++tick) {
    (*simulation)->step();
    for (std::size_t i = 0; i < walkers.size(); ++i) {
      const RobotBody body = world.robot(i);
      const bool moved = keepers[i].keep(world);
      observe(i, {walkers[i]->sensors, walkers[i]->joints, walkers[i]->motion, body, !moved});
    }
  }
  return {};
}

Result<void> observePlay(const Job& job, const DataRoot& root, double minutes,
                         const CollisionObserver& observe) {
  MatchOptions options{root};
  options.seed = job.seed;
  options.profile = job.parameter("profile");
  options.fidelity = job.parameter("fidelity");
  options.minutes = minutes;
  auto match = Match::make(options);
  if (!match) return match.error();
  const Simulation& simulation = (*match)->simulation();
  while (!(*match)->finished()) {
    (*match)->step();
    const bool playing = simulation.referee().state() == GameState::playing;
    for (std::size_t i = 0; i < (*match)->robots().size(); ++i) {
      const std::size_t index = (*match)->robotIndex(i);
      const Robot& robot = (*match)->robots()[i]->robot();
      const auto* joints = robot.provided<JointData>();
      const auto* motion = robot.provided<MotionInfo>();
      if (!joints || !motion) continue;
      const RobotInput& input = simulation.input(index);
      const RobotBody& body = simulation.world().robot(index);
      const bool walks =
          motion->executed.type == MotionType::walk || motion->executed.type == MotionType::stand;
      observe(index, {input.sensors, *joints, *motion, body,
                      playing && walks && input.game.penalty == Penalty::none &&
                          body.posture == Posture::standing});
    }
  }
  return (*match)->soundness();
}

}  // namespace gt
