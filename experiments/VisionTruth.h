#pragma once
#include <optional>
#include <vector>

#include "measure/worlds/GameViews.h"
#include "representations/infrastructure/FieldDimensions.h"
#include "representations/infrastructure/Player.h"
#include "representations/perception/LandmarksPercept.h"

namespace gt {

/// What is true in an image: what each pixel shows, from the camera that drew it, and where things
/// are, from the oracle. Positions are the robot's, in mm.
class VisionTruth {
 public:
  enum class Kind { background, ground, line, border, flag, goal, ball, robot, tricot, other };

  VisionTruth(const World& world, const SceneDescription& scene);

  /// Takes an image to report on.
  void look(const GameView& view);

  const CameraMatrix& camera() const { return view_->camera; }
  Vector2d onRobot(const Vector2d& onField) const { return relative(pose(), onField); }
  Vector2d onField(const Vector2d& onRobot) const { return pose() * onRobot; }
  Vector2d ball() const { return onRobot(world_.ball(0).position); }
  Vector2d flag(FlagType type) const { return onRobot(positionOf(type, TeamColor::red, field_)); }
  /// A goal's left and right post, as seen from the field.
  Vector2d post(GoalColor color, bool left) const;
  std::size_t robots() const { return world_.robotCount(); }
  Vector2d robot(std::size_t i) const { return onRobot(world_.robot(i).pose.translation); }
  TeamColor team(std::size_t i) const { return players_[i].teamColor; }
  bool isOwn(std::size_t robot) const { return robot == view_->robot; }

  /// Pixels that show something; flags, goals and robots by their number.
  int pixels(Kind kind, std::size_t number = 0) const;
  /// Whether one of the pixels around a point of the image shows it.
  bool shows(const Vector2d& inImage, Kind kind, std::size_t number = 0) const;
  /// What is seen where a point of the ground should be seen; nothing outside of the image.
  std::optional<Kind> at(const Vector2d& onGround) const;

 private:
  struct Object {
    Kind kind = Kind::other;
    std::size_t number = 0;
  };

  const Pose2D& pose() const { return world_.robot(view_->robot).pose; }
  Object objectOf(int geom, ColorClass color) const;
  const Object& objectAt(int x, int y) const;

  const World& world_;
  FieldDimensions field_;
  std::vector<Player> players_;
  std::vector<Object> objects_;  ///< The background, then the geoms.
  const GameView* view_ = nullptr;
  std::vector<int> counts_;  ///< Pixels of the same.
};

}  // namespace gt
