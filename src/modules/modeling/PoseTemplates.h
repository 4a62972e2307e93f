#pragma once
#include <array>
#include <optional>

#include "base/Geometry.h"
#include "base/Random.h"
#include "modules/modeling/Bearings.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// A point on the field and the direction in which it is seen, in the system of who sees it.
struct Sighting {
  Vector2d landmark;
  Vector2d direction;  ///< Need not be normalized.
};

/// The pose from which three landmarks are seen in three directions; none where the three and the
/// observer lie on one circle, or where a landmark would lie behind (report 3.3.2.3).
std::optional<Pose2D> triangulate(const Sighting& a, const Sighting& b, const Sighting& c);

/// The one or two poses from which one landmark is seen in a direction and at a distance (the
/// length of `located.direction` in mm), and another one in a direction (report 3.3.2.3). Returns
/// how many.
int posesFrom(const Sighting& located, const Sighting& second, std::array<Pose2D, 2>& poses);

/// Candidate poses for sensor resetting, calculated from the landmarks of this picture and the last
/// three flags seen (report 3.3.2.3). Each is handed out once.
class PoseTemplates {
 public:
  /// Moves the memorized flags with the robot, in mm and rad.
  void move(const Pose2D& odometry);
  /// Memorizes the picture's flags, and fills the buffer anew.
  void update(const LandmarksPercept& percept, TeamColor team, const FieldDimensions& field);
  /// One of the poses that have not been handed out yet.
  std::optional<Pose2D> take(Random& random);
  int size() const { return count_; }

 private:
  struct MemorizedFlag {
    FlagType type = FlagType::pinkAboveYellow;
    Vector2d position = Vector2d::Zero();  ///< Relative to the robot.
  };

  void memorize(const FlagPercept& flag);
  void triangulateAll(const LandmarksPercept& percept, TeamColor team);
  void locateByFlags(const LandmarksPercept& percept, TeamColor team);
  void add(const Pose2D& camera);

  FieldDimensions field_;
  Vector2d cameraOffset_ = Vector2d::Zero();
  std::array<MemorizedFlag, 3> flags_;  ///< The one seen last comes first.
  int numberOfFlags_ = 0;
  std::array<Pose2D, 96> poses_;
  int count_ = 0;
};

}  // namespace gt
