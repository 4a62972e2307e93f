#include "modules/modeling/OracledLocators.h"

#include <algorithm>

#include "modules/modeling/selflocator/FieldEdges.h"
#include "representations/infrastructure/RobotFootprint.h"

namespace gt {
namespace {

/// The distance from a point on the field to the nearest wall or robot, in mm; negative inside of
/// one.
double clearance(const Vector2d& point, const FieldEdges& edges, const OracledWorldState& oracle) {
  double least = ObstaclesModel::farAway;
  for (const EdgeType type : {EdgeType::border, EdgeType::yellowGoal, EdgeType::skyblueGoal})
    least = std::min(least, (edges.closest(type, point) - point).norm());
  for (const OracledRobot& robot : oracle.others)
    for (const double middle : RobotFootprint::middles)
      least = std::min(least,
                       (robot.pose * Vector2d{middle, 0} - point).norm() - RobotFootprint::radius);
  return least;
}

}  // namespace

void OracledSelfLocator::update(const OracledWorldState& oracle, RobotPose& pose) {
  pose.pose = oracle.robotPose;
  pose.validity = 1;
}

void OracledBallLocator::update(const OracledWorldState& oracle, const FrameInfo& frame,
                                BallModel& ball) {
  if (first_ == never()) first_ = frame.time;
  ball.position = relative(oracle.robotPose, oracle.ballPosition);
  ball.speed = rotated(oracle.ballSpeed, -oracle.robotPose.rotation);
  ball.lastSeen = frame.time;
  ball.consecutiveTimeSeen = frame.time - first_;
}

void OracledPlayersLocator::update(const OracledWorldState& oracle, const Player& player,
                                   const FrameInfo& frame, PlayersCollection& players) {
  players.time = frame.time;
  players.ownTeam.clear();
  players.opponents.clear();
  players.seenOpponents.clear();
  for (const OracledRobot& robot : oracle.others)
    (robot.teamColor == player.teamColor ? players.ownTeam : players.opponents)
        .push_back({robot.pose.translation, frame.time, 1, robot.number});
}

void OracledObstaclesLocator::update(const OracledWorldState& oracle, const FieldDimensions& field,
                                     const FrameInfo& frame, ObstaclesModel& obstacles) {
  const FieldEdges edges{field, TeamColor::red};  // where walls are does not depend on colors
  obstacles.time = frame.time;
  for (int i = 0; i < ObstaclesModel::numberOfSectors; ++i) {
    const Vector2d along = direction(ObstaclesModel::middleOf(i));
    // As far as nothing can be in the way, again and again.
    double distance = 0, free = ObstaclesModel::farAway;
    while (distance < ObstaclesModel::farAway && free > 1) {
      free = clearance(oracle.robotPose * Vector2d{distance * along}, edges, oracle);
      distance += std::max(free, 0.);
    }
    const bool obstacle = distance < ObstaclesModel::farAway;
    obstacles.sectors[static_cast<std::size_t>(i)] = {
        std::min(distance, ObstaclesModel::farAway) * along, obstacle, frame.time};
  }
}

}  // namespace gt
