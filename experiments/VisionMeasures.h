#pragma once
#include "VisionTruth.h"
#include "measure/Tally.h"
#include "modules/modeling/selflocator/FieldEdges.h"
#include "modules/perception/testing/FoundPercepts.h"
#include "representations/perception/BodyPercept.h"

namespace gt {

/// Compares percepts with the truth, image by image. Rates are named after what has to be true
/// (`ball.found`); `false` is the share of percepts at a place where nothing of their kind is seen
/// (of the ball: of all images). One percept serves one thing. docs/vision.md lists the tolerances.
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
  void compareObstacles(const ObstaclesPercept& percept, Tally& tally) const;
  /// How far the ground is truly free from a line's near point on (mm), as far as the image shows.
  double freeLength(const FreeGround& line) const;
  double bearing(const Vector2d& place) const;
  double distance(const Vector2d& place) const;

  const VisionTruth& truth_;
  FieldDimensions field_;
  FieldEdges edges_{field_, TeamColor::red};
};

}  // namespace gt
