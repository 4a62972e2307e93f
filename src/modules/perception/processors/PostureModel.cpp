#include "modules/perception/processors/PostureModel.h"

#include <algorithm>
#include <cmath>

#include "modules/kinematics/LegKinematics.h"

namespace gt {

PostureModel::Features PostureModel::featuresAt(const RobotDimensions& robot,
                                                const SensorDataBuffer& sensors, Time moment) {
  constexpr double centimeter = 10, gravity = 9810;  // mm, mm/s^2
  const auto nearest = static_cast<int>(&sensors.at(moment) - sensors.frames.data());
  Features features;
  features[0] = 1;
  int next = 1;
  for (int i = 0; i < moments; ++i) {
    const int index = std::max(nearest - i * apart, 0);
    const SensorData& frame = sensors.frames[static_cast<std::size_t>(index)];
    const BodyPosture legs = bodyPosture(robot, frame.joints);
    const Pose3D body = bodyPose(legs);
    for (const Vector3d& foot : footPositions(robot, frame.joints))
      features[next++] = ((body * foot).z() - robot.footRadius) / centimeter;
    features.segment<axes>(next) = frame.acceleration / gravity;
    next += axes;
  }
  return features;
}

BodyPosture PostureModel::correction(const Features& features) const {
  const auto times = [&](const Weights& weights) {
    return Eigen::Map<const Features>(weights.data()).dot(features);
  };
  return {times(parameters.height), times(parameters.tilt), times(parameters.roll)};
}

}  // namespace gt
