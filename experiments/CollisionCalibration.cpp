// Fits both collision detectors to robots that walk about and to matches (docs/worldmodel.md).
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "CollisionWatch.h"
#include "Experiments.h"
#include "base/File.h"
#include "base/InParallel.h"
#include "base/Statistics.h"
#include "modules/motion/collisions/MotorModelCollisionDetector.h"
#include "modules/motion/collisions/ReportCollisionDetector.h"
#include "streams/Config.h"

namespace gt {
namespace {

using Detector = MotorModelCollisionDetector;

/// What is recorded with each seed. The dynamic fidelity is the truth; in the kinematic one only
/// the contacts are to be told as well.
constexpr struct Source {
  const char* fidelity;
  bool play;
  double minutes;
  bool setsThreshold = false;  ///< By its false alarms.
} sources[]{{"dynamic", false, 2},
            {"dynamic", true, 6, true},
            {"kinematic", false, 2},
            {"kinematic", true, 2}};
constexpr double alarms = 0.35;  // a minute of free play, at which the threshold is set

/// What a robot did in a tick, as short as it can be kept.
struct Tick {
  std::array<float, legJoints> commands, measured;
  std::array<float, 3> acceleration, walk;
  MotionType type;
  WalkType walkType;
  bool arriving;
  bool free = false, held = false;
};

struct Recording {
  std::vector<Tick> ticks;
  const Source* source = nullptr;
};

Tick tickOf(const CollisionFrame& frame) {
  Tick tick{};
  const SensorData& measured = frame.sensors.newest();
  const MotionRequest& executed = frame.motion.executed;
  for (std::size_t j = 0; j < legJoints; ++j) {
    tick.commands[j] = static_cast<float>(frame.commanded.angles.values[firstLegJoint + j]);
    tick.measured[j] = static_cast<float>(measured.joints.values[firstLegJoint + j]);
  }
  for (int k = 0; k < 3; ++k)
    tick.acceleration[static_cast<std::size_t>(k)] = static_cast<float>(measured.acceleration[k]);
  tick.walk = {static_cast<float>(executed.walk.translation.x()),
               static_cast<float>(executed.walk.translation.y()),
               static_cast<float>(executed.walk.rotation)};
  tick.type = executed.type;
  tick.walkType = executed.walkType;
  tick.arriving = frame.motion.arriving;
  return tick;
}

/// A tick as detectors take it.
struct Playback {
  void set(const Tick& tick) {
    SensorData& measured = sensors.frames.back();
    measured.time.ms += static_cast<std::int64_t>(tickMs);
    for (std::size_t j = 0; j < legJoints; ++j) {
      joints.angles.values[firstLegJoint + j] = tick.commands[j];
      measured.joints.values[firstLegJoint + j] = tick.measured[j];
    }
    for (int k = 0; k < 3; ++k)
      measured.acceleration[k] = tick.acceleration[static_cast<std::size_t>(k)];
    motion.executed.walk = {tick.walk[2], {tick.walk[0], tick.walk[1]}};
    motion.executed.type = tick.type;
    motion.executed.walkType = tick.walkType;
    motion.arriving = tick.arriving;
  }
  SensorDataBuffer sensors;
  JointData joints;
  MotionInfo motion;
};

/// Records all robots while they walk about, or play.
Result<std::vector<Recording>> record(const DataRoot& root, std::uint64_t seed,
                                      const Source& source) {
  Job job;
  job.seed = seed;
  job.parameters = {{"profile", "padova"}, {"fidelity", source.fidelity}};
  std::vector<Recording> recordings;
  std::vector<HoldUp> holdUps;
  const auto observe = [&](std::size_t robot, const CollisionFrame& frame) {
    if (recordings.size() <= robot) {
      recordings.resize(robot + 1, {{}, &source});
      holdUps.resize(robot + 1);
    }
    std::vector<Tick>& ticks = recordings[robot].ticks;
    ticks.push_back(tickOf(frame));
    if (holdUps[robot].add(frame) != HoldUp::Ended::none)
      std::for_each(ticks.end() - HoldUp::window, ticks.end(),
                    [](Tick& tick) { tick.held = true; });
    ticks.back().free = holdUps[robot].free();
  };
  auto done = source.play ? observePlay(job, root, source.minutes, observe)
                          : observeWalks(job, root, source.minutes, observe);
  if (!done) return done.error();
  return recordings;
}

Result<std::vector<Recording>> recordAll(const DataRoot& root, std::uint64_t seed) {
  std::vector<Recording> all;
  for (const Source& source : sources) {
    auto some = record(root, seed, source);
    if (!some) return some.error();
    std::ranges::move(*some, std::back_inserter(all));
  }
  return all;
}

/// Calls with each tick of a recording and with the features until then.
template <typename Use>
void follow(const Recording& recording, const Detector::Parameters& parameters, Use&& use) {
  static const Detector::Walk unknown;
  CollisionFeatures features;
  Playback now;
  for (const Tick& tick : recording.ticks) {
    now.set(tick);
    const Detector::Walk* walk = parameters.of(tick.walkType);
    features.add(now.sensors.newest(), now.joints, now.motion, (walk ? *walk : unknown).motors);
    use(tick, features, walk);
  }
}

/// Least squares over free walks.
void fitMotors(const std::vector<Recording>& recordings, Detector::Parameters& parameters,
               Detector::Walk& fitted) {
  constexpr int size = static_cast<int>(motorLag) + 1;
  constexpr double ridge = 1e-3;
  using Row = Eigen::Matrix<double, size, 1>;
  using Squares = Eigen::Matrix<double, size, size>;
  std::array<Squares, legJoints> squares;
  std::array<Row, legJoints> products;
  squares.fill(ridge * Squares::Identity());
  products.fill(Row::Zero());
  for (const Recording& recording : recordings)
    follow(recording, parameters,
           [&](const Tick& tick, const CollisionFeatures& features, auto* walk) {
             if (walk != &fitted || !tick.free || !features.ready()) return;
             for (std::size_t j = 0; j < legJoints; ++j) {
               const auto commands = features.commandsOf(j);
               Row row = Row::Ones();
               std::ranges::copy(commands, row.data());
               squares[j] += row * row.transpose();
               products[j] += tick.measured[j] * row;
             }
           });
  for (std::size_t j = 0; j < legJoints; ++j) {
    const Row solution = squares[j].ldlt().solve(products[j]);
    std::ranges::copy(solution, fitted.motors[j].begin());
  }
}

/// The features of some ticks.
struct Examples {
  std::vector<CollisionFeatures::Values> free, held;
};

/// Logistic regression by Newton's method, with a ridge on features of variance 1. Both classes
/// weigh the same.
void fitDecision(const Examples& examples, Detector::Walk& walk) {
  constexpr double ridge = 10;
  constexpr int rounds = 20;
  const auto n = static_cast<int>(examples.free.size() + examples.held.size());
  constexpr int d = static_cast<int>(CollisionFeatures::count);
  Eigen::MatrixXd x(n, d + 1);
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(n), heavy = Eigen::VectorXd::Ones(n);
  int row = 0;
  for (const auto* some : {&examples.free, &examples.held})
    for (const auto& values : *some) {
      for (int k = 0; k < d; ++k) x(row, k) = values[static_cast<std::size_t>(k)];
      x(row, d) = 1;
      if (some == &examples.held) {
        wanted[row] = 1;
        heavy[row] =
            static_cast<double>(examples.free.size()) / static_cast<double>(examples.held.size());
      }
      ++row;
    }
  const Eigen::RowVectorXd middle = x.leftCols(d).colwise().mean();
  x.leftCols(d).rowwise() -= middle;
  const Eigen::RowVectorXd spread =
      (x.leftCols(d).colwise().squaredNorm() / n).cwiseSqrt().array() + 1e-9;
  x.leftCols(d).array().rowwise() /= spread.array();
  Eigen::VectorXd w = Eigen::VectorXd::Zero(d + 1), pull = Eigen::VectorXd::Constant(d + 1, ridge);
  pull[d] = 1e-6;
  for (int round = 0; round < rounds; ++round) {
    const Eigen::ArrayXd p = 1 / (1 + (-(x * w).array().max(-30).min(30)).exp());
    const Eigen::VectorXd gradient =
        x.transpose() * (heavy.array() * (p - wanted.array())).matrix() + pull.cwiseProduct(w);
    const Eigen::VectorXd curvature = heavy.array() * p * (1 - p);
    Eigen::MatrixXd hessian = x.transpose() * curvature.asDiagonal() * x;
    hessian.diagonal() += pull;
    w -= hessian.ldlt().solve(gradient);
  }
  const Eigen::VectorXd scaled = w.head(d).cwiseQuotient(spread.transpose());
  std::copy_n(scaled.data(), d, walk.weights.begin());
  walk.constant = w[d] - middle.dot(scaled);
}

Examples examplesOf(const std::vector<Recording>& recordings,
                    const Detector::Parameters& parameters, const Detector::Walk& of) {
  constexpr int each = 20;  // one of so many free ticks: neighbors are alike
  Examples examples;
  int seen = 0;
  for (const Recording& recording : recordings)
    follow(recording, parameters,
           [&](const Tick& tick, const CollisionFeatures& features, auto* walk) {
             if (walk != &of || !features.ready()) return;
             if (tick.held)
               examples.held.push_back(features.values());
             else if (tick.free && seen++ % each == 0)
               examples.free.push_back(features.values());
           });
  return examples;
}

/// By how much scores have to be lower so that no more alarms are false in free play, in the
/// dynamic fidelity.
double thresholdOf(const std::vector<Recording>& recordings,
                   const Detector::Parameters& parameters) {
  constexpr float none = -1e9F;
  std::vector<std::vector<float>> scores;
  std::vector<const Recording*> played;
  double freeMinutes = 0;
  for (const Recording& recording : recordings) {
    if (!recording.source->setsThreshold) continue;
    played.push_back(&recording);
    std::vector<float>& of = scores.emplace_back();
    follow(recording, parameters,
           [&](const Tick& tick, const CollisionFeatures& features, auto* walk) {
             of.push_back(walk && features.ready()
                              ? static_cast<float>(walk->score(features.values()))
                              : none);
             freeMinutes += tick.free ? tickSeconds / 60 : 0;
           });
  }
  const auto falseAlarms = [&](double threshold) {
    int count = 0;
    for (std::size_t i = 0; i < played.size(); ++i) {
      int above = 0;
      for (std::size_t t = 0; t < scores[i].size(); ++t) {
        above = scores[i][t] > threshold ? above + 1 : 0;
        count += above == parameters.inARow && played[i]->ticks[t].free;
      }
    }
    return count / freeMinutes;
  };
  double threshold = -5;
  while (threshold < 15 && falseAlarms(threshold) > alarms) threshold += 0.05;
  return threshold;
}

Detector::Parameters fitted(const std::vector<Recording>& recordings) {
  Detector::Parameters parameters;
  const auto round = [](double& number) { number = std::round(1e4 * number) / 1e4; };
  const std::array walks{&parameters.normal, &parameters.fast, &parameters.dribble};
  for (Detector::Walk* walk : walks) {
    fitMotors(recordings, parameters, *walk);
    for (auto& motor : walk->motors) std::ranges::for_each(motor, round);
  }
  for (Detector::Walk* walk : walks) {
    fitDecision(examplesOf(recordings, parameters, *walk), *walk);
    std::ranges::for_each(walk->weights, round);
  }
  const double threshold = thresholdOf(recordings, parameters);
  for (Detector::Walk* walk : walks) round(walk->constant -= threshold);
  return parameters;
}

/// The sums of squared differences of report 3.6 in free walks, by gait and speed.
using FreeSums = EnumArray<Gait, std::array<std::vector<double>, ReportCollisionDetector::speeds>>;

FreeSums freeSums(const std::vector<Recording>& recordings) {
  FreeSums sums;
  for (const Recording& recording : recordings) {
    // With a threshold of 1 the strength is the sum itself.
    ReportCollisionDetector detector;
    for (auto& table : detector.parameters.thresholds) table.fill(1);
    Playback now;
    CollisionPercept percept;
    Debug debug{1024};
    for (const Tick& tick : recording.ticks) {
      now.set(tick);
      detector.update(now.sensors, now.joints, now.motion, percept, debug);
      debug.out().clear();
      const auto [gait, speed] = ReportCollisionDetector::placeOf(now.motion.executed);
      if (tick.free && percept.strength > 0) sums[gait][speed].push_back(percept.strength);
    }
  }
  return sums;
}

/// Each threshold a little above what nearly all sums of a free walk stay below; where there was no
/// such walk, that of the next slower one.
ReportCollisionDetector::Parameters thresholdsAbove(const FreeSums& sums) {
  constexpr double nearlyAll = 0.999, margin = 1.1;
  constexpr std::size_t enough = 500;
  ReportCollisionDetector::Parameters calibrated;
  for (std::size_t g = 0; g < enumCount<Gait>; ++g)
    for (std::size_t speed = 0; speed < ReportCollisionDetector::speeds; ++speed) {
      auto& table = calibrated.thresholds.values[g];
      const std::vector<double>& seen = sums.values[g][speed];
      if (seen.size() >= enough)
        table[speed] = margin * quantile(seen, nearlyAll);
      else if (speed > 0)
        table[speed] = std::max(table[speed], table[speed - 1]);
    }
  return calibrated;
}

template <typename Parameters>
Result<void> write(const DataRoot& root, const char* solution, const char* sentence,
                   const Parameters& parameters) {
  return writeFile(root.path(std::string{"config/modules/CollisionDetector."} + solution + ".cfg"),
                   std::string{"// Written by `experiment calibrate-collisions`: "} + sentence +
                       "\n" + writeConfig(parameters));
}

}  // namespace

Result<void> calibrateCollisions(const std::vector<std::uint64_t>& seeds, const DataRoot& root,
                                 unsigned threads) {
  auto results =
      inParallel(seeds.size(), threads, [&](std::size_t i) { return recordAll(root, seeds[i]); });
  std::vector<Recording> recordings;
  for (auto& result : results) {
    if (!result) return result.error();
    std::ranges::move(*result, std::back_inserter(recordings));
  }
  if (auto done = write(root, "MotorModel", "how legs follow, and look while something holds them.",
                        fitted(recordings));
      !done)
    return done;
  return write(root, "Report", "above what legs lag in free walks.",
               thresholdsAbove(freeSums(recordings)));
}

}  // namespace gt
