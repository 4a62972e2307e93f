#pragma once
#include <Eigen/Core>
#include <array>

#include "modules/kinematics/BodyPosture.h"
#include "representations/infrastructure/SensorData.h"
#include "streams/Reflection.h"

namespace gt {

/// Models how the body leans and sinks because the legs give way, relative to its posture on stiff
/// legs. The model is linear in the heights of the feet and in the measured accelerations, at a
/// moment and shortly before it. `experiment calibrate-posture` fits it to the truth by least
/// squares. With weights 0 the body stands as on stiff legs (report 3.1).
class PostureModel {
 public:
  static constexpr int moments = 6, apart = 2;  ///< `apart`: ticks from one to the next.
  static constexpr int legCount = 4, axes = 3;
  static constexpr int count = 1 + moments * (legCount + axes);
  /// A constant 1; then for each moment, the latest first, the heights of the feet above the ground
  /// as on stiff legs (cm, in the order of Leg) and the acceleration (multiples of gravity).
  using Features = Eigen::Matrix<double, count, 1>;
  using Weights = std::array<double, count>;

  struct Parameters {
    Weights tilt{}, roll{}, height{};

    static constexpr auto fields() {
      return Fields{
          field<&Parameters::tilt>(Unit::rad,
                                   "for each feature: a constant, then heights of feet in cm and "
                                   "acceleration in g, the latest first"),
          field<&Parameters::roll>(Unit::rad), field<&Parameters::height>(Unit::mm)};
    }
  };
  Parameters parameters;

  /// The features at the sensor frame nearest to a moment. If the buffer does not reach back far
  /// enough, its oldest frame replaces older ones.
  static Features featuresAt(const RobotDimensions& robot, const SensorDataBuffer& sensors,
                             Time moment);
  /// The correction of the posture that is computed from stiff legs.
  BodyPosture correction(const Features& features) const;
};

}  // namespace gt
