#pragma once

namespace gt {

struct RobotModules;

/// Adds the solutions of one area's tasks; the first solution of a task is its default (report,
/// chapter 3's table). Each function has a file of its own, so that the program of a process links
/// only the solutions that it needs (report 2.2.4).
void addPerception(RobotModules& modules);
void addModeling(RobotModules& modules);
void addBehavior(RobotModules& modules);
void addMotion(RobotModules& modules);

}  // namespace gt
