#pragma once
#include <optional>

#include "representations/modeling/ObstaclesModel.h"

namespace gt {

// Queries of the behavior about the obstacles around the robot (report 3.5, 3.8.2). All points and
// directions are relative to the robot.

/// The free distance (mm) in a corridor: how far a body of a width (mm) can move in a direction
/// (rad) until it meets an obstacle, at most ObstaclesModel::farAway. The corridor begins at `from`
/// (mm); obstacles beside or behind that point do not count.
double corridor(const ObstaclesModel& obstacles, double direction, double width,
                const Vector2d& from = {0, 0});

/// The direction (rad) nearest to a wanted one in which a corridor of a width (mm) is free as far
/// as `length` (mm), with a difference of at most `most` (rad). Empty if there is none.
std::optional<double> freeDirection(const ObstaclesModel& obstacles, double wanted, double width,
                                    double length, double most = pi, const Vector2d& from = {0, 0});

/// The distance of the nearest obstacle in directions that differ from `middle` by up to
/// `halfRange` (rad), at most ObstaclesModel::farAway (mm).
double nearestObstacle(const ObstaclesModel& obstacles, double middle, double halfRange);

}  // namespace gt
