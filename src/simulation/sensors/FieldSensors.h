#pragma once
#include <vector>

#include "base/Random.h"
#include "simulation/camera/CameraScene.h"
#include "simulation/scene/FieldSensorModel.h"
#include "simulation/world/World.h"

namespace gt {

/// The sensors of a scene that are not the robots', from the field's model. Lengths are mm, angles
/// deg; `noise` is the standard deviation of white noise, in MJCF's units.
class FieldSensors {
 public:
  struct Sensor : FieldSensorModel {
    std::vector<double> value{};
    Random random{};
    Pose3D before{};                    ///< Of the site in the last tick, mm.
    Vector3d speed = Vector3d::Zero();  ///< Of the site, mm/s.
    int seen = 0;                       ///< Ticks so far, at most those an acceleration needs.
  };

  FieldSensors(const World& world, const Random& random);

  /// Measures the world as it is after a tick.
  void step(World& world, const CameraScene& scene);
  /// The last values of a sensor; a facette measures now.
  const std::vector<double>& read(std::size_t sensor, const World& world, const CameraScene& scene);

  const std::vector<Sensor>& all() const { return sensors_; }
  std::vector<Sensor>& all() { return sensors_; }

 private:
  void measure(const World& world, const CameraScene& scene, Sensor& sensor);

  std::vector<Sensor> sensors_;
  Image image_;          ///< Of a receptor or facette, while it measures.
  bool others_ = false;  ///< Whether there are sensors that MuJoCo has to measure.
};

}  // namespace gt
