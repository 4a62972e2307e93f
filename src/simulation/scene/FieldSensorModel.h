#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "base/Result.h"
#include "simulation/scene/MuJoCo.h"

namespace gt {

/// The kinds of sensors of a scene (report 5.1.1).
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

/// The model's data of one sensor of a scene that is not a robot's. Values of lengths are mm, of
/// angles deg; `noise` is the standard deviation of white noise, in MJCF's units.
///
/// MJCF's own: `rangefinder` (the report's whisker: the distance along its site's z axis, at most
/// `cutoff`), `touch` (1 if something but the floor touches its site's body), `accelerometer`
/// (mm/s^2), `gyro` (deg/s) and `velocimeter` (mm/s) in its site's axes, `magnetometer` (a compass:
/// where the site's x axis points; 0 is the direction to the sky-blue goal). All sensors that
/// depend on positions only, such as `framepos` or `jointpos`, measure in MuJoCo's units.
///
/// MJCF's `user` at a site, with a `<numeric name="KIND/NAME" data="…"/>` that has its parameters;
/// the sensor looks along the site's z axis, the y axis is up:
///  - `ultrasonic` ANGLE RANGE: the distance of the nearest surface in a cone of half that angle;
///  - `whiskerField` COLUMNS ROWS WIDTH HEIGHT RANGE: distances, row by row from the top left,
///    spread evenly over these opening angles;
///  - `receptor` ANGLE: the mean intensities y, cb and cr of its view with that opening angle;
///  - `facette` COLUMNS ROWS WIDTH HEIGHT: the intensities y, cb and cr of a camera with a
///    spherical geometry, pixel by pixel. It measures only when it is read.
struct FieldSensorModel {
  std::string name;
  FieldSensorKind kind = FieldSensorKind::other;
  int id = 0;                    ///< In the model.
  int site = 0;                  ///< In the model, if it has one.
  std::size_t numbers = 1;       ///< Of which its value consists.
  double range = 0;              ///< m
  int columns = 1, rows = 1;     ///< Of whisker fields and facettes.
  double width = 0, height = 0;  ///< Opening angles of these in rad, and of ultrasonic cones.
  double noise = 0;              ///< Standard deviation, in units of the value.
};

/// Describes in one sentence what a kind of sensor measures.
std::string_view describe(FieldSensorKind kind);

/// A sensor of a model; empty if it is of a kind that FieldSensors does not know.
std::optional<FieldSensorModel> fieldSensor(const mjModel& model, int id);

/// Fails if a model has a sensor that FieldSensors does not know, or one without its `numeric`.
Result<void> checkFieldSensors(const mjModel& model, const std::string& file);

}  // namespace gt
