// Measures the self-locators against the truth: the report's experiments (3.3.3.4, figure 3.8) in
// the simulator, with its images and the robot's own vision; and how robust they are, there and
// on a test bench without images, where everything goes wrong that can.
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ChangedRoot.h"
#include "Experiments.h"
#include "GoToPoints.h"
#include "Profiles.h"
#include "base/Statistics.h"
#include "measure/Tally.h"
#include "measure/worlds/SimulatedWalker.h"
#include "modules/behavior/skills/GoToPoint.h"
#include "modules/behavior/testing/ImaginedWorld.h"
#include "modules/modeling/testing/LocalizationTrial.h"
#include "modules/modeling/testing/Locators.h"

namespace gt {
namespace {

/// All locators, where one may be chosen.
constexpr std::string_view everyLocator = "all";

/// With so much slip the odometry alone is off by more than a meter within a minute.
constexpr double muchSlip = 0.4, muchNoise = 2;

/// What a walk's or a search's figures should be at most.
const std::map<std::string, Aim> aims{
    {"odometry.experiment1.minute", Aim::atLeast(1000)},
    {"lines.nobeacons.experiment1.error.mean", Aim::atMost(50)},
    {"kalman.experiment1.error.mean", Aim::atMost(50)},
    {"kalman.nobeacons.experiment1.error.mean", Aim::atMost(50)},
    {"lines.nobeacons.experiment2.stop.mean", Aim::atMost(40)},
    {"lines.nobeacons.experiment2.estimate.mean", Aim::atMost(30)},
    {"kalman.experiment2.stop.mean", Aim::atMost(40)},
    {"kalman.experiment2.estimate.mean", Aim::atMost(30)},
    {"kalman.nobeacons.experiment2.stop.mean", Aim::atMost(40)},
    {"kalman.nobeacons.experiment2.estimate.mean", Aim::atMost(30)},
    {"montecarlo.fromNothing.median", Aim::atMost(10)},
    {"montecarlo.kidnapped.median", Aim::atMost(10)},
    {"montecarlo.search.mirrored.longest", Aim::atMost(2)},
    {"kalman.fromNothing.median", Aim::atMost(10)},
    {"kalman.kidnapped.median", Aim::atMost(10)},
    {"kalman.search.mirrored.longest", Aim::atMost(2)},
    {"kalman.nobeacons.search.mirrored.longest", Aim::atMost(2)},
    {"montecarlo.error.median", Aim::atMost(150)},
    {"montecarlo.error.p95", Aim::atMost(600)},
    {"montecarlo.lost.longest", Aim::atMost(15)}};

/// Adds a figure by its name behind the group's.
void addFigure(Measurement& measured, const std::string& name, const char* unit, double value) {
  const auto aim = aims.find(name);
  measured.add("localization." + name, unit, value, aim == aims.end() ? Aim{} : aim->second);
}

void addSummary(Measurement& measured, const std::string& name, const char* unit,
                const std::vector<double>& errors) {
  for (const auto& [of, value] : summaryOf(errors))
    addFigure(measured, name + '.' + of, unit, value);
}

/// Where the robot would be if the field were turned by half a circle: without goals and beacons
/// nothing distinguishes them.
bool isMirrored(const Pose2D& estimate, const Pose2D& truth) {
  const double right = (estimate.translation - truth.translation).norm();
  const double mirrored = (estimate.translation + truth.translation).norm();
  return mirrored < right && std::abs(normalize(estimate.rotation - truth.rotation)) > pi / 2;
}

/// For how long an estimate is the mirror image of the truth although something that
/// distinguishes them has been seen since.
class MirrorWatch {
 public:
  void add(bool mirrored, const LandmarksPercept& seen) {
    distinguished_ = mirrored && (distinguished_ || seen.numberOfFlags + seen.numberOfGoals > 0);
    now_ = distinguished_ ? now_ + SyntheticRobot::imagePeriod / 1000.0 : 0;
    longest_ = std::max(longest_, now_);
  }
  double longest() const { return longest_; }  ///< s

 private:
  bool distinguished_ = false;
  double now_ = 0, longest_ = 0;
};

/// A self-locator that follows a robot beside others, and what it achieves.
struct Follower {
  std::string name;
  std::unique_ptr<AnyLocator> locator;
  std::vector<double> errors;
  MirrorWatch mirror;
  double lost = 0, longestLost = 0;

