#pragma once
#include <optional>

#include "representations/modeling/ObstaclesModel.h"

namespace gt {

// What the behavior asks the obstacles around the robot (report 3.5, 3.8.2). All points are
// relative to the robot.

/// How far a body of a width (mm) can move in a direction (rad) until it meets an obstacle: the
/// free distance in a corridor, at most ObstaclesModel::farAway. It begins at `from` (mm);
/// obstacles beside or behind that are not met.
double corridor(const ObstaclesModel& obstacles, double direction, double width,
                const Vector2d& from = {0, 0});

/// The direction nearest to a wanted one in which a corridor is free as far as `length` (mm), not
/// further off it than `most` (rad). Empty if there is none.
std::optional<double> freeDirection(const ObstaclesModel& obstacles, double wanted, double width,
                                    double length, double most = pi, const Vector2d& from = {0, 0});

/// The distance of the nearest obstacle in directions around one (rad), at most
/// ObstaclesModel::farAway (mm).
double nearestObstacle(const ObstaclesModel& obstacles, double middle, double halfRange);

}  // namespace gt
