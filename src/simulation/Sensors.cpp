#include "simulation/Sensors.h"

#include <algorithm>

namespace gt {
namespace {

constexpr double psdNearest = 100, psdFurthest = 900;

}  // namespace

Sensors::Sensors(const NoiseParameters& noise, const Random& random)
    : noise_(noise), random_(random) {}

void Sensors::read(const World& world, std::size_t robot, SensorData& readings) {
  const RobotBody& body = world.robot(robot);
  readings.time = world.time();
  const double deviation = fromDegrees(noise_.joints);
  for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
    const bool feedback = j < static_cast<std::size_t>(Joint::earL);
    readings.joints.values[j] =
        body.joints.values[j] + (feedback ? deviation * random_.gaussian() : 0);
  }
  readings.acceleration = body.specificForce;
  for (int k = 0; k < 3; ++k) readings.acceleration[k] += noise_.acceleration * random_.gaussian();
  const double distance = rayDistance(world, robot, psdFurthest);
  readings.psd = std::clamp(distance * (1 + noise_.psd / psdFurthest * random_.gaussian()),
                            psdNearest, psdFurthest);
  readings.switches = pressed_;
  for (std::size_t leg = 0; leg < body.footOnGround.size(); ++leg)
    readings.switches.values[static_cast<std::size_t>(Switch::pawFR) + leg] |=
        body.footOnGround[leg];
}

namespace {

/// See rayDistance; a template, so that a robot's own sensor costs no indirect calls.
template <typename Passes>
double distanceAlong(const World& world, const Vector3d& start, const Vector3d& direction,
                     double range, const Passes& passes) {
  const mjModel& model = world.model();
  const mjData& data = world.data();
  const Vector3d from = start / 1000;
  const mjtNum* along = direction.data();
  double nearest = range / 1000;
  if (along[2] < 0) nearest = std::min(nearest, -from[2] / along[2]);  // the floor
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (passes(geom)) continue;
    const int group = model.geom_group[geom];
    if (group < 2 || group > 4) continue;
    // Only what the ray passes nearer than the geom's bounding sphere is wide.
    const mjtNum* center = data.geom_xpos + 3 * geom;
    const mjtNum d[3] = {center[0] - from[0], center[1] - from[1], center[2] - from[2]};
    const mjtNum bound = model.geom_rbound[geom];
    const mjtNum ahead = d[0] * along[0] + d[1] * along[1] + d[2] * along[2];
    if (ahead < -bound || ahead > nearest + bound) continue;
    if (d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - ahead * ahead > bound * bound) continue;
    const mjtNum hit = mju_rayGeom(center, data.geom_xmat + 9 * geom, model.geom_size + 3 * geom,
                                   from.data(), along, model.geom_type[geom]);
    if (hit >= 0) nearest = std::min(nearest, hit);
  }
  return 1000 * nearest;
}

}  // namespace

double rayDistance(const World& world, const Vector3d& from, const Vector3d& direction,
                   double range, const std::function<bool(int geom)>& passes) {
  return distanceAlong(world, from, direction, range, passes);
}

double rayDistance(const World& world, std::size_t robot, double range) {
  const RobotParts& parts = world.parts(robot);
  const Pose3D pose = sitePose(world.data(), parts.psdSite);
  return distanceAlong(world, pose.translation, pose.rotation.col(0), range,
                       [&](int geom) { return geom >= parts.firstGeom && geom < parts.lastGeom; });
}

}  // namespace gt
