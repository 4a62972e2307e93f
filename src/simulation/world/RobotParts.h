#pragma once
#include <array>
#include <string>
#include <vector>

#include "representations/infrastructure/Joints.h"
#include "simulation/scene/MuJoCo.h"

namespace gt {

/// Where a robot's parts lie in the model: looked up by name once, when the scene is loaded.
struct RobotParts {
  int body = 0;
  int poseAddress = 0;  ///< In qpos: 3 numbers of the position, 4 of the quaternion.
  EnumArray<Joint, int> jointAddress;
  std::array<int, 4> footSites{};  ///< In the order of Leg; their size is the foot ball's radius.
  std::array<int, 4> kneeBodies{};
  int cameraSite = 0;
  int headBody = 0;  ///< The body that carries the camera.
  int psdSite = 0;
  int firstGeom = 0;
  int lastGeom = 0;  ///< Behind the last one.
  double reach = 0;  ///< mm; no part gets further from the body's origin, whatever the joints do.
};

/// Looks up the parts of a robot. Fails if the model lacks one.
Result<RobotParts> findRobotParts(const mjModel& model, const std::string& robot,
                                  const std::string& file);

/// Where a leg's knee and foot are, in mm relative to the robot's body.
struct LegPose {
  Vector3d knee, foot;
};

/// The same as MuJoCo makes of the joints' angles (rad), of one leg alone: most that follows from
/// the legs is needed before the body's own pose is known.
LegPose legPose(const mjModel& model, const RobotParts& parts, const JointAngles& angles,
                std::size_t leg);

/// Where a ball lies in the model.
struct BallParts {
  int body = 0;
  int poseAddress = 0;
  int geom = 0;
  double radius = 0;  ///< mm
};

/// Looks up the parts of a ball.
Result<BallParts> findBallParts(const mjModel& model, std::size_t index, const std::string& file);

/// The geoms of a body and of all below it: from the first to behind the last. MuJoCo keeps them in
/// one row.
std::pair<int, int> geomsBelow(const mjModel& model, int body);

}  // namespace gt
