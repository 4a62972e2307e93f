#pragma once
#include <vector>

#include "framework/SolutionTable.h"
#include "network/Vocabulary.h"
#include "robot/Areas.h"
#include "robot/ConfigurationPart.h"

namespace gt {

/// What a program has of a robot: all tasks, with the solutions that are linked into it, and the
/// parts of the configuration that these read.
struct RobotModules {
  SolutionTable solutions;
  std::vector<ConfigurationPart> parts;

  /// What lies on every blackboard from the start: the configuration, who the robot is and the
  /// process's clock.
  std::vector<const RepresentationType*> given() const;
  /// All types of messages between a robot with these modules and its tools.
  std::vector<const RepresentationType*> messageTypes() const;
};

/// All tasks of the robot, without solutions, and what every process may read.
RobotModules tasks();
/// The motion descriptions, which motion and behavior read.
void addMotionNet(RobotModules& modules);

/// All tasks of the robot and all their solutions.
const RobotModules& allModules();
const SolutionTable& solutions();
/// What a tool knows of robots.
const Vocabulary& robotVocabulary();

}  // namespace gt
