#pragma once
#include <array>

#include "base/Geometry.h"
#include "representations/infrastructure/Joints.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {

/// The three angles of a leg: rotator, elevator, knee, in rad.
struct LegAngles {
  double rotator = 0;
  double elevator = 0;
  double knee = 0;
};

/// A leg's angles for a foot, and whether the foot can really be there.
struct LegSolution {
  LegAngles angles;
  bool reachable = true;  ///< False: the target was clamped to the reachable shell.
};

/// The position of a leg's shoulder joint in the body's system, in mm.
Vector3d shoulderOf(const RobotDimensions& robot, Leg leg);

/// The center of the spherical foot in the body's system, in mm (report 3.9.1.4, 3.22). The body's
/// origin lies midway between the four shoulder axes.
Vector3d footPosition(const RobotDimensions& robot, Leg leg, const LegAngles& angles);

/// The knee in the body's system, in mm.
Vector3d kneePosition(const RobotDimensions& robot, Leg leg, const LegAngles& angles);

/// The angles that bring the center of the foot to a point in the body's system, in mm (report
/// 3.9.1.4, 3.25 to 3.38), with the knee bent to the side where it has the larger range. Closed
/// form and exact: the lateral offset of the upper leg is taken into account, which the report
/// neglects. Targets too near or too far are clamped to the reachable shell, along the ray from the
/// shoulder where possible; the result respects the limits of the joints.
LegSolution legAngles(const RobotDimensions& robot, Leg leg, const Vector3d& foot);

LegAngles legOf(const JointAngles& angles, Leg leg);
void setLeg(JointAngles& all, Leg leg, const LegAngles& angles);

/// The centers of the four spherical feet in the body's system, in mm, in the order of Leg.
std::array<Vector3d, 4> footPositions(const RobotDimensions& robot, const JointAngles& angles);

/// The least angle of the elevator joint (rad) at which the leg does not touch the body, for an
/// angle of the rotator joint (rad) (facts, 1.2).
double leastElevator(Leg, double rotator);

}  // namespace gt