  template <typename Robot>
  double look(const Robot& robot) {
    const Pose2D estimate = (*locator)(seenBy(robot)).pose;
    const double error = (estimate.translation - robot.pose.translation).norm();
    mirror.add(isMirrored(estimate, robot.pose), robot.percept);
    lost = error > 600 ? lost + SyntheticRobot::imagePeriod / 1000.0 : 0;
    longestLost = std::max(longestLost, lost);
    return error;
  }
  void report(Measurement& run) const {
    const double average = mean(errors);
    const auto below =
        std::count_if(errors.begin(), errors.end(), [&](double e) { return e < average; });
    addSummary(run, name + ".error", "mm", errors);
    addFigure(run, name + ".error.belowMean", "%",
              100 * static_cast<double>(below) / static_cast<double>(errors.size()));
    addFigure(run, name + ".lost.longest", "s", longestLost);
    addFigure(run, name + ".mirrored.longest", "s", mirror.longest());
  }
};

/// All locators that can do without beacons, or all.
std::vector<Follower> followers(const std::string& suffix, bool beacons, std::uint64_t seed) {
  std::vector<Follower> all;
  for (const LocatorKind& kind : locatorKinds())
    if (beacons || kind.usesEdges)
      all.push_back({kind.name + (beacons ? "" : ".nobeacons") + suffix, kind.make(seed), {}, {}});
  return all;
}

/// Experiment 1: a random walk of 18 minutes with much slip, the head turning left and right. All
/// locators see the same.
Result<Measurement> experiment1(const Job& job, const DataRoot& root) {
  constexpr int minutes = 18;
  const bool beacons = job.flag("beacons");
  auto made = SimulatedWalker::make(
      root, job.seed,
      {.profile = profileOf(job), .slip = muchSlip, .motion = muchNoise, .flags = beacons});
  if (!made) return made.error();
  SimulatedWalker& robot = **made;
  std::vector<Follower> all = followers(".experiment1", beacons, job.seed);
  Pose2D truth, counted;
  std::vector<double> drift;
  for (int i = 0; i < SyntheticRobot::imagesPerMinute * minutes; ++i) {
    robot.step();
    if (i % SyntheticRobot::imagesPerMinute == 0) {
      const Pose2D walked = robot.odometry.pose.relativeTo(counted);
      if (i > 0) drift.push_back(((truth * walked).translation - robot.pose.translation).norm());
      truth = robot.pose;
      counted = robot.odometry.pose;
    }
    for (Follower& follower : all) {
      const double error = follower.look(robot);
      if (i >= SyntheticRobot::imagesPerMinute / 6) follower.errors.push_back(error);
    }
  }
  Measurement run;
  for (const Follower& follower : all) follower.report(run);
  if (beacons) addFigure(run, "odometry.experiment1.minute", "mm", mean(drift));
  return run;
}

/// Walks to a point by the behavior's own skill, until it has stood for half a second (or for two
/// minutes, where it does not come to rest).
Arrival goTo(const Pose2D& goal, SimulatedWalker& robot, AnyLocator& locator) {
  ImaginedWorld world;
  const WorldState state = world.state();
  const Tactics::Parameters tacticsParameters;
  Tactics tactics{tacticsParameters};
  MotionRequest request;
  const Movement::Parameters parameters;
  const WalkManner manner;
  Movement movement{tactics, request, manner, parameters};
  GoToPoint goToPoint{movement};
  goToPoint.x = goal.translation.x();
  goToPoint.y = goal.translation.y();
  goToPoint.angle = toDegrees(goal.rotation);
  goToPoint.maxSpeed = 150;
  int stood = 0;
  for (int i = 0; i < 2 * SyntheticRobot::imagesPerMinute && stood < 12; ++i) {
    world.self = locator(seenBy(robot));
    tactics.update(state);
    goToPoint.execute();
    const bool stands = request.type == MotionType::stand;
    stood = stands ? stood + 1 : 0;
    robot.step(stands ? Pose2D{} : request.walk);
  }
  return {(robot.pose.translation - goal.translation).norm(),
          (locator(seenBy(robot)).pose.translation - robot.pose.translation).norm()};
}

}  // namespace

std::vector<Arrival> goToPoints(SimulatedWalker& robot, AnyLocator& locator, int points,
                                std::uint64_t seed) {
  Random random{seed};
  std::vector<Arrival> arrivals;
  for (int i = 0; i < SyntheticRobot::imagesPerMinute / 6; ++i) {
    robot.step();
    locator(seenBy(robot));
  }
  for (int i = 0; i < points; ++i) {
    const double angle = pi * random.symmetric();
    const double x = 0.85 * robot.field.xGroundline * random.symmetric();
    const double y = 0.85 * robot.field.ySideline * random.symmetric();
    arrivals.push_back(goTo({angle, x, y}, robot, locator));
  }
  return arrivals;
}

namespace {

/// Experiment 2: 68 random points, reached by go-to-point, with the head always turning.
void experiment2(SimulatedWalker& robot, AnyLocator& locator, std::uint64_t seed,
                 const std::string& name, Measurement& run) {
  constexpr int points = 68;
  std::vector<double> stops, estimates;
  for (const Arrival& arrival : goToPoints(robot, locator, points, seed)) {
    stops.push_back(arrival.ofRobot);
    estimates.push_back(arrival.ofEstimate);
  }
  addSummary(run, name + ".experiment2.stop", "mm", stops);
  addSummary(run, name + ".experiment2.estimate", "mm", estimates);
}

/// Images until each locator's pose is within 20 cm and stays, all seeing the same.
void search(SimulatedWalker& robot, std::vector<Follower>& all,
            std::map<std::string, std::vector<double>>& pictures) {
  constexpr int most = 500;
  std::vector<ImagesUntilLocalized> counters(all.size());
  bool found = false;
  for (int i = 0; i < most && !found; ++i) {
    robot.step();
    found = true;
    for (std::size_t k = 0; k < all.size(); ++k) {
      const double error = all[k].look(robot);
      if (!counters[k].done()) counters[k].add(error);
      found &= counters[k].done();
    }
  }
  for (std::size_t k = 0; k < all.size(); ++k)
    pictures[all[k].name].push_back(counters[k].result().value_or(most));
}

/// From nothing, and after the referee has put the robot elsewhere, while it stands and turns its
/// head (report, figure 3.8).
Result<Measurement> relocalizing(const Job& job, const DataRoot& root) {
  constexpr int trials = 15;
  const bool beacons = job.flag("beacons");
  auto made = SimulatedWalker::make(root, job.seed,
                                    {.profile = profileOf(job), .flags = beacons, .walks = false});
  if (!made) return made.error();
  SimulatedWalker& robot = **made;
  std::map<std::string, std::vector<double>> nothing, kidnapped;
  std::map<std::string, double> mirrored;
  for (std::uint64_t i = 0; i < trials; ++i) {
    std::vector<Follower> all = followers("", beacons, job.seed * 1000 + i);
    robot.kidnap();
    search(robot, all, nothing);
    robot.kidnap();
    search(robot, all, kidnapped);
    for (const Follower& f : all) mirrored[f.name] = std::max(mirrored[f.name], f.mirror.longest());
  }
  Measurement run;
  for (const auto& [name, pictures] : nothing) {
    addSummary(run, name + ".fromNothing", "pictures", pictures);
    addSummary(run, name + ".kidnapped", "pictures", kidnapped[name]);
    addFigure(run, name + ".search.mirrored.longest", "s", mirrored[name]);
  }
  return run;
}

/// What goes wrong in a row of the robustness table, or nothing: on the test bench, and on
/// simulated images.
struct Trouble {
  std::string name;
  SyntheticWorld bench;
  WalkerWorld pictures;
};

std::vector<Trouble> troubles() {
  std::vector<Trouble> rows{{"none", {}, {}}};
  const auto row = [&](const std::string& name) -> Trouble& {
    return rows.emplace_back(Trouble{name, {}, {}});
  };
  for (std::uint64_t missing = 1; missing <= 6; ++missing) {
    Trouble& trouble = row("missing" + std::to_string(missing));
    trouble.bench.missingFlags = trouble.pictures.missingFlags = missing;
  }
  Trouble& misplaced = row("misplaced10cm");
  misplaced.bench.misplacedFlags = misplaced.pictures.misplacedFlags = 100;
  Trouble& wrong = row("wrong10percent");
  wrong.bench.outliers = wrong.pictures.wrong = 0.1;
  Trouble& dropped = row("halfDropped");
  dropped.bench.lostPictures = dropped.pictures.lostPictures = 0.5;
  Trouble& hidden = row("robotsInTheWay");
  hidden.bench.hidden = 0.4;
  hidden.pictures.others = 7;
  Trouble& walls = row("leaningOnWalls");
  walls.bench.secondsBetweenBlocks = 8;
  walls.pictures.leansOnWalls = true;
  Trouble& slipping = row("slip30percent");
  slipping.pictures.slip = slipping.bench.slip = 0.3;
  return rows;
}

/// The locators of a job, with the parameters of the root's configuration.
Result<std::vector<Follower>> followersOf(const Job& job, const DataRoot& root,
                                          const std::string& suffix) {
  const std::string& wanted = job.parameter("locators");
  std::vector<Follower> all;
  for (const LocatorKind& kind : locatorKinds()) {
    if (wanted != everyLocator && wanted != kind.name) continue;
    Follower& follower = all.emplace_back();
    follower.name = kind.name + suffix;
    follower.locator = kind.make(job.seed);
    const std::string file = root.path("config/modules/SelfLocator." + kind.solution + ".cfg");
    if (!std::filesystem::exists(file)) continue;
    if (auto done = follower.locator->configure(file); !done) return done.error();
  }
  return all;
}

/// The errors of locators while a robot walks for some minutes.
template <typename Robot>
Measurement followThrough(Robot& robot, std::vector<Follower> all, const Job& job) {
  const int pictures = static_cast<int>(SyntheticRobot::imagesPerMinute * job.number("minutes"));
  for (int i = 0; i < pictures; ++i) {
    robot.step();
    for (Follower& follower : all) {
      const double error = follower.look(robot);
      if (i >= std::min(SyntheticRobot::imagesPerMinute / 6, pictures / 2))
        follower.errors.push_back(error);
    }
  }
  Measurement run;
  for (const Follower& follower : all) follower.report(run);
  return run;
}

/// What goes wrong in a job.
Trouble troubleOf(const Job& job) {
  for (Trouble& trouble : troubles())
    if (trouble.name == job.parameter("trouble")) return trouble;
  return {};
}

/// The end of the names of the figures: nothing if all is well.
std::string suffixOf(const Trouble& trouble) {
  return trouble.name == "none" ? "" : "." + trouble.name;
}

/// The errors while something goes wrong in a world like a match without images.
Result<Measurement> robustnessOnBench(const Job& job, const DataRoot& root) {
  const Trouble trouble = troubleOf(job);
  auto all = followersOf(job, root, suffixOf(trouble));
  if (!all) return all.error();
  SyntheticRobot robot{job.seed, trouble.bench};
  return followThrough(robot, *std::move(all), job);
}

/// The same in the simulator with its images.
Result<Measurement> robustnessOnImages(const Job& job, const DataRoot& root) {
  Trouble trouble = troubleOf(job);
  trouble.pictures.profile = profileOf(job);
  auto all = followersOf(job, root, ".pictures" + suffixOf(trouble));
  if (!all) return all.error();
  auto walker = SimulatedWalker::make(root, job.seed, trouble.pictures);
  if (!walker) return walker.error();
  return followThrough(**walker, *std::move(all), job);
}

/// Behind the names of locators that run without beacons.
constexpr std::string_view withoutBeacons = ".nobeacons";

Result<Measurement> goingToPoints(const Job& job, const DataRoot& root) {
  const std::string& name = job.parameter("locator");
  const bool beacons = !name.ends_with(withoutBeacons);
  Measurement run;
  for (const LocatorKind& kind : locatorKinds()) {
    if (kind.name != name.substr(0, name.find(withoutBeacons))) continue;
    auto robot =
        SimulatedWalker::make(root, job.seed, {.profile = profileOf(job), .flags = beacons});
    if (!robot) return robot.error();
    const auto locator = kind.make(job.seed);
    experiment2(**robot, *locator, job.seed, name, run);
  }
  return run;
}

}  // namespace

Experiments localizationExperiments() {
  const Parameter beacons{
      "beacons", "whether they are on the field", Parameter::Kind::each, {"true", "false"}};
  Parameter locator{"locator", "which finds the way", Parameter::Kind::each, {}};
  for (const LocatorKind& kind : locatorKinds()) {
    locator.values.push_back(kind.name);
    if (kind.usesEdges) locator.values.push_back(kind.name + std::string{withoutBeacons});
  }
  Parameter trouble{"trouble", "what goes wrong", Parameter::Kind::each, {}};
  for (const Trouble& t : troubles()) trouble.values.push_back(t.name);
  Parameter which{
      "locators", "that are compared", Parameter::Kind::choice, {std::string{everyLocator}}};
  for (const LocatorKind& kind : locatorKinds()) which.values.push_back(kind.name);
  const auto minutes = [](const char* value) {
    return Parameter{"minutes", "of walking", Parameter::Kind::number, {value}};
  };
  return {{"localization.goToPoint",
           "How precisely points are reached (report 3.3.3.4, experiment 2)",
           {profileParameter(), locator},
           goingToPoints},
          {"localization.robustness.bench",
           "Errors while something goes wrong, on a test bench without images",
           {trouble, which, minutes("6"), valuesParameter()},
           withValues<robustnessOnBench>},
          {"localization.robustness.pictures",
           "Errors while something goes wrong, in the simulator with its images",
           {profileParameter(), trouble, which, minutes("3"), valuesParameter()},
           withValues<robustnessOnImages>},
          {"localization.search",
           "Images until a robot finds where it is, from nothing and carried away (figure 3.8)",
           {profileParameter(), beacons},
           relocalizing},
          {"localization.walk",
           "Errors during a walk of 18 minutes (report 3.3.3.4, experiment 1)",
           {profileParameter(), beacons},
           experiment1}};
}

}  // namespace gt
