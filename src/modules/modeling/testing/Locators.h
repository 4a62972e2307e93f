#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

#include "base/Random.h"
#include "debug/Debug.h"
#include "modules/modeling/testing/SyntheticRobot.h"
#include "representations/modeling/RobotPose.h"
#include "streams/Config.h"

namespace gt {

/// All inputs of self-locators after an image.
struct Seen {
  const LandmarksPercept& landmarks;
  const LinesPercept& lines;
  const CameraMatrix& camera;
  const OdometryData& odometry;
  const FieldDimensions& field;
  const Player& player;
};

/// The inputs provided by a simulated robot: SyntheticRobot or another class with members of these
/// names.
template <typename Robot>
Seen seenBy(const Robot& robot) {
  return {robot.percept, robot.lines, robot.camera, robot.odometry, robot.field, robot.player};
}

/// A self-locator of any class, with its random numbers and its last estimate.
class AnyLocator {
 public:
  virtual ~AnyLocator() = default;
  virtual const RobotPose& operator()(const Seen& seen) = 0;
  /// Reads parameters from a file in the config format.
  virtual Result<void> configure(const std::string& file) = 0;
};

/// Calls a solution's update with the values that its signature requires.
template <typename Solution>
class LocatorOf final : public AnyLocator {
 public:
  LocatorOf(const typename Solution::Parameters& parameters, std::uint64_t seed) : random_{seed} {
    solution_.parameters = parameters;
  }
  const RobotPose& operator()(const Seen& seen) override {
    call(seen, &Solution::update);
    return estimate_;
  }
  Result<void> configure(const std::string& file) override {
    return readConfig(file, solution_.parameters);
  }
  Solution& solution() { return solution_; }

 private:
  template <typename... A>
  void call(const Seen& seen, void (Solution::*update)(A...)) {
    (solution_.*update)(pick<A>(seen)...);
  }
  template <typename A>
  auto& pick(const Seen& seen) {
    using T = std::remove_cvref_t<A>;
    if constexpr (std::is_same_v<T, LandmarksPercept>)
      return seen.landmarks;
    else if constexpr (std::is_same_v<T, LinesPercept>)
      return seen.lines;
    else if constexpr (std::is_same_v<T, CameraMatrix>)
      return seen.camera;
    else if constexpr (std::is_same_v<T, OdometryData>)
      return seen.odometry;
    else if constexpr (std::is_same_v<T, FieldDimensions>)
      return seen.field;
    else if constexpr (std::is_same_v<T, Player>)
      return seen.player;
    else if constexpr (std::is_same_v<T, RobotPose>)
      return estimate_;
    else if constexpr (std::is_same_v<T, Random>)
      return random_;
    else
      return debug_;
  }

  Solution solution_;
  RobotPose estimate_;
  Random random_;
  Debug debug_{1024};
};

/// A kind of self-locator with its names in comparisons.
struct LocatorKind {
  std::string name;        ///< Name in the names of figures.
  std::string solution;    ///< Name in configurations.
  bool usesEdges = false;  ///< Whether it uses edges, so that it needs no beacons.
  std::function<std::unique_ptr<AnyLocator>(std::uint64_t seed)> make;
};

/// All self-locators with their default parameters.
std::vector<LocatorKind> locatorKinds();

}  // namespace gt
