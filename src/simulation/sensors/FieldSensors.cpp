#include "simulation/sensors/FieldSensors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "simulation/camera/Lighting.h"
#include "simulation/sensors/Sensors.h"

namespace gt {
namespace {

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

/// The pose of a sensor that looks along its site's z axis: x ahead, z up.
Pose3D lookingAhead(const Pose3D& site) {
  Matrix3d axes;
  axes << site.rotation.col(2), site.rotation.col(0), site.rotation.col(1);
  return {axes, site.translation};
}

/// A unit vector that points to the left and up from straight ahead, by these angles.
Vector3d ray(const Pose3D& pose, double left, double up) {
  return pose.rotation * (rotationZ(left) * rotationY(-up) * Vector3d::UnitX());
}

/// The distance of the nearest surface in a cone, by rays on rings about its axis.
template <typename Distance>
double nearestInCone(const Pose3D& pose, double halfAngle, const Distance& distance) {
  constexpr int rings = 4, spokes = 12;
  double nearest = distance(ray(pose, 0, 0));
  for (int ring = 1; ring <= rings; ++ring)
    for (int spoke = 0; spoke < spokes; ++spoke) {
      const double off = halfAngle * ring / rings, around = 2 * pi * spoke / spokes;
      const Vector3d aside =
          std::cos(around) * pose.rotation.col(1) + std::sin(around) * pose.rotation.col(2);
      nearest = std::min(nearest, distance(Vector3d{std::cos(off) * pose.rotation.col(0) +
                                                    std::sin(off) * aside}));
    }
  return nearest;
}

void copyTo(std::vector<double>& value, const Vector3d& numbers) {
  std::copy_n(numbers.data(), 3, value.begin());
}

/// Measures the values that depend on the motion of the site in the last tick.
void measureMotion(const Pose3D& pose, FieldSensors::Sensor& sensor) {
  const bool known = sensor.seen >= 1;
  const Vector3d speed =
      known ? Vector3d{(pose.translation - sensor.before.translation) / tickSeconds}
            : Vector3d{0, 0, 0};
  const Matrix3d toSite = pose.rotation.transpose();
  if (sensor.kind == FieldSensorKind::acceleration) {
    const Vector3d change =
        sensor.seen >= 2 ? Vector3d{(speed - sensor.speed) / tickSeconds} : Vector3d{0, 0, 0};
    copyTo(sensor.value, toSite * (change + Vector3d{0, 0, 9810}));
  } else if (sensor.kind == FieldSensorKind::speed) {
    copyTo(sensor.value, toSite * speed);
  } else {
    const Eigen::AngleAxisd turn{sensor.before.rotation.transpose() * pose.rotation};
    copyTo(sensor.value, known ? Vector3d{toDegrees(turn.angle() / tickSeconds) * turn.axis()}
                               : Vector3d{0, 0, 0});
  }
  sensor.before = pose;
  sensor.speed = speed;
  sensor.seen = std::min(sensor.seen + 1, 2);
}

}  // namespace

FieldSensors::FieldSensors(const World& world, const Random& random) {
  for (int id = 0; id < world.model().nsensor; ++id) {
    auto model = fieldSensor(world.model(), id);
    if (!model) continue;
    others_ |= model->kind == FieldSensorKind::other;
    Sensor sensor{std::move(*model)};
    sensor.value.resize(sensor.numbers);
    sensor.random = random.fork(sensor.name);
    sensors_.push_back(std::move(sensor));
  }
}

void FieldSensors::step(World& world, const CameraScene& scene) {
  if (others_) world.measureSensors();
  for (Sensor& sensor : sensors_)
    if (sensor.kind != FieldSensorKind::facette) measure(world, scene, sensor);
}

const std::vector<double>& FieldSensors::read(std::size_t sensor, const World& world,
                                              const CameraScene& scene) {
  Sensor& s = sensors_[sensor];
  if (s.kind == FieldSensorKind::facette) measure(world, scene, s);
  return s.value;
}

void FieldSensors::measure(const World& world, const CameraScene& scene, Sensor& sensor) {
  const mjModel& model = world.model();
  const Pose3D site = model.nsite > 0 ? sitePose(world.data(), sensor.site) : Pose3D{};
  const int body = model.nsite > 0 ? model.body_weldid[model.site_bodyid[sensor.site]] : 0;
  const auto distance = [&](const Vector3d& direction) {
    return rayDistance(world, site.translation, direction, 1000 * sensor.range,
                       [&](int geom) { return movedWith(model, geom) == body; });
  };
  const Pose3D ahead = lookingAhead(site);
  switch (sensor.kind) {
    case FieldSensorKind::whisker:
      sensor.value[0] = distance(site.rotation.col(2));
      break;
    case FieldSensorKind::ultrasonic:
      sensor.value[0] = nearestInCone(ahead, sensor.width, distance);
      break;
    case FieldSensorKind::whiskerField:
      for (int y = 0; y < sensor.rows; ++y)
        for (int x = 0; x < sensor.columns; ++x)
          sensor.value[static_cast<std::size_t>(y * sensor.columns + x)] =
              distance(ray(ahead, sensor.width * (0.5 - (x + 0.5) / sensor.columns),
                           sensor.height * (0.5 - (y + 0.5) / sensor.rows)));
      break;
    case FieldSensorKind::receptor:
    case FieldSensorKind::facette: {
      const Facette camera{sensor.columns, sensor.rows, sensor.width, sensor.height};
      camera.take(Lighting{model}, scene, world.data(), ahead, model.site_bodyid[sensor.site],
                  false, image_);
      // A receptor has the mean of all pixels, a facette three numbers for each.
      const double share =
          sensor.kind == FieldSensorKind::receptor ? 1. / static_cast<double>(image_.area()) : 1;
      std::ranges::fill(sensor.value, 0.);
      std::size_t next = 0;
      for (const Pixel& pixel : image_.pixels)
        for (const std::uint8_t channel : {pixel.y, pixel.cb, pixel.cr})
          sensor.value[next++ % sensor.value.size()] += share * channel;
      break;
    }
    case FieldSensorKind::touch:
      sensor.value[0] = isTouched(world, body);
      break;
    case FieldSensorKind::compass:
      sensor.value[0] = toDegrees(std::atan2(site.rotation(1, 0), site.rotation(0, 0)));
      break;
    case FieldSensorKind::acceleration:
    case FieldSensorKind::turning:
    case FieldSensorKind::speed:
      measureMotion(site, sensor);
      break;
    case FieldSensorKind::other:
      std::copy_n(world.data().sensordata + model.sensor_adr[sensor.id], sensor.value.size(),
                  sensor.value.begin());
  }
  for (double& value : sensor.value) value += sensor.noise * sensor.random.gaussian();
}

}  // namespace gt
