// Fits how legs give to robots that walk about and to matches (docs/vision.md).
#include <Eigen/Dense>
#include <cmath>

#include "CollisionWatch.h"
#include "Experiments.h"
#include "base/File.h"
#include "base/InParallel.h"
#include "modules/perception/processors/PostureModel.h"
#include "streams/Config.h"

namespace gt {
namespace {

using Features = PostureModel::Features;
using Leaning = Eigen::Matrix<double, 1, 3>;  ///< Height, tilt, roll beside those by legs.

/// The part of the processor's parameters that is fitted.
struct PostureFile {
  PostureModel::Parameters posture;

  static constexpr auto fields() { return Fields{field<&PostureFile::posture>()}; }
};

/// Sums for least squares.
struct PostureSums {
  Eigen::Matrix<double, PostureModel::count, PostureModel::count> squares;
  Eigen::Matrix<double, PostureModel::count, 3> products;
  double n = 0;

  PostureSums() {
    squares.setZero();
    products.setZero();
  }
  void add(const Features& features, const Leaning& leaning) {
    squares += features * features.transpose();
    products += features * leaning;
    n += 1;
  }
  void add(const PostureSums& other) {
    squares += other.squares;
    products += other.products;
    n += other.n;
  }
};

/// Robots walk about and play for a minute each, in both fidelities.
Result<PostureSums> sumPostures(const DataRoot& root, std::uint64_t seed) {
  constexpr double minutes = 1;
  constexpr int every = 3;  // ticks: neighbors are alike
  const RobotDimensions robot;
  PostureSums sums;
  for (const char* fidelity : {"dynamic", "kinematic"}) {
    Job job;
    job.seed = seed;
    job.parameters = {{"profile", "padova"}, {"fidelity", fidelity}};
    std::vector<int> stood;  // ticks
    const auto observe = [&](std::size_t index, const CollisionFrame& frame) {
      if (stood.size() <= index) stood.resize(index + 1);
      stood[index] = frame.counts && frame.motion.stable ? stood[index] + 1 : 0;
      if (stood[index] < SensorDataBuffer::capacity || stood[index] % every != 0) return;
      const SensorData& now = frame.sensors.newest();
      const BodyPosture legs = bodyPosture(robot, now.joints);
      sums.add(PostureModel::featuresAt(robot, frame.sensors, now.time),
               {frame.body.height - legs.height, frame.body.tilt - legs.tilt, frame.body.roll});
    };
    if (auto walked = observeWalks(job, root, minutes, observe); !walked) return walked.error();
    stood.clear();
    if (auto played = observePlay(job, root, minutes, observe); !played) return played.error();
  }
  return sums;
}

PostureModel::Parameters weightsOf(const PostureSums& sums) {
  constexpr double ridge = 1e-4;
  Features pull = Features::Constant(ridge * sums.n);
  pull[0] = 0;
  const Eigen::MatrixXd squares = sums.squares + Eigen::MatrixXd{pull.asDiagonal()};
  const Eigen::MatrixXd weights = squares.ldlt().solve(sums.products);
  PostureModel::Parameters parameters;
  const std::array columns{&parameters.height, &parameters.tilt, &parameters.roll};
  for (std::size_t column = 0; column < columns.size(); ++column)
    for (std::size_t i = 0; i < columns[column]->size(); ++i) {
      const double weight =
          weights(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(column));
      (*columns[column])[i] = std::round(1e5 * weight) / 1e5;
    }
  return parameters;
}

}  // namespace

Result<void> calibratePosture(const std::vector<std::uint64_t>& seeds, const DataRoot& root,
                              unsigned threads) {
  auto results =
      inParallel(seeds.size(), threads, [&](std::size_t i) { return sumPostures(root, seeds[i]); });
  PostureSums sums;
  for (auto& result : results) {
    if (!result) return result.error();
    sums.add(*result);
  }
  return writeFile(
      root.path("config/modules/SensorDataProcessor.Default.cfg"),
      "// Written by `experiment calibrate-posture`: how bodies lean on legs that give.\n" +
          writeConfig(PostureFile{weightsOf(sums)}));
}

}  // namespace gt
