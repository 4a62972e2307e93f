#pragma once
#include <Eigen/Core>
#include <array>

#include "modules/kinematics/BodyPosture.h"
#include "representations/infrastructure/SensorData.h"
#include "streams/Reflection.h"

namespace gt {

/// How a body leans and sinks whose legs give, beside where stiff legs would hold it. Linear in how
/// high the feet are lifted, and in what acceleration sensors feel, at a moment and before it.
/// `experiment calibrate-posture` fits it to the truth by least squares; without weights a body
/// stands as on stiff legs (report 3.1).
class PostureModel {
 public:
  static constexpr int moments = 6, apart = 2;  ///< Ticks from one to the next.
  static constexpr int legCount = 4, axes = 3;
  static constexpr int count = 1 + moments * (legCount + axes);
  /// A constant, and of each moment, the latest first, the heights of the feet above the lowest
  /// that stiff legs allow (cm, in the order of Leg) and the acceleration (multiples of gravity).
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

  /// Those of the frame nearest to a moment. Where the buffer does not reach back far enough, its
  /// oldest frame stands for older ones.
  static Features featuresAt(const RobotDimensions& robot, const SensorDataBuffer& sensors,
                             Time moment);
  /// What to add to the posture by legs.
  BodyPosture correction(const Features& features) const;
};

}  // namespace gt
