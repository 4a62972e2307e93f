#pragma once
#include <array>
#include <optional>
#include <vector>

#include "base/Random.h"
#include "modules/modeling/selflocator/Bearings.h"
#include "modules/modeling/selflocator/EdgeModel.h"

namespace gt {

/// What a robot has seen within the last images, moved along with it: one image shows little of
/// the field, they distinguish poses that look alike in one. Judges poses by that, and draws
/// some that fit to it.
class RecentView {
 public:
  /// Moves what was seen with the robot, in mm and rad.
  void move(const Pose2D& odometry);
  /// Adds some of the points of an image, and forgets as many old ones.
  void add(const std::vector<ChosenPoint>& points, Random& random);
  /// Adds the bearings of an image. The offset is the camera's from the robot's origin, in mm.
  void add(const Bearings& bearings, const Vector2d& cameraOffset);
  /// Forgets all: the robot was put somewhere else.
  void clear() { numberOfPoints_ = numberOfBearings_ = 0; }

  /// The score of a pose: how well it explains what was seen, in [0, 1]; 0 as soon as it is known
  /// to be less than `least`.
  double score(const Pose2D& pose, const EdgeTables& tables, double least = 0) const;
  /// A pose from which one of the things seen would be seen where it was; empty if nothing was
  /// seen.
  std::optional<Pose2D> drawPose(const EdgeTables& tables, const FieldDimensions& field,
                                 Random& random) const;

 private:
  std::optional<Pose2D> drawFromBearings(const FieldDimensions& field, Random& random) const;

  struct SeenBearing {
    Vector2d landmark;
    Vector2d camera, direction;  ///< From where and whereto, in the robot's system now.
    double angle;                ///< Of the direction.
    int age;                     ///< In images.
  };

  /// A point in the robot's system, and how far off it still fits half.
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
