#pragma once
#include <vector>

#include "base/Geometry.h"
#include "base/Random.h"
#include "representations/infrastructure/FieldDimensions.h"

namespace gt {

/// One hypothesis of where the robot is (report (3.7)).
struct Sample {
  Vector2d position = Vector2d::Zero();  ///< In mm on the field.
  Vector2d heading{1, 0};                ///< Unit vector: the rotation without its trigonometry.
  double probability = 0;                ///< Filtered, report (3.13).

  static Sample at(const Pose2D& pose, double probability) {
    return {pose.translation, direction(pose.rotation), probability};
  }
  /// A point given relative to the robot, on the field.
  Vector2d operator*(const Vector2d& p) const {
    return {position.x() + heading.x() * p.x() - heading.y() * p.y(),
            position.y() + heading.y() * p.x() + heading.x() * p.y()};
  }
  void turn(double angle);
};

/// The average of the largest cluster, and how certain it is (report 3.3.2.4).
struct Cluster {
  Pose2D pose;
  double validity = 0;
  int size = 0;
};

/// A pose anywhere on the field.
Pose2D randomPose(const FieldDimensions& field, Random& random);

/// Copies samples so often as their probability demands (importance resampling, report 3.3.2.3).
/// The number of samples stays; `buffer` is the memory for it.
void resample(std::vector<Sample>& samples, std::vector<Sample>& buffer, Random& random);

/// The samples in the fullest 2 x 2 x 2 of 10 x 10 x 10 cells over the field, averaged
/// (report 3.3.2.4, (3.15), (3.16)).
Cluster largestCluster(const std::vector<Sample>& samples, const FieldDimensions& field);

}  // namespace gt
