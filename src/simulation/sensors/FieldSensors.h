#pragma once
#include <string>
#include <vector>

#include "base/Random.h"
#include "simulation/world/World.h"

namespace gt {

/// What a sensor of the scene measures (report 5.1.1).
enum class FieldSensorKind { whisker, touch, acceleration };

/// The sensors of a scene beside the robots' own, from the field's model: MJCF's `rangefinder`
/// (the report's whisker, or distance sensor: mm along its site's z axis, at most `cutoff`),
/// `touch` (1 if something but the floor touches its site's body) and `accelerometer` (mm/s^2 in
/// its site's axes, three numbers). `noise` is the standard deviation of white noise, in MJCF's
/// units.
class FieldSensors {
 public:
  struct Sensor {
    std::string name;
    FieldSensorKind kind = FieldSensorKind::whisker;
    int site = 0;
    double range = 0;  ///< m
    double noise = 0;  ///< Standard deviation, in units of the value.
    std::vector<double> value;
    Random random;
    Vector3d before = Vector3d::Zero(), speed = Vector3d::Zero();  ///< Of the site: mm, mm/s.
    int seen = 0;  ///< Ticks, up to those that an acceleration needs.
  };

  FieldSensors(const World& world, const Random& random);

  /// Measures what is now.
  void step(const World& world);

  const std::vector<Sensor>& all() const { return sensors_; }
  std::vector<Sensor>& all() { return sensors_; }

 private:
  void measure(const World& world, Sensor& sensor) const;

  std::vector<Sensor> sensors_;
};

}  // namespace gt
