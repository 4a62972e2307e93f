#pragma once
#include "debug/Debug.h"
#include "modules/modeling/selflocator/EdgeModel.h"
#include "modules/modeling/selflocator/ParticleSet.h"
#include "representations/modeling/RobotPose.h"

namespace gt {

/// Draws the pose estimated by a self-locator, if requested.
void drawPose(const Pose2D& pose, Debug& debug);

/// Draws the particles and the pose computed from them, if requested (report, figure 3.8).
void draw(const ParticleSet& particles, const RobotPose& robotPose, Debug& debug);

/// Draws the chosen points on edges as seen from the pose, each with a line to the closest model
/// point, and the distance of each place from the edges of each type (report, figure 3.9), if
/// requested.
void draw(const EdgeModel& edges, const FieldDimensions& field, const Pose2D& pose, Debug& debug);

}  // namespace gt
