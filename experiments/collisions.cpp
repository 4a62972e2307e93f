// Measures how soon the collision detector finds that a robot runs into something, and how often it
// is wrong (report 3.6): a robot that walks about in the dynamic fidelity, where legs feel
// contacts.
#include <algorithm>
#include <cmath>

#include "Experiments.h"
#include "InParallel.h"
#include "base/Random.h"
#include "modules/motion/DefaultCollisionDetector.h"
#include "modules/motion/InvKinWalkingEngine.h"
#include "simulation/Sensors.h"
#include "simulation/World.h"
#include "streams/Config.h"

namespace gt {
namespace {

constexpr int ticksPerSecond = 1000 / static_cast<int>(tickMs);
constexpr double soon = 0.5;  // s

/// What happened in one run.
struct Run {
  int collisions = 0, found = 0, falseAlarms = 0;
  double freeMinutes = 0;
  std::vector<double> strengthFree, strengthBlocked;
};

/// A robot that walks about among others, as it is told.
class Walker {
 public:
  static Result<std::unique_ptr<Walker>> make(std::uint64_t seed) {
    auto scene = loadScene("scenes/obstacle-challenge.scene");
    if (!scene) return scene.error();
    scene->fidelity = Fidelity::dynamic;
    auto world = makeWorld(*scene, Random{seed});
    if (!world) return world.error();
    std::unique_ptr<Walker> walker{new Walker{std::move(*world), scene->noise, seed}};
    if (auto read =
            readConfig("config/modules/WalkingEngine.InvKin.cfg", walker->engine_.parameters);
        !read)
      return read.error();
    return walker;
  }

  void step() {
    if (world_->time() >= changeAt_) choose();
    engine_.update({world_->time()}, request_, {}, {info_}, output_);
    info_.executed = request_;
    info_.executed.walk = output_.speed;
    const RobotCommand command{
        output_.joints.angles,
        {output_.speed.rotation * tickSeconds, output_.speed.translation * tickSeconds}};
    world_->step({&command, 1});
    SensorData data;
    sensors_.read(*world_, 0, data);
    buffer_.push(data);
    detector_.update(buffer_, {command.joints}, info_, percept, debug_);
    debug_.out().clear();
    if (robot().posture != Posture::standing) world_->placeRobot(0, {});
  }
  const RobotBody& robot() const { return world_->robot(0); }
  Time time() const { return world_->time(); }

  CollisionPercept percept;

 private:
  Walker(std::unique_ptr<World> world, const NoiseParameters& noise, std::uint64_t seed)
      : world_{std::move(world)}, random_{seed}, sensors_{noise, random_.fork("sensors")} {}

  /// Another walk for some seconds: mostly ahead, as in a game.
  void choose() {
    changeAt_ = world_->time() + static_cast<std::int64_t>(random_.uniform(2000, 5000));
    request_.type = MotionType::walk;
    request_.walk = {0.3 * random_.symmetric(), random_.uniform(80, 200), 0};
    const double kind = random_.uniform();
    if (kind < 0.15) request_.walk = {0, 0, random_.chance(0.5) ? 80. : -80.};
    if (kind > 0.8) request_.walk = {random_.chance(0.5) ? 1. : -1., 0, 0};
  }

  std::unique_ptr<World> world_;
  Random random_;
  Sensors sensors_;
  InvKinWalkingEngine engine_;
  WalkingEngineOutput output_;
  MotionRequest request_;
  MotionInfo info_;
  SensorDataBuffer buffer_;
  DefaultCollisionDetector detector_;
  Debug debug_{1024};
  Time changeAt_ = Time{1000};
};

/// A collision lasts while something blocks the robot for most of a while; what is found soon after
/// it began counts, and what is found while nothing was there for long is a false alarm.
Result<Run> walk(std::uint64_t seed, double minutes) {
  auto walker = Walker::make(seed);
  if (!walker) return walker.error();
  Run run;
  int blocked = 0, free = 0;
  bool counted = false, found = false, alarm = false;
  const int ticks = static_cast<int>(minutes * 60) * ticksPerSecond;
  for (int i = 0; i < ticks; ++i) {
    (*walker)->step();
    if (i < 2 * ticksPerSecond) continue;
    const bool collision = (*walker)->percept.collision();
    if ((*walker)->robot().blocked) {
      ++blocked;
      free = 0;
    } else if (++free > ticksPerSecond / 4) {
      blocked = 0;
      counted = found = false;
    }
    found = found || (collision && blocked > 0);
    // Brushing past something is no collision: it has to hold the robot up for half a second.
    if (!counted && blocked >= static_cast<int>(soon * ticksPerSecond)) {
      counted = true;
      ++run.collisions;
      run.found += found;
    }
    if (free > ticksPerSecond) {
      run.freeMinutes += tickSeconds / 60;
      run.falseAlarms += collision && !alarm;
      run.strengthFree.push_back((*walker)->percept.strength);
    } else if (blocked > 10) {
      run.strengthBlocked.push_back((*walker)->percept.strength);
    }
    alarm = collision;
  }
  return run;
}

}  // namespace

Result<void> measureCollisions(Figures& figures, const ExperimentOptions& options) {
  std::vector<Result<Run>> results(options.seeds.size(), Run{});
  inParallel(results.size(), [&](std::size_t i) { results[i] = walk(options.seeds[i], 3); });
  std::vector<double> found, alarms, free, blocked;
  for (const Result<Run>& result : results) {
    if (!result) return result.error();
    if (result->collisions > 0) found.push_back(100. * result->found / result->collisions);
    alarms.push_back(result->falseAlarms / std::max(result->freeMinutes, 1e-9));
    free.push_back(quantile(result->strengthFree, 0.99));
    blocked.push_back(quantile(result->strengthBlocked, 0.5));
  }
  figures.add("worldmodel.collisions.foundSoon", "%", found);
  figures.add("worldmodel.collisions.falseAlarms", "1/min", alarms);
  figures.add("worldmodel.collisions.strength.free.p99", "", free);
  figures.add("worldmodel.collisions.strength.blocked.median", "", blocked);
  return {};
}

}  // namespace gt
