#include "simulation/sensors/Sensors.h"

#include <algorithm>

namespace gt {
namespace {

constexpr double psdNearest = 100, psdFurthest = 900;

}  // namespace

Sensors::Sensors(const NoiseParameters& noise, const Random& random, const RobotBuild& build)
    : noise_(noise), random_(random), reflections_(random.fork("reflections")), build_(build) {}

void Sensors::read(const World& world, std::size_t robot, SensorData& readings) {
  const RobotBody& body = world.robot(robot);
  readings.time = world.time();
  const double standardDeviation = fromDegrees(noise_.joints);
  for (std::size_t j = 0; j < enumCount<Joint>; ++j) {
    const bool feedback = j < static_cast<std::size_t>(Joint::earL);
    const double angle = body.joints.values[j], play = build_.backlash / 2;
    geared_.values[j] = std::clamp(geared_.values[j], angle - play, angle + play);
    readings.joints.values[j] = geared_.values[j] - build_.joints.values[j] +
                                (feedback ? standardDeviation * random_.gaussian() : 0);
  }
  readings.joints[Joint::tailPan] += tailPush_;
  readings.acceleration = build_.felt(body);
  for (int k = 0; k < 3; ++k) readings.acceleration[k] += noise_.acceleration * random_.gaussian();
  const double distance = rayDistance(world, robot, psdFurthest);
  readings.psd = std::clamp(distance * (1 + noise_.psd / psdFurthest * random_.gaussian()),
                            psdNearest, psdFurthest);
  if (noise_.psdReflections > 0 && reflections_.chance(noise_.psdReflections))
    readings.psd = reflections_.uniform(psdNearest, psdFurthest);
  readings.switches = pressed_;
  for (std::size_t leg = 0; leg < body.footOnGround.size(); ++leg)
    readings.switches.values[static_cast<std::size_t>(Switch::pawFR) + leg] |=
        body.footOnGround[leg];
}

namespace {

/// A ray through the world, in meters, and the distance of the first surface that it meets.
class Ray {
 public:
  Ray(const World& world, const Vector3d& start, const Vector3d& direction, double range)
      : model_(world.model()),
        data_(world.data()),
        from_(start / 1000),
        along_(direction),
        nearest_(range / 1000) {
    if (along_.z() < 0) nearest_ = std::min(nearest_, -from_.z() / along_.z());  // the floor
  }

  /// Whether it may meet something in a sphere before the first surface found so far.
  bool mayMeet(const mjtNum* center, double radius) const {
    const Vector3d d = Eigen::Map<const Vector3d>{center} - from_;
    const double ahead = d.dot(along_);
    return ahead >= -radius && ahead <= nearest_ + radius &&
           d.squaredNorm() - ahead * ahead <= radius * radius;
  }
  void meet(int geom) {
    const int group = model_.geom_group[geom];
    if (group < 2 || group > 4) return;
    const mjtNum* center = data_.geom_xpos + 3 * geom;
    if (!mayMeet(center, model_.geom_rbound[geom])) return;
    const mjtNum hit = mju_rayGeom(center, data_.geom_xmat + 9 * geom, model_.geom_size + 3 * geom,
                                   from_.data(), along_.data(), model_.geom_type[geom]);
    if (hit >= 0) nearest_ = std::min(nearest_, hit);
  }
  double distance() const { return 1000 * nearest_; }

 private:
  const mjModel& model_;
  const mjData& data_;
  Vector3d from_, along_;
  double nearest_;
};

/// See rayDistance; a template, so that a robot's own sensor costs no indirect calls.
template <typename Passes>
double distanceAlong(const World& world, const Vector3d& start, const Vector3d& direction,
                     double range, const Passes& passes) {
  Ray ray{world, start, direction, range};
  const auto meetAll = [&](int first, int last) {
    for (int geom = first; geom < last; ++geom)
      if (!passes(geom)) ray.meet(geom);
  };
  int next = 0;
  for (std::size_t robot = 0; robot < world.robotCount(); ++robot) {
    const RobotParts& parts = world.parts(robot);
    meetAll(next, parts.firstGeom);
    next = parts.lastGeom;
    if (ray.mayMeet(world.data().xpos + 3 * parts.body, parts.reach / 1000))
      meetAll(parts.firstGeom, parts.lastGeom);
  }
  meetAll(next, world.model().ngeom);
  return ray.distance();
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
