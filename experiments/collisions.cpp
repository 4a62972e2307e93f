// Measures how soon the collision detector finds that a robot runs into something, and how often it
// is wrong (report 3.6): a robot that walks about in the dynamic fidelity, where legs feel
// contacts.
#include <algorithm>
#include <cmath>

#include "Experiments.h"
#include "Profiles.h"
#include "base/InParallel.h"
#include "base/Random.h"
#include "base/Statistics.h"
#include "modules/motion/control/DefaultCollisionDetector.h"
#include "modules/motion/walking/InvKinWalkingEngine.h"
#include "simulation/Simulation.h"
#include "streams/Config.h"
#include "streams/File.h"

namespace gt {
namespace {

constexpr int ticksPerSecond = 1000 / static_cast<int>(tickMs);
constexpr double soon = 0.5;  // s
constexpr const char* calibrationFile = "config/modules/CollisionDetector.Default.cfg";

/// What happened in one run.
struct Run {
  int collisions = 0, found = 0, falseAlarms = 0;
  double freeMinutes = 0;
};

/// The program of a robot that walks about.
class Walker : public RobotController {
 public:
  Walker(std::uint64_t seed, const InvKinWalkingEngine::Parameters& walk,
         const DefaultCollisionDetector::Parameters& how)
      : random_{Random{seed}.fork("walker")} {
    engine_.parameters = walk;
    detector_.parameters = how;
  }

  void cycle(const RobotInput& input, RobotOutput& output) override {
    detector_.update(input.sensors, output.joints, info_, percept, debug_);
    debug_.out().clear();
    if (input.now >= changeAt_) choose(input.now);
    engine_.update({input.now}, request_, {}, {}, {info_}, walk_);
    info_.executed = request_;
    info_.executed.walk = walk_.speed;
    output.joints = walk_.joints;
    output.odometry.pose = output.odometry.pose * walk_.odometryStep;
  }
  const MotionRequest& motion() const { return info_.executed; }

  CollisionPercept percept;

 private:
  /// Another walk for some seconds: mostly ahead, as in a game.
  void choose(Time now) {
    changeAt_ = now + static_cast<std::int64_t>(random_.uniform(2000, 5000));
    request_.type = MotionType::walk;
    request_.walk = {0.3 * random_.symmetric(), random_.uniform(80, 200), 0};
    const double kind = random_.uniform();
    if (kind < 0.15) request_.walk = {0, 0, random_.chance(0.5) ? 80. : -80.};
    if (kind > 0.8) request_.walk = {random_.chance(0.5) ? 1. : -1., 0, 0};
  }

  Random random_;
  InvKinWalkingEngine engine_;
  WalkingEngineOutput walk_;
  MotionRequest request_;
  MotionInfo info_;
  DefaultCollisionDetector detector_;
  Debug debug_{1024};
  Time changeAt_ = Time{1000};
};

/// A robot that walks about among others, which stand.
class WalkAmongOthers {
 public:
  static Result<std::unique_ptr<WalkAmongOthers>> make(
      const DataRoot& root, std::uint64_t seed, Profile profile,
      const DefaultCollisionDetector::Parameters& how) {
    auto scene = loadScene(root.path("scenes/obstacle-challenge.scene"));
    if (!scene) return scene.error();
    setProfile(*scene, profile);
    scene->fidelity = Fidelity::dynamic;
    scene->game.referee = false;
    InvKinWalkingEngine::Parameters parameters;
    if (auto read = readConfig(root.path("config/modules/WalkingEngine.InvKin.cfg"), parameters);
        !read)
      return read.error();
    auto simulation = Simulation::make(*scene, seed);
    if (!simulation) return simulation.error();
    (*simulation)->takeImages(false);
    auto walker = std::make_unique<Walker>(seed, parameters, how);
    std::unique_ptr<WalkAmongOthers> walk{new WalkAmongOthers{*std::move(simulation), *walker}};
    walk->simulation_->attach(0, std::move(walker));
    return walk;
  }

  void step() {
    simulation_->step();
    if (robot().posture != Posture::standing) simulation_->world().placeRobot(0, {});
  }
  const RobotBody& robot() const { return simulation_->world().robot(0); }
  const MotionRequest& motion() const { return walker_.motion(); }
  const CollisionPercept& percept() const { return walker_.percept; }

 private:
  WalkAmongOthers(std::unique_ptr<Simulation> simulation, const Walker& walker)
      : simulation_{std::move(simulation)}, walker_{walker} {}

  std::unique_ptr<Simulation> simulation_;
  const Walker& walker_;  ///< Owned by the simulation.
};

/// A touch that holds the robot up: while it lasts, less than half of the way is made. Brushing
/// past something is no collision.
class HoldUp {
 public:
  /// Reports a tick.
  void add(const RobotBody& robot, const MotionRequest& motion) {
    constexpr int apart = ticksPerSecond / 4;
    if (robot.blocked) {
      if (touching_ == 0) start_ = robot.pose, wanted_ = {};
      free_ = 0;
    } else if (++free_ > apart) {
      touching_ = 0;
    }
    if (touching_ == 0 && !robot.blocked) return;
    ++touching_;
    const Pose2D& walk = motion.walk;
    wanted_ = wanted_ * Pose2D{walk.rotation * tickSeconds, walk.translation * tickSeconds};
    pose_ = robot.pose;
  }
  /// Whether something has been touched, for so many ticks (with short gaps).
  int ticks() const { return touching_; }
  int freeTicks() const { return free_; }
  bool holds() const {
    constexpr double arm = 150;  // mm: a turn moves the feet
    const auto length = [](const Pose2D& way) {
      return way.translation.norm() + arm * std::abs(way.rotation);
    };
    return length(pose_.relativeTo(start_)) < 0.5 * length(wanted_);
  }

