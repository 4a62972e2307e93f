#pragma once
#include <memory>
#include <vector>

#include "framework/ModuleProcess.h"
#include "representations/infrastructure/Player.h"
#include "robot/Configuration.h"
#include "robot/platform/Platform.h"

namespace gt {

/// The data from which a robot is made: configuration, layout, identity, random seed, the
/// representations sent by its platform, and the hardware address that identifies it in files
/// (report B.4.5).
struct RobotSetup {
  std::shared_ptr<const Configuration> configuration;
  Layout layout;
  Player player;
  std::uint64_t seed = 0;
  std::vector<const RepresentationType*> platform = platformRepresentations();
  std::string address{};
};

/// The parts of the configuration that the modules of a process read, and the camera settings.
std::vector<const RepresentationType*> configurationOf(const ProcessLayout& process,
                                                       const SolutionTable& table);

/// One process of a robot, with the configuration on its blackboard.
std::unique_ptr<ModuleProcess> makeProcess(const Plan::Process& plan, const RobotSetup& setup);
/// Selects the solutions of the process's tasks and sets their parameters, as configured.
Result<void> configureProcess(ModuleProcess& process, const Configuration& configuration);

}  // namespace gt
