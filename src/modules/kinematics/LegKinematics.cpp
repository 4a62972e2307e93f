#include "modules/kinematics/LegKinematics.h"

#include <algorithm>
#include <cmath>

namespace gt {
namespace {

/// Dimensions of a leg in the system of the left fore leg, to which all legs are mirrored.
struct Model {
  Vector3d upper, lower;
  Vector2d mirror;  ///< Signs of x and y.

  Model(const RobotDimensions& robot, Leg leg)
      : upper(robot.upperLeg),
        lower(isFore(leg) ? robot.lowerLegFore : robot.lowerLegHind),
        mirror(isFore(leg) ? 1 : -1, isLeft(leg) ? 1 : -1) {}

  Vector3d mirrored(const Vector3d& v) const {
    return {mirror.x() * v.x(), mirror.y() * v.y(), v.z()};
  }
  /// Shoulder to foot before the shoulder turns it.
  Vector3d fold(double knee) const { return upper + rotationY(-knee) * lower; }
  /// Turned by the shoulder.
  static Vector3d turned(const LegAngles& q, const Vector3d& v) {
    return rotationY(-q.rotator) * Vector3d{rotationX(q.elevator) * v};
  }
};

double clampTo(Joint joint, double angle, bool& inside) {
  const auto limits = limitsOf(joint);
  if (angle < limits.low || angle > limits.high) inside = false;
  return std::clamp(angle, limits.low, limits.high);
}

/// Law of cosine (3.26). The links are projected to the side view. `fold`, the knee's angle at
/// which they are aligned, is added to the report's q3.
double kneeFor(const Model& model, double distanceSquared, bool& reachable) {
  const Vector2d l1{model.upper.x(), model.upper.z()}, l2{model.lower.x(), model.lower.z()};
  const double straight = std::atan2(l1.x(), -l1.y()) - std::atan2(l2.x(), -l2.y());
  const double lateral = model.upper.y() + model.lower.y();
  const double c = (distanceSquared - lateral * lateral - l1.squaredNorm() - l2.squaredNorm()) /
                   (2 * l1.norm() * l2.norm());
  if (c < -1 || c > 1) reachable = false;
  return straight + std::acos(std::clamp(c, -1.0, 1.0));
}

}  // namespace

Vector3d shoulderOf(const RobotDimensions& robot, Leg leg) {
  return {isFore(leg) ? robot.shoulderX : -robot.shoulderX,
          isLeft(leg) ? robot.shoulderY : -robot.shoulderY, 0};
}

Vector3d footPosition(const RobotDimensions& robot, Leg leg, const LegAngles& q) {
  const Model model{robot, leg};
  return shoulderOf(robot, leg) + model.mirrored(Model::turned(q, model.fold(q.knee)));
}

Vector3d kneePosition(const RobotDimensions& robot, Leg leg, const LegAngles& q) {
  const Model model{robot, leg};
  return shoulderOf(robot, leg) + model.mirrored(Model::turned(q, model.upper));
}

LegSolution legAngles(const RobotDimensions& robot, Leg leg, const Vector3d& foot) {
  const Model model{robot, leg};
  const Vector3d target = model.mirrored(foot - shoulderOf(robot, leg));
  LegSolution solution;
  auto& [q, reachable] = solution;
  q.knee = kneeFor(model, target.squaredNorm(), reachable);
  q.knee = clampTo(legJoint(leg, 3), q.knee, reachable);
  const Vector3d folded = model.fold(q.knee);

  // A target off the shell moves along its ray from the shoulder.
  const double wanted = target.norm();
  const double scale = wanted > 1e-9 ? folded.norm() / wanted : 1;
  const double y = reachable ? target.y() : target.y() * scale;

  // 3.28 with the lateral offset: y = offset cos q2 - z sin q2.
  const double reach = std::hypot(folded.y(), folded.z());
  if (std::abs(y) > reach) reachable = false;
  q.elevator = std::asin(std::clamp(y / reach, -1.0, 1.0)) - std::atan2(folded.y(), -folded.z());
  q.elevator = clampTo(legJoint(leg, 2), q.elevator, reachable);

  // 3.36 and 3.38: what is left is a rotation in the plane of x and z.
  const Vector3d raised = rotationX(q.elevator) * folded;
  q.rotator = normalize(std::atan2(target.z(), target.x()) - std::atan2(raised.z(), raised.x()));
  q.rotator = clampTo(legJoint(leg, 1), q.rotator, reachable);
  return solution;
}

LegAngles legOf(const JointAngles& angles, Leg leg) {
  return {angles[legJoint(leg, 1)], angles[legJoint(leg, 2)], angles[legJoint(leg, 3)]};
}

void setLeg(JointAngles& angles, Leg leg, const LegAngles& q) {
  angles[legJoint(leg, 1)] = q.rotator;
  angles[legJoint(leg, 2)] = q.elevator;
  angles[legJoint(leg, 3)] = q.knee;
}

std::array<Vector3d, 4> footPositions(const RobotDimensions& robot, const JointAngles& angles) {
  std::array<Vector3d, 4> feet;
  for (std::size_t i = 0; i < feet.size(); ++i) {
    const auto leg = static_cast<Leg>(i);
    feet[i] = footPosition(robot, leg, legOf(angles, leg));
  }
  return feet;
}

double leastElevator(Leg leg, double rotator) {
  // Every 15 degrees from -105 to 105, with the ends at +-117.
  static constexpr std::array<double, 17> at{-117, -105, -90, -75, -60, -45, -30, -15, 0,
                                             15,   30,   45,  60,  75,  90,  105, 117};
  static constexpr std::array<double, 17> fore{2.6, 0.3, -2,   -4.3, -6.3, -9.5, -10.5, -11, -11,
                                               -11, -9,  -7.5, -5.5, -3.5, -0.7, 2.0,   2.0};
  static constexpr std::array<double, 17> hind{3.0,   1.7,  -1.3, -2.3, -6,   -8,   -9.5, -11, -11,
                                               -10.5, -9.5, -7.5, -5,   -3.0, -0.5, 2.3,  1.0};
  const auto& table = isFore(leg) ? fore : hind;
  const double degrees = std::clamp(toDegrees(rotator), at.front(), at.back());
  std::size_t i = 1;
  while (i + 1 < at.size() && degrees > at[i]) ++i;
  const double t = (degrees - at[i - 1]) / (at[i] - at[i - 1]);
  return fromDegrees(table[i - 1] + t * (table[i] - table[i - 1]));
}

}  // namespace gt
