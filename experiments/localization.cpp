// Measures the Monte-Carlo self-locator against the truth on a test bench without simulator: a
// robot that walks, slips, is blocked, sees landmarks through a narrow camera, and is carried away
// by the referee (report 3.3.2.5 and 3.3.3.4).
#include <functional>
#include <string>
#include <vector>

#include "Experiments.h"
#include "base/Random.h"
#include "base/Statistics.h"
#include "modules/modeling/MonteCarloSelfLocator.h"
#include "modules/modeling/testing/LocalizationTrial.h"

namespace gt {
namespace {

using Parameters = MonteCarloSelfLocator::Parameters;

constexpr int picturesPerMinute = 60 * 1000 / SyntheticRobot::picturePeriod;

/// A self-locator that follows one synthetic robot.
class Locator {
 public:
  Locator(const Parameters& parameters, std::uint64_t seed) : random_{seed} {
    locator_.parameters = parameters;
  }
  RobotPose operator()(const SyntheticRobot& robot) {
    locator_.update(robot.percept, robot.odometry, robot.field, robot.player, estimate_, random_,
                    debug_);
    return estimate_;
  }

 private:
  MonteCarloSelfLocator locator_;
  RobotPose estimate_;
  Random random_;
  Debug debug_{1024};
};

/// What is asked of a row of the walking experiment.
struct WalkingAims {
  Aim mean, median, p95, longestLost;
};

/// The error while a robot walks about, after the first ten seconds.
void walking(Figures& figures, const std::string& name, const Parameters& parameters,
             const SyntheticWorld& world, int minutes, const std::vector<std::uint64_t>& seeds,
             const WalkingAims& aims = {}) {
  std::vector<double> mean, median, p95, below, angle, lost;
  for (const std::uint64_t seed : seeds) {
    SyntheticRobot robot{seed, world};
    Locator locator{parameters, seed};
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
void relocalizing(Figures& figures, const std::string& name, const Parameters& parameters,
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
      Locator locator{parameters, seed * 1000 + i};
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

}  // namespace

Result<void> measureLocalization(Figures& figures, const ExperimentOptions& options) {
  constexpr int minutes = 18;  // as in the report's experiment 1
  const std::vector<std::uint64_t>& seeds = options.seeds;
  const std::string name = "localization.montecarlo";
  const Parameters defaults;
  const SyntheticWorld match;
  // Aims of the project for matches; the report's figures in 3.3.2.5.
  walking(figures, name, defaults, match, minutes, seeds,
          {{}, Aim::atMost(150), Aim::atMost(600), Aim::atMost(15)});
  relocalizing(figures, name, defaults, seeds, Aim::atMost(40), Aim::atMost(40));

  // Experiment 1 of the report (3.3.3.4): 15 cm/s, the head always turning, nothing in the way.
  SyntheticWorld experiment1;
  experiment1.walkingSpeed = 150;
  experiment1.turnsHeadAlways = true;
  experiment1.secondsBetweenBlocks = 1e12;
  walking(figures, name + ".experiment1", defaults, experiment1, minutes, seeds,
          {Aim::atMost(105), {}, {}, {}});

  SyntheticWorld slipping;
  slipping.slip = 0.3;
  walking(figures, name + ".slip30", defaults, slipping, minutes, seeds);
  SyntheticWorld wrong;
  wrong.outliers = 0.1;
  wrong.hiddenPosts = 0.3;
  walking(figures, name + ".outliers10", defaults, wrong, minutes, seeds);

  // What each departure from the report's text gains.
  Parameters literal;
  literal.randomReplacement = 1;
  walking(figures, name + ".allRandom", literal, match, minutes, seeds);
  literal.newProbability = 0.5;
  walking(figures, name + ".literal", literal, match, minutes, seeds);
  relocalizing(figures, name + ".literal", literal, seeds);
  return {};
}

}  // namespace gt
