#pragma once
#include <array>
#include <string>
#include <vector>

#include "representations/infrastructure/Joints.h"
#include "simulation/scene/MuJoCo.h"

namespace gt {

/// The indices of a robot's parts in the model, looked up by name once, when the scene is loaded.
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
  double reach = 0;  ///< mm: greatest distance of any part from the body's origin.
};

/// Looks up the parts of a robot. Fails if the model lacks one.
Result<RobotParts> findRobotParts(const mjModel& model, const std::string& robot,
                                  const std::string& file);

/// The positions of a leg's knee and foot, in mm relative to the robot's body.
struct LegPose {
  Vector3d knee, foot;
};

/// Computes the pose of one leg from the joints' angles (rad), with MuJoCo's result but before the
/// body's own pose is known, which depends on the legs.
LegPose legPose(const mjModel& model, const RobotParts& parts, const JointAngles& angles,
                std::size_t leg);

/// The indices of a ball in the model.
struct BallParts {
  int body = 0;
  int poseAddress = 0;
  int geom = 0;
  double radius = 0;  ///< mm
};

/// Looks up the parts of a ball.
Result<BallParts> findBallParts(const mjModel& model, std::size_t index, const std::string& file);

/// The geoms of a body and of all bodies below it: the first one and the one behind the last. Their
/// indices in MuJoCo are contiguous.
std::pair<int, int> geomsBelow(const mjModel& model, int body);

}  // namespace gt
