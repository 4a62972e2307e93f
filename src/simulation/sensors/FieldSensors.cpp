#include "simulation/sensors/FieldSensors.h"

#include <algorithm>

#include "simulation/sensors/Sensors.h"

namespace gt {
namespace {

constexpr double farthest = 10;  // m, of a whisker without cutoff

/// The body that a geom moves with: 0 if it stands still.
int movedWith(const mjModel& model, int geom) {
  return model.body_weldid[model.geom_bodyid[geom]];
}

/// Whether anything but the floor touches one of the geoms of a body.
bool isTouched(const World& world, int body) {
  const mjModel& model = world.model();
  for (int geom = 0; geom < model.ngeom; ++geom) {
    if (movedWith(model, geom) != body) continue;
    for (int other = 0; other < model.ngeom; ++other) {
      const int group = model.geom_group[other];
      if (movedWith(model, other) != body && group >= 2 && group <= 4 &&
          geomsTouch(world, geom, other, 0.0005))
        return true;
    }
  }
  return false;
}

}  // namespace

FieldSensors::FieldSensors(const World& world, const Random& random) {
  const mjModel& model = world.model();
  for (int i = 0; i < model.nsensor; ++i) {
    Sensor sensor;
    double unit = 1000;
    switch (model.sensor_type[i]) {
      case mjSENS_RANGEFINDER:
        sensor.range = model.sensor_cutoff[i] > 0 ? model.sensor_cutoff[i] : farthest;
        break;
      case mjSENS_TOUCH:
        sensor.kind = FieldSensorKind::touch;
        unit = 1;
        break;
      case mjSENS_ACCELEROMETER:
        sensor.kind = FieldSensorKind::acceleration;
        break;
      default:
        continue;
    }
    const char* name = mj_id2name(&model, mjOBJ_SENSOR, i);
    sensor.name = name ? name : "sensor" + std::to_string(i);
    sensor.site = model.sensor_objid[i];
    sensor.noise = unit * model.sensor_noise[i];
    sensor.random = random.fork(sensor.name);
    sensor.value.resize(sensor.kind == FieldSensorKind::acceleration ? 3 : 1);
    sensors_.push_back(std::move(sensor));
  }
}

void FieldSensors::step(const World& world) {
  for (Sensor& sensor : sensors_) {
    measure(world, sensor);
    for (double& value : sensor.value) value += sensor.noise * sensor.random.gaussian();
  }
}

void FieldSensors::measure(const World& world, Sensor& sensor) const {
  const Pose3D pose = sitePose(world.data(), sensor.site);
  const int body = world.model().body_weldid[world.model().site_bodyid[sensor.site]];
  switch (sensor.kind) {
    case FieldSensorKind::whisker:
      sensor.value[0] =
          rayDistance(world, pose.translation, pose.rotation.col(2), 1000 * sensor.range,
                      [&](int geom) { return movedWith(world.model(), geom) == body; });
      return;
    case FieldSensorKind::touch:
      sensor.value[0] = isTouched(world, body);
      return;
    case FieldSensorKind::acceleration: {
      const Vector3d speed = (pose.translation - sensor.before) / tickSeconds;
      const Vector3d change =
          sensor.seen >= 2 ? Vector3d{(speed - sensor.speed) / tickSeconds} : Vector3d{0, 0, 0};
      sensor.before = pose.translation;
      sensor.speed = speed;
      sensor.seen = std::min(sensor.seen + 1, 2);
      const Vector3d felt = pose.rotation.transpose() * (change + Vector3d{0, 0, 9810});
      std::copy_n(felt.data(), 3, sensor.value.begin());
    }
  }
}

}  // namespace gt
