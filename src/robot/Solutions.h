#pragma once
#include "framework/SolutionTable.h"

namespace gt {

/// All tasks of the robot, without solutions.
SolutionTable tasks();
/// The solutions of one area's tasks, the first of a task is its default (report, chapter 3's
/// table). Each in a file of its own, so that a process's program links only what it needs (report
/// 2.2.4).
void addPerceptionSolutions(SolutionTable& table);
void addModelingSolutions(SolutionTable& table);
void addBehaviorSolutions(SolutionTable& table);
void addMotionSolutions(SolutionTable& table);

/// All tasks of the robot and all their solutions.
const SolutionTable& solutions();

}  // namespace gt
