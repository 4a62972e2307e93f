#pragma once
#include <memory>
#include <string>

#include "base/DataRoot.h"
#include "base/Result.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/motion/HeadMotionRequest.h"
#include "representations/motion/MotionInfo.h"
#include "representations/motion/OdometryData.h"
#include "simulation/Simulation.h"

namespace gt {

/// The first robot of a simulation, of which only the configured motion runs. It executes the given
/// motion requests and has no vision. The other robots of the scene stand still.
class MovedRobot {
 public:
  /// Uses the scene, its configuration, and the motions of a folder, by default those of the root.
  /// The same seed yields the same robot and world.
  static Result<std::unique_ptr<MovedRobot>> make(const DataRoot& root,
                                                  const SceneDescription& scene, std::uint64_t seed,
                                                  const std::string& motions = {});
  ~MovedRobot();

  /// Sets parameters of a solution, in the format of its file in config/modules/.
  Result<void> configure(const std::string& task, const std::string& solution,
                         const std::string& text);

  /// The motion request from the next step on.
  MotionRequest request;
  HeadMotionRequest head;

  /// Simulates a tick of 8 ms.
  void step();
  /// Simulates a number of seconds.
  void run(double seconds);
  /// Simulates until the robot has been put down and stands.
  void standUp();

  Simulation& simulation() { return *simulation_; }
  World& world() { return simulation_->world(); }
  const RobotBody& body() const { return simulation_->world().robot(0); }
  /// Whether the robot lies on a side, its nose or its back.
  bool hasFallen() const;
  const MotionInfo& motion() const;
  const OdometryData& odometry() const;

 private:
  class Program;

  MovedRobot() = default;

  std::unique_ptr<Simulation> simulation_;
  Program* program_ = nullptr;  ///< Owned by the simulation.
};

}  // namespace gt
