#pragma once
#include "base/Geometry.h"
#include "base/Random.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/CameraView.h"
#include "simulation/parameters/BodyParameters.h"
#include "simulation/scene/Scene.h"
#include "simulation/world/World.h"

namespace gt {

/// How one robot was put together: what is different about it from the robot that its program
/// knows. The default is no difference.
struct RobotBuild {
  double tilt = 0,
         roll = 0;       ///< rad: the body leans back and to the right more than joints measure.
  JointAngles joints{};  ///< rad: by which each joint is turned further than it measures.
  double backlash = 0;   ///< rad
  Vector3d acceleration = Vector3d::Zero();  ///< mm/s^2: what its sensors add to what they feel.
  double light = 1, cb = 0, cr = 0;          ///< What its camera sees: a factor, and added.

  /// Draws a robot. The same generator draws the same robot, more or less different.
  static RobotBuild draw(const BodyParameters& body, const SceneRobot& setup, Random random);

  /// Where motors turn the joints if these angles are requested.
  JointAngles driven(const JointAngles& requested) const;
  /// What the camera sees because the body leans: it turns about the body's origin.
  CameraView leaning(CameraView view, const RobotBody& body) const;
  /// What the acceleration sensors feel: the body leans, and their zero is off (mm/s^2).
  Vector3d felt(const RobotBody& body) const;
  CameraEffects seen(CameraEffects effects) const;

 private:
  /// By which the body leans more than the world knows.
  Matrix3d lean() const { return rotationX(roll) * rotationY(-tilt); }
};

}  // namespace gt
