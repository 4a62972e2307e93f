// Measures the self-locators against the truth on a test bench without simulator: a robot that
// walks, slips, is blocked, sees landmarks through a narrow camera, and is carried away by the
// referee (report 3.3.2.5 and 3.3.3.4).
#include <functional>
#include <string>
#include <vector>

#include "Experiments.h"
#include "base/Random.h"
#include "base/Statistics.h"
#include "modules/behavior/BasicBehaviors.h"
#include "modules/modeling/FusionSelfLocator.h"
#include "modules/modeling/MonteCarloSelfLocator.h"
#include "modules/modeling/SingleLandmarkSelfLocator.h"
#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

constexpr int picturesPerMinute = 60 * 1000 / SyntheticRobot::picturePeriod;

/// A self-locator that follows one synthetic robot.
template <typename Solution>
class Locator {
 public:
  Locator(const typename Solution::Parameters& parameters, std::uint64_t seed) : random_{seed} {
    locator_.parameters = parameters;
  }
  RobotPose operator()(const SyntheticRobot& robot) {
    if constexpr (std::is_same_v<Solution, SingleLandmarkSelfLocator>)
      locator_.update(robot.percept, robot.odometry, robot.field, robot.player, estimate_, debug_);
    else
      locator_.update(robot.percept, robot.odometry, robot.field, robot.player, estimate_, random_,
                      debug_);
    return estimate_;
  }

 private:
  Solution locator_;
  RobotPose estimate_;
  Random random_;
  Debug debug_{1024};
};

/// What is asked of a row of the walking experiment.
struct WalkingAims {
  Aim mean, median, p95, longestLost;
};

/// The error while a robot walks about, after the first ten seconds.
template <typename Solution>
void walking(Figures& figures, const std::string& name,
             const typename Solution::Parameters& parameters, const SyntheticWorld& world,
             int minutes, const std::vector<std::uint64_t>& seeds, const WalkingAims& aims = {}) {
  std::vector<double> mean, median, p95, below, angle, lost;
  for (const std::uint64_t seed : seeds) {
    SyntheticRobot robot{seed, world};
    Locator<Solution> locator{parameters, seed};
    follow(robot, picturesPerMinute / 6, locator);
    const LocalizationTrial trial = follow(robot, minutes * picturesPerMinute, locator);
    mean.push_back(gt::mean(trial.errors));
    median.push_back(quantile(trial.errors, 0.5));
    p95.push_back(quantile(trial.errors, 0.95));
    const auto belowMean = std::count_if(trial.errors.begin(), trial.errors.end(),
                                         [&](double e) { return e < mean.back(); });
    below.push_back(100 * static_cast<double>(belowMean) /
                    static_cast<double>(trial.errors.size()));
    angle.push_back(toDegrees(quantile(trial.angles, 0.5)));
    lost.push_back(trial.longestLost);
  }
  figures.add(name + ".error.mean", "mm", mean, aims.mean);
  figures.add(name + ".error.median", "mm", median, aims.median);
  figures.add(name + ".error.p95", "mm", p95, aims.p95);
  figures.add(name + ".error.belowMean", "%", below);
  figures.add(name + ".angle.median", "deg", angle);
  figures.add(name + ".lost.longest", "s", lost, aims.longestLost);
}

/// Pictures until the pose is within 20 cm and stays: from nothing, and after the referee has put
/// the robot elsewhere, while it stands and turns its head (report, figure 3.8).
template <typename Solution>
void relocalizing(Figures& figures, const std::string& name,
                  const typename Solution::Parameters& parameters,
                  const std::vector<std::uint64_t>& seeds, Aim first = {}, Aim again = {}) {
  constexpr int trials = 20, most = 1000;
  std::vector<double> fromNothing, kidnapped, worst;
  SyntheticWorld standing;
  standing.walks = false;
  standing.turnsHeadAlways = true;
  for (const std::uint64_t seed : seeds) {
    std::vector<double> a, b;
    for (std::uint64_t i = 0; i < trials; ++i) {
      SyntheticRobot robot{seed * 1000 + i, standing};
      Locator<Solution> locator{parameters, seed * 1000 + i};
      a.push_back(picturesUntilLocalized(robot, most, locator));
      follow(robot, 100, locator);
      robot.kidnap();
      b.push_back(picturesUntilLocalized(robot, most, locator));
    }
    fromNothing.push_back(quantile(a, 0.5));
    kidnapped.push_back(quantile(b, 0.5));
    worst.push_back(std::max(quantile(a, 1), quantile(b, 1)));
  }
  figures.add(name + ".fromNothing.median", "pictures", fromNothing, first);
  figures.add(name + ".kidnapped.median", "pictures", kidnapped, again);
  figures.add(name + ".relocalizing.worst", "pictures", worst);
}

/// How far a robot stands off when it has walked to a point, and how far its estimate is off then.
struct Arrival {
  double ofRobot, ofEstimate;
};

