#pragma once

namespace gt {

struct RobotModules;

/// The solutions of one area's tasks, the first of a task is its default (report, chapter 3's
/// table). Each in a file of its own, so that a process's program links only what it needs (report
/// 2.2.4).
void addPerception(RobotModules& modules);
void addModeling(RobotModules& modules);
void addBehavior(RobotModules& modules);
void addMotion(RobotModules& modules);

}  // namespace gt
