#pragma once
#include <array>
#include <optional>
#include <vector>

#include "base/Random.h"
#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/EdgeModel.h"

namespace gt {

/// The measurements of the last images, moved along with the robot. One image shows little of the
/// field; several distinguish poses that look alike in one. Computes scores of poses by these
/// measurements, and draws poses that fit them.
class RecentView {
 public:
  /// Moves the measurements by a step of the robot (mm, rad).
  void move(const Pose2D& odometry);
  /// Adds some of the points of an image, and removes as many old ones.
  void add(const std::vector<ChosenPoint>& points, Random& random);
  /// Adds the bearings of an image. `cameraOffset` is the camera's position relative to the robot
  /// (mm).
  void add(const Bearings& bearings, const Vector2d& cameraOffset);
  /// Removes all measurements, after the robot was put somewhere else.
  void clear() { numberOfPoints_ = numberOfBearings_ = 0; }

  /// The score of a pose, in [0, 1]: how well the measurements fit to it. Returns 0 early if the
  /// score is less than `least`.
  double score(const Pose2D& pose, const EdgeTables& tables, double least = 0) const;
  /// A random pose from which one of the measurements would be the same; nothing if there are no
  /// measurements.
  std::optional<Pose2D> drawPose(const EdgeTables& tables, const FieldDimensions& field,
                                 Random& random) const;

 private:
  std::optional<Pose2D> drawFromBearings(const FieldDimensions& field, Random& random) const;

  struct SeenBearing {
    Vector2d landmark;
    Vector2d camera, direction;  ///< Position (mm) and direction, relative to the present robot.
    double angle;                ///< Of the direction, rad.
    int age;                     ///< In images.
  };

  /// A point relative to the robot, and the distance from an edge at which it fits by half (mm).
  struct SeenPoint {
    EdgeType type;
    Vector2d point;
    double tolerance;
  };

  std::array<SeenPoint, 64> points_;
  std::size_t numberOfPoints_ = 0, nextPoint_ = 0;
  std::array<SeenBearing, 8> bearings_;
  std::size_t numberOfBearings_ = 0, nextBearing_ = 0;
};

}  // namespace gt