 private:
  int touching_ = 0, free_ = 0;
  Pose2D start_, pose_, wanted_;
};

/// What is found within half a second after a collision began counts, and what is found while
/// nothing was there for long is a false alarm.
Result<Measurement> walkAndPush(const Job& job, const DataRoot& root) {
  DefaultCollisionDetector::Parameters calibrated;
  if (auto read = readConfig(root.path(calibrationFile), calibrated); !read) return read.error();
  auto walk = WalkAmongOthers::make(root, job.seed, profileOf(job), calibrated);
  if (!walk) return walk.error();
  Run run;
  HoldUp touch;
  bool found = false, alarm = false;
  const int ticks = static_cast<int>(job.number("minutes") * 60) * ticksPerSecond;
  for (int i = 0; i < ticks; ++i) {
    (*walk)->step();
    if (i < 2 * ticksPerSecond) continue;
    const bool collision = (*walk)->percept().collision();
    touch.add((*walk)->robot(), (*walk)->motion());
    found = touch.ticks() > 0 && (found || collision);
    if (touch.ticks() == static_cast<int>(soon * ticksPerSecond) && touch.holds()) {
      ++run.collisions;
      run.found += found;
    }
    if (touch.freeTicks() > ticksPerSecond) {
      run.freeMinutes += tickSeconds / 60;
      run.falseAlarms += collision && !alarm;
    }
    alarm = collision;
  }
  Measurement measured;
  if (run.collisions > 0)
    measured.add("worldmodel.collisions.foundSoon", "%", 100. * run.found / run.collisions);
  measured.add("worldmodel.collisions.falseAlarms", "1/min",
               run.falseAlarms / std::max(run.freeMinutes, 1e-9));
  return measured;
}

/// The sums of squared differences while a robot walks freely, by gait and speed.
using FreeSums = EnumArray<Gait, std::array<std::vector<double>, DefaultCollisionDetector::speeds>>;

Result<FreeSums> walkFreely(const DataRoot& root, std::uint64_t seed) {
  constexpr int minutes = 3;
  // With a threshold of 1 the strength is the sum itself.
  DefaultCollisionDetector::Parameters bare;
  for (auto& table : bare.thresholds) table.fill(1);
  auto walk = WalkAmongOthers::make(root, seed, Profile::padova, bare);
  if (!walk) return walk.error();
  FreeSums sums;
  HoldUp touch;
  const int ticks = minutes * 60 * ticksPerSecond;
  for (int i = 0; i < ticks; ++i) {
    (*walk)->step();
    touch.add((*walk)->robot(), (*walk)->motion());
    const auto place = DefaultCollisionDetector::placeOf((*walk)->motion());
    if (touch.freeTicks() > ticksPerSecond && (*walk)->percept().strength > 0)
      sums[place.gait][place.speed].push_back((*walk)->percept().strength);
  }
  return sums;
}

/// Each threshold a little above what nearly all sums of a free walk stay below; where there was no
/// such walkAndPush, that of the next slower one.
DefaultCollisionDetector::Parameters thresholdsAbove(const FreeSums& sums) {
  constexpr double nearlyAll = 0.999, margin = 1.1;
  constexpr std::size_t enough = 500;
  DefaultCollisionDetector::Parameters calibrated;
  for (std::size_t g = 0; g < enumCount<Gait>; ++g)
    for (std::size_t speed = 0; speed < DefaultCollisionDetector::speeds; ++speed) {
      auto& table = calibrated.thresholds.values[g];
      const std::vector<double>& seen = sums.values[g][speed];
      if (seen.size() >= enough)
        table[speed] = margin * quantile(seen, nearlyAll);
      else if (speed > 0)
        table[speed] = std::max(table[speed], table[speed - 1]);
    }
  return calibrated;
}

}  // namespace

Result<void> calibrateCollisions(const std::vector<std::uint64_t>& seeds, const DataRoot& root,
                                 unsigned threads) {
  const auto results =
      inParallel(seeds.size(), threads, [&](std::size_t i) { return walkFreely(root, seeds[i]); });
  FreeSums all;
  for (const Result<FreeSums>& result : results) {
    if (!result) return result.error();
    for (std::size_t g = 0; g < enumCount<Gait>; ++g)
      for (std::size_t speed = 0; speed < DefaultCollisionDetector::speeds; ++speed) {
        const std::vector<double>& seen = result->values[g][speed];
        all.values[g][speed].insert(all.values[g][speed].end(), seen.begin(), seen.end());
      }
  }
  return writeFile(
      root.path(calibrationFile),
      "// Written by `experiment calibrate-collisions`: above what legs lag in free walks.\n" +
          writeConfig(thresholdsAbove(all)));
}

Experiment collisionExperiment() {
  return {"worldmodel.collisions",
          "How often the collision detector finds collisions, and how often it is wrong",
          {profileParameter(), {"minutes", "of walking", Parameter::Kind::number, {"3"}}},
          walkAndPush};
}

}  // namespace gt
