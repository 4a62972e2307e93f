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

/// The first robot of a simulation, of which only the motion runs, as it is configured: it does
/// what is requested here, and sees nothing. The other robots of the scene stand still.
class MovedRobot {
 public:
  /// The scene, its configuration, and the motions of a folder, by default the root's; the same
  /// seed gives the same robot and world.
  static Result<std::unique_ptr<MovedRobot>> make(const DataRoot& root,
                                                  const SceneDescription& scene, std::uint64_t seed,
                                                  const std::string& motions = {});
  ~MovedRobot();

  /// Sets parameters of a solution, in the form of its file in config/modules/.
  Result<void> configure(const std::string& task, const std::string& solution,
                         const std::string& text);

  /// What it shall do from the next step on.
  MotionRequest request;
  HeadMotionRequest head;

  /// A tick of 8 ms.
  void step();
  /// So many seconds.
  void run(double seconds);
  /// Until it has been put down and stands.
  void standUp();

  Simulation& simulation() { return *simulation_; }
  World& world() { return simulation_->world(); }
  const RobotBody& body() const { return simulation_->world().robot(0); }
  /// Whether it lies on a side, its nose or its back.
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
