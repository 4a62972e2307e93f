#include "modules/modeling/selflocator/PoseMeasurements.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

double square(double x) {
  return x * x;
}

/// A vector turned to the left by a right angle: the derivative of a rotation.
Vector2d turnedLeft(const Vector2d& v) {
  return {-v.y(), v.x()};
}

}  // namespace

ScalarMeasurement measurementOf(const Bearing& bearing, const Vector2d& cameraOffset,
                                const PoseHypothesis& hypothesis, double variance,
                                double panVariance) {
  const Pose2D& pose = hypothesis.pose();
  const Vector2d offset = rotated(cameraOffset, pose.rotation);
  const Vector2d way = bearing.landmark - pose.translation - offset;
  const double distance = std::max(way.norm(), 1.01 * std::abs(bearing.radius) + 1);
  const double expected =
      angleOf(way) - pose.rotation + std::asin(bearing.radius / distance) + hypothesis.camera().z();
  const double toEdge = std::sqrt(square(distance) - square(bearing.radius));
  const Vector2d byPosition =
      (way * (bearing.radius / toEdge) - turnedLeft(way)) / square(distance);
  const double byRotation = byPosition.dot(turnedLeft(offset)) - 1;
  return {normalize(angleOf(bearing.direction) - expected),
          {byPosition.x(), byPosition.y(), byRotation},
          variance,
          {0, 0, 1},
          variance + panVariance};
}

ScalarMeasurement measurementOf(const FlagPercept& flag, const Vector2d& position,
                                const Pose2D& pose, double relativeError) {
  const Vector2d way = position - pose.translation;
  const double distance = std::max(way.norm(), 1.);
  return {flag.distance - distance,
          {-way.x() / distance, -way.y() / distance, 0},
          square(relativeError * flag.distance)};
}

ScalarMeasurement measurementOf(const ChosenPoint& chosen, const EdgeTables& edges,
                                const Vector3d& camera, const PoseHypothesis& hypothesis,
                                const EdgeErrors& errors) {
  const Pose2D& pose = hypothesis.pose();
  const Vector2d seen = chosen.point - camera.head<2>();
  const double distance = std::max(seen.norm(), 1.);
  const double lengthening = (square(distance) + square(camera.z())) / std::max(camera.z(), 50.);
  const Vector2d axis = seen / distance;  // its cosine and sine share out tilt and roll
  const Vector2d off = hypothesis.camera().head<2>() + hypothesis.lean();
  const double lengthened = lengthening * off.dot(axis);
  const Vector2d point =
      camera.head<2>() + rotated(seen - lengthened * axis, -hypothesis.camera().z());
  const Vector2d place = pose * point;
  const EdgeTables::Edge& edge =
      edges.nearest(chosen.type, static_cast<float>(place.x()), static_cast<float>(place.y()));
  const Vector2d normal{edge.normal.x, edge.normal.y};
  const Vector2d lever = place - pose.translation;
  const Vector2d view = rotated(seen, pose.rotation);
  const double along = view.dot(normal) / distance;
  const double byTilt = -along * lengthening;
  const double across = normal.dot(turnedLeft(view));
  const double variance =
      square(errors.elevation) * (square(byTilt) + square(across)) + square(errors.edge);
  return {normal.dot(Vector2d{edge.point.x, edge.point.y} - place),
          {normal.x(), normal.y(), normal.dot(turnedLeft(lever))},
          variance,
          {byTilt * axis.x(), byTilt * axis.y(), -across},
          variance + square(byTilt * errors.tilt) + square(across * errors.pan)};
}

}  // namespace gt
