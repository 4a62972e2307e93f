#pragma once
#include "base/Geometry.h"
#include "base/Random.h"
#include "simulation/camera/CameraEffects.h"
#include "simulation/camera/CameraView.h"
#include "simulation/parameters/BodyParameters.h"
#include "simulation/scene/Scene.h"
#include "simulation/world/World.h"

namespace gt {

/// The differences of one robot's hardware from the robot that its program assumes. The default is
/// no difference.
struct RobotBuild {
  double tilt = 0,
         roll = 0;       ///< rad: the body leans back and to the right more than joints measure.
  JointAngles joints{};  ///< rad: by which each joint is turned further than it measures.
  double backlash = 0;   ///< rad
  Vector3d acceleration = Vector3d::Zero();  ///< mm/s^2: offset of the acceleration sensors.
  double light = 1, cb = 0, cr = 0;          ///< Of its camera: a factor, and two offsets.

  /// Draws a robot's build. With other `body` parameters, the same generator draws the same
  /// differences in another size.
  static RobotBuild draw(const BodyParameters& body, const SceneRobot& setup, Random random);

  /// The angles (rad) to which motors turn the joints if `requested` are requested.
  JointAngles driven(const JointAngles& requested) const;
  /// The camera's view with the leaning of the body: it is turned about the body's origin.
  CameraView leaning(CameraView view, const RobotBody& body) const;
  /// The measured acceleration (mm/s^2): that of the leaning body, plus the sensors' offset.
  Vector3d felt(const RobotBody& body) const;
  /// The effects of this robot's camera.
  CameraEffects seen(CameraEffects effects) const;

 private:
  /// The rotation by which the body leans more than in the world's state.
  Matrix3d lean() const { return rotationX(roll) * rotationY(-tilt); }
};

}  // namespace gt
