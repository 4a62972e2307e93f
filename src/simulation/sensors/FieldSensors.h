#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "base/Random.h"
#include "simulation/camera/CameraScene.h"
#include "simulation/world/World.h"

namespace gt {

/// What a sensor of the scene measures (report 5.1.1).
enum class FieldSensorKind {
  whisker,
  whiskerField,
  ultrasonic,
  receptor,
  facette,
  touch,
  acceleration,
  turning,
  speed,
  compass,
  other
};

/// The sensors of a scene beside the robots' own, from the field's model. Lengths are mm, angles
/// deg; `noise` is the standard deviation of white noise, in MJCF's units.
///
/// MJCF's own: `rangefinder` (the report's whisker: the distance along its site's z axis, at most
/// `cutoff`), `touch` (1 if something but the floor touches its site's body), `accelerometer`
/// (mm/s^2), `gyro` (deg/s) and `velocimeter` (mm/s) in its site's axes, `magnetometer` (a compass:
/// where the site's x axis points; 0 is the direction to the sky-blue goal). All that depend on
/// positions only, such as `framepos` or `jointpos`, measure in MuJoCo's units.
///
/// MJCF's `user` at a site, with a `<numeric name="KIND/NAME" data="…"/>` that says more; it looks
/// along the site's z axis, the y axis is up:
///  - `ultrasonic` ANGLE RANGE: the distance of the nearest surface in a cone of half that angle;
///  - `whiskerField` COLUMNS ROWS WIDTH HEIGHT RANGE: distances, row by row from the top left,
///    spread evenly over these opening angles;
///  - `receptor` ANGLE: the mean intensities y, cb and cr of what it sees with that opening angle;
///  - `facette` COLUMNS ROWS WIDTH HEIGHT: the same of a camera with a spherical geometry, pixel by
///    pixel. It measures only when it is read.
class FieldSensors {
 public:
  struct Sensor {
    std::string name;
    FieldSensorKind kind = FieldSensorKind::other;
    int id = 0;                    ///< In the model.
    int site = 0;                  ///< If it has one.
    double range = 0;              ///< m
    int columns = 1, rows = 1;     ///< Of whisker fields and facettes.
    double width = 0, height = 0;  ///< Opening angles of these in rad, and of ultrasonic cones.
    double noise = 0;              ///< Standard deviation, in units of the value.
    std::vector<double> value;
    Random random;
    Pose3D before;                      ///< Of the site in the last tick, mm.
    Vector3d speed = Vector3d::Zero();  ///< Of the site, mm/s.
    int seen = 0;                       ///< Ticks, up to those that an acceleration needs.
  };

  FieldSensors(const World& world, const Random& random);

  /// Measures the world as it is after a tick.
  void step(World& world, const CameraScene& scene);
  /// What a sensor measured last; a facette measures now.
  const std::vector<double>& read(std::size_t sensor, const World& world, const CameraScene& scene);

  const std::vector<Sensor>& all() const { return sensors_; }
  std::vector<Sensor>& all() { return sensors_; }

 private:
  void measure(const World& world, const CameraScene& scene, Sensor& sensor);

  std::vector<Sensor> sensors_;
  Image image_;          ///< Of a receptor or facette, while it measures.
  bool others_ = false;  ///< Whether MuJoCo has to measure some.
};

/// What a kind of sensor measures, in one sentence.
std::string_view describe(FieldSensorKind kind);

/// Whether FieldSensors knows a sensor of a model.
bool isKnownSensor(const mjModel& model, int id);

/// Fails if a model has a sensor that FieldSensors does not know, or one without its `numeric`.
Result<void> checkFieldSensors(const mjModel& model, const std::string& file);

}  // namespace gt
