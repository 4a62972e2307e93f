#pragma once
#include <vector>

#include "framework/SolutionTable.h"
#include "network/Vocabulary.h"
#include "robot/Areas.h"
#include "robot/ConfigurationPart.h"

namespace gt {

/// The tasks of a robot, with the solutions that are linked into a program, and the parts of the
/// configuration that the solutions read.
struct RobotModules {
  SolutionTable solutions;
  std::vector<ConfigurationPart> parts;

  /// Representations on every blackboard from the start: the configuration, the robot's identity
  /// and the process's clock.
  std::vector<const RepresentationType*> given() const;
  /// All types of messages between a robot with these modules and its tools.
  std::vector<const RepresentationType*> messageTypes() const;
};

/// All tasks of the robot, without solutions, and the common parts of the configuration.
RobotModules tasks();
/// Adds the motion descriptions, which motion and behavior read.
void addMotionNet(RobotModules& modules);

/// All tasks of the robot and all their solutions.
const RobotModules& allModules();
const SolutionTable& solutions();
/// The message types and schemas that a tool knows of robots.
const Vocabulary& robotVocabulary();

}  // namespace gt
