#include "simulation/world/RobotParts.h"

#include <algorithm>

#include "simulation/camera/CameraScene.h"

namespace gt {
namespace {

/// Looks up names that begin with the same prefix and remembers the first that is missing.
class Lookup {
 public:
  Lookup(const mjModel& model, std::string prefix) : model_(model), prefix_(std::move(prefix)) {}

  int operator()(mjtObj type, const std::string& name) {
    const int id = mj_name2id(&model_, type, (prefix_ + name).c_str());
    expect(id >= 0, name, "");
    return std::max(id, 0);
  }
  /// The address of a joint of a type in qpos.
  int joint(const std::string& name, mjtJoint type) {
    const int id = (*this)(mjOBJ_JOINT, name);
    if (model_.njnt == 0) return 0;
    expect(model_.jnt_type[id] == type, name, type == mjJNT_FREE ? ", a free joint" : ", a hinge");
    return model_.jnt_qposadr[id];
  }
  /// A body that moves freely in the world.
  int root(const std::string& name) {
    const int id = (*this)(mjOBJ_BODY, name);
    expect(model_.body_rootid[id] == id, name, ", a body of the world");
    return id;
  }
  const std::string& missing() const { return missing_; }

 private:
  void expect(bool right, const std::string& name, const std::string& what) {
    if (!right && missing_.empty()) missing_ = "\"" + name + "\"" + what;
  }

  const mjModel& model_;
  std::string prefix_;
  std::string missing_;
};

}  // namespace

std::pair<int, int> geomsBelow(const mjModel& model, int body) {
  int first = model.ngeom, last = 0;
  for (int geom = 0; geom < model.ngeom; ++geom)
    if (model.body_rootid[model.geom_bodyid[geom]] == body) {
      first = std::min(first, geom);
      last = std::max(last, geom + 1);
    }
  return {std::min(first, last), last};
}

LegPose legPose(const mjModel& model, const RobotParts& parts, const JointAngles& angles,
                std::size_t leg) {
  const auto vectorOf = [](const mjtNum* numbers) {
    return Vector3d{numbers[0], numbers[1], numbers[2]};
  };
  constexpr std::size_t joints = 3;
  std::array<int, 8> chain;  // from the lower leg up to the body
  std::size_t length = 0;
  for (int body = parts.kneeBodies[leg]; body != parts.body && length < chain.size();
       body = model.body_parentid[body])
    chain[length++] = body;
  Vector3d position = Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();
  std::size_t joint = 0;
  while (length > 0) {
    const int body = chain[--length];
    const mjtNum* q = model.body_quat + 4 * body;
    position += rotation * vectorOf(model.body_pos + 3 * body);
    rotation = rotation * Eigen::Quaterniond{q[0], q[1], q[2], q[3]};
    if (model.body_jntnum[body] == 0 || joint == joints) continue;
    const int hinge = model.body_jntadr[body];
    const double angle =
        angles.values[static_cast<std::size_t>(Joint::legFR1) + joints * leg + joint++];
    const Vector3d anchor = vectorOf(model.jnt_pos + 3 * hinge);
    position += rotation * anchor;
    rotation = rotation * Eigen::AngleAxisd{angle - model.qpos0[model.jnt_qposadr[hinge]],
                                            vectorOf(model.jnt_axis + 3 * hinge)};
    position -= rotation * anchor;
  }
  const Vector3d foot = vectorOf(model.site_pos + 3 * parts.footSites[leg]);
  return {1000 * position, 1000 * (position + rotation * foot)};
}

Result<RobotParts> findRobotParts(const mjModel& model, const std::string& robot,
                                  const std::string& file) {
  constexpr std::array<const char*, 4> legs{"FR", "FL", "HR", "HL"};
  Lookup find{model, robot + "/"};
  RobotParts parts;
  parts.body = find.root("robot");
  parts.poseAddress = find.joint("pose", mjJNT_FREE);
  for (std::size_t i = 0; i < enumCount<Joint>; ++i)
    parts.jointAddress.values[i] = find.joint(std::string{enumNames<Joint>[i]}, mjJNT_HINGE);
  for (std::size_t i = 0; i < legs.size(); ++i) {
    parts.footSites[i] = find(mjOBJ_SITE, std::string{"foot"} + legs[i]);
    parts.kneeBodies[i] = find(mjOBJ_BODY, std::string{"lowerLeg"} + legs[i]);
  }
  parts.cameraSite = find(mjOBJ_SITE, "camera");
  parts.psdSite = find(mjOBJ_SITE, "psd");
  if (model.nsite) parts.headBody = model.site_bodyid[parts.cameraSite];
  std::tie(parts.firstGeom, parts.lastGeom) = geomsBelow(model, parts.body);
  for (int geom = parts.firstGeom; geom < parts.lastGeom; ++geom)
    parts.reach = std::max(parts.reach, 1000 * reachFromRoot(model, geom));
  if (!find.missing().empty())
    return Error{
        .file = file, .field = robot, .what = "the robot's model has no " + find.missing()};
  return parts;
}

Result<BallParts> findBallParts(const mjModel& model, std::size_t index, const std::string& file) {
  const std::string name = "ball" + std::to_string(index);
  Lookup find{model, name + "/"};
  BallParts parts;
  parts.body = find.root("ball");
  parts.poseAddress = find.joint("pose", mjJNT_FREE);
  parts.geom = find(mjOBJ_GEOM, "ball");
  if (!find.missing().empty())
    return Error{.file = file, .field = name, .what = "the ball's model has no " + find.missing()};
  if (model.geom_type[parts.geom] != mjGEOM_SPHERE)
    return Error{.file = file, .field = name, .what = "the ball's geom is no sphere"};
  parts.radius = 1000 * model.geom_size[3 * parts.geom];
  return parts;
}

}  // namespace gt
