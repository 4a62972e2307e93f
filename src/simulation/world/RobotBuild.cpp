#include "simulation/world/RobotBuild.h"

#include <algorithm>

namespace gt {

RobotBuild RobotBuild::draw(const BodyParameters& body, const SceneRobot& setup, Random random) {
  RobotBuild build;
  build.tilt = fromDegrees(setup.bodyTilt) + fromDegrees(body.tilt) * random.gaussian();
  build.roll = fromDegrees(setup.bodyRoll) + fromDegrees(body.roll) * random.gaussian();
  for (double& offset : build.joints.values)
    offset = fromDegrees(body.jointOffset) * random.gaussian();
  build.backlash = fromDegrees(body.backlash);
  for (int k = 0; k < 3; ++k) build.acceleration[k] = body.accelerationOffset * random.gaussian();
  build.light = std::clamp(1 + body.cameraLight * random.gaussian(), 0.1, 1.9);
  build.cb = body.cameraColor * random.gaussian();
  build.cr = body.cameraColor * random.gaussian();
  return build;
}

JointAngles RobotBuild::driven(const JointAngles& requested) const {
  JointAngles angles = requested;
  for (std::size_t j = 0; j < angles.values.size(); ++j) angles.values[j] += joints.values[j];
  return angles;
}

CameraView RobotBuild::leaning(CameraView view, const RobotBody& body) const {
  if (tilt == 0 && roll == 0) return view;
  const Pose3D upright{rotationZ(body.pose.rotation), body.origin().translation};
  const Pose3D turn = upright * Pose3D{lean(), Vector3d::Zero()} * upright.inverse();
  view.first = turn * view.first;
  view.last = turn * view.last;
  return view;
}

Vector3d RobotBuild::felt(const RobotBody& body) const {
  if (tilt == 0 && roll == 0) return body.specificForce + acceleration;
  const Matrix3d upright = rotationZ(-body.pose.rotation) * body.origin().rotation;
  return upright.transpose() * lean().transpose() * upright * body.specificForce + acceleration;
}

CameraEffects RobotBuild::seen(CameraEffects effects) const {
  if (light != 1) effects.brightness = std::clamp(effects.brightness * light, 0.0, 1.9);
  if (cb != 0) effects.shiftCb = std::clamp(effects.shiftCb + cb, -128.0, 128.0);
  if (cr != 0) effects.shiftCr = std::clamp(effects.shiftCr + cr, -128.0, 128.0);
  return effects;
}

}  // namespace gt
