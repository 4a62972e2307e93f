#pragma once
#include "VisionTruth.h"
#include "measure/Tally.h"
#include "modules/modeling/selflocator/FieldEdges.h"
#include "modules/perception/testing/FoundPercepts.h"
#include "representations/perception/BodyPercept.h"

namespace gt {

/// Compares percepts with the truth, image by image. Rates are named after what has to be true
/// (`ball.found`); `false` is the share of percepts at a place where nothing of their kind is seen
/// (of the ball: of all images), of robots divided into `nothing` (no robot is seen in that
/// direction) and `misplaced`. One percept serves one thing. docs/vision.md lists the tolerances.
class VisionMeasures {
 public:
  explicit VisionMeasures(const VisionTruth& truth) : truth_(truth) {}

  /// Edge points are looked up in the image by the camera matrix that they were made with.
  void comparePercepts(const FoundPercepts& percepts, const CameraMatrix& measured, Tally& tally);
  void compareSensors(const RobotBody& body, const CameraMatrix& matrix, const BodyPercept& percept,
                      Tally& tally) const;

 private:
  void compareBall(const BallPercept& percept, Tally& tally) const;
  void compareFlags(const LandmarksPercept& percept, Tally& tally) const;
  void compareGoals(const LandmarksPercept& percept, Tally& tally) const;
  /// Whether a percept is in the direction of the goal of its color.
  bool isAtGoal(const GoalPercept& goal) const;
  void compareEdges(const LinesPercept& percept, const CameraMatrix& measured, Tally& tally) const;
  void comparePlayers(const PlayersPercept& percept, Tally& tally) const;
  /// Whether a robot that shows tricot is seen in the direction of a place.
  bool isTowardsRobot(const Vector2d& place) const;
  void compareObstacles(const ObstaclesPercept& percept, Tally& tally) const;
  /// Whether two places on the ground, one behind the other, are the same for free ground.
  bool isSameEnd(const Vector2d& a, const Vector2d& b) const;
  /// How far the ground is truly free from a line's near point on, as far as the image shows.
  struct Free {
    Vector2d along;   ///< Of length 1.
    double distance;  ///< mm
  };
  Free freeGround(const FreeGround& line) const;
  double bearing(const Vector2d& place) const;
  double distance(const Vector2d& place) const;

  const VisionTruth& truth_;
  FieldDimensions field_;
  FieldEdges edges_{field_, TeamColor::red};
};

}  // namespace gt