/// Walks to a point by the behavior's own skill, until it has stood for half a second (or for two
/// minutes, where it does not come to rest).
template <typename Locate>
Arrival goTo(const Pose2D& goal, SyntheticRobot& robot, Locate&& locate) {
  WorldState world;
  MotionRequest request;
  const Movement::Parameters parameters;
  Movement movement{world, request, parameters};
  GoToPoint goToPoint{movement};
  goToPoint.x = goal.translation.x();
  goToPoint.y = goal.translation.y();
  goToPoint.angle = toDegrees(goal.rotation);
  goToPoint.maxSpeed = 150;
  int stood = 0;
  for (int i = 0; i < 2 * picturesPerMinute && stood < 12; ++i) {
    world.self = locate(robot);
    goToPoint.execute();
    const bool stands = request.type == MotionType::stand;
    stood = stands ? stood + 1 : 0;
    robot.step(stands ? Pose2D{} : request.walk);
  }
  return {(robot.pose.translation - goal.translation).norm(),
          (locate(robot).pose.translation - robot.pose.translation).norm()};
}

/// Experiment 2 of the report (3.3.3.4): 68 random points, reached by go-to-point, with the head
/// always turning.
template <typename Solution>
void goingToPoints(Figures& figures, const std::string& name,
                   const typename Solution::Parameters& parameters, const SyntheticWorld& world,
                   const std::vector<std::uint64_t>& seeds, Aim stop = {}, Aim estimate = {}) {
  constexpr int points = 68;
  std::vector<double> ofRobot, ofEstimate, p95;
  for (const std::uint64_t seed : seeds) {
    SyntheticRobot robot{seed, world};
    Locator<Solution> locator{parameters, seed};
    Random random{seed};
    follow(robot, picturesPerMinute / 6, locator);
    std::vector<double> stops, estimates;
    for (int i = 0; i < points; ++i) {
      const double angle = pi * random.symmetric();
      const double x = 0.85 * robot.field.xGroundline * random.symmetric();
      const double y = 0.85 * robot.field.ySideline * random.symmetric();
      const Arrival arrival = goTo({angle, x, y}, robot, locator);
      stops.push_back(arrival.ofRobot);
      estimates.push_back(arrival.ofEstimate);
    }
    ofRobot.push_back(mean(stops));
    ofEstimate.push_back(mean(estimates));
    p95.push_back(quantile(stops, 0.95));
  }
  figures.add(name + ".stop.mean", "mm", ofRobot, stop);
  figures.add(name + ".stop.p95", "mm", p95);
  figures.add(name + ".estimate.mean", "mm", ofEstimate, estimate);
}

/// The report's experiments (3.3.3.4, figure 3.8), and what a match is like.
template <typename Solution>
void measure(Figures& figures, const std::string& name, const std::vector<std::uint64_t>& seeds,
             const WalkingAims& match = {}, Aim found = {}, Aim walked = {}, Aim stop = {},
             Aim estimate = {}) {
  constexpr int minutes = 18;  // as in the report's experiment 1
  const typename Solution::Parameters defaults;
  walking<Solution>(figures, name, defaults, {}, minutes, seeds, match);
  relocalizing<Solution>(figures, name, defaults, seeds, found, found);
  // 15 cm/s, the head always turning, nothing in the way.
  SyntheticWorld quiet;
  quiet.walkingSpeed = 150;
  quiet.turnsHeadAlways = true;
  quiet.secondsBetweenBlocks = 1e12;
  walking<Solution>(figures, name + ".experiment1", defaults, quiet, minutes, seeds,
                    {walked, {}, {}, {}});
  goingToPoints<Solution>(figures, name + ".experiment2", defaults, quiet, seeds, stop, estimate);
}

}  // namespace

Result<void> measureLocalization(Figures& figures, const ExperimentOptions& options) {
  using MonteCarlo = MonteCarloSelfLocator;
  constexpr int minutes = 18;
  const std::vector<std::uint64_t>& seeds = options.seeds;
  const std::string name = "localization.montecarlo";
  // Aims of the project; the report has 14 to 40 pictures (figure 3.8), 105, 94 and 84 mm
  // (3.3.3.4).
  measure<MonteCarlo>(figures, name, seeds,
                      {{}, Aim::atMost(150), Aim::atMost(600), Aim::atMost(15)}, Aim::atMost(10),
                      Aim::atMost(50), Aim::atMost(40), Aim::atMost(30));
  measure<SingleLandmarkSelfLocator>(figures, "localization.singlelandmark", seeds);
  measure<FusionSelfLocator>(figures, "localization.fusion", seeds);
  MonteCarlo::Parameters few;
  few.samples = 30;
  walking<MonteCarlo>(figures, name + ".30samples", few, {}, minutes, seeds);
  relocalizing<MonteCarlo>(figures, name + ".30samples", few, seeds);

  const MonteCarlo::Parameters defaults;
  SyntheticWorld slipping;
  slipping.slip = 0.3;
  walking<MonteCarlo>(figures, name + ".slip30", defaults, slipping, minutes, seeds);
  SyntheticWorld wrong;
  wrong.outliers = 0.1;
  wrong.hiddenPosts = 0.3;
  walking<MonteCarlo>(figures, name + ".outliers10", defaults, wrong, minutes, seeds);

  // What each departure from the report's text gains.
  MonteCarlo::Parameters literal;
  literal.templates.randomReplacement = 1;
  walking<MonteCarlo>(figures, name + ".allRandom", literal, {}, minutes, seeds);
  literal.templates.newProbability = 0.5;
  walking<MonteCarlo>(figures, name + ".literal", literal, {}, minutes, seeds);
  relocalizing<MonteCarlo>(figures, name + ".literal", literal, seeds);
  return {};
}

}  // namespace gt
