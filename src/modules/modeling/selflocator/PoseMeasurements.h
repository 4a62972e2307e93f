#pragma once
#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/EdgeModel.h"
#include "modules/modeling/selflocator/PoseHypothesis.h"

namespace gt {

/// The measurement of a bearing on the edge of a flag or a goal, relative to a hypothesis (report
/// (3.10)). `cameraOffset` is the camera's position relative to the robot (mm), `variance` that of
/// the bearing, `panVariance` that of the camera's pan (rad^2).
ScalarMeasurement measurementOf(const Bearing& bearing, const Vector2d& cameraOffset,
                                const PoseHypothesis& hypothesis, double variance,
                                double panVariance);

/// The measurement of the distance of a flag that stands at `position` (mm, on the field), relative
/// to a pose. `relativeError` is its standard deviation as a share of the distance.
ScalarMeasurement measurementOf(const FlagPercept& flag, const Vector2d& position,
                                const Pose2D& pose, double relativeError);

/// Standard deviations of what a point on an edge depends on: of the edge's place (mm), of the
/// point's elevation, and of the camera's tilt and pan (rad).
struct EdgeErrors {
  double edge, elevation, tilt, pan;
};

/// The measurement of a point on an edge, relative to a hypothesis: its distance from the nearest
/// edge of its type. `camera` is the camera's position relative to the robot (mm). An error of tilt
/// or roll changes the distance of the point, an error of the pan its direction.
ScalarMeasurement measurementOf(const ChosenPoint& chosen, const EdgeTables& edges,
                                const Vector3d& camera, const PoseHypothesis& hypothesis,
                                const EdgeErrors& errors);

}  // namespace gt
