#pragma once
#include <string>
#include <vector>

#include "base/Random.h"
#include "measure/worlds/MovedRobot.h"
#include "representations/motion/KickTable.h"

namespace gt {

/// The result of one kick.
struct KickTrial {
  Vector2d way = Vector2d::Zero();  ///< mm, displacement of the ball, relative to the robot before
                                    ///< the kick
  double seconds = 0;               ///< s, from the request until the robot stands again
  double strike = 0;                ///< s, from the request until the ball is fastest
  Pose2D moved;                     ///< displacement of the robot (mm, rad)
  bool fell = false;
  bool overlaps = false;  ///< Whether there is no room for the ball because the robot stands there.
  double byHead = 0;      ///< Share of the ball's speed that was gained from contacts with the head
                          ///< only.
};

/// Simulates a kick. A robot at the center of the field faces a random direction, walks some steps
/// with its head following the ball as when approaching one, and is requested to kick. The ball is
/// placed (mm, relative to the robot) when the kick begins. When the robot stands again, the ball
/// is still rolling and has not reached a wall; the rest of its path is calculated.
KickTrial tryKick(MovedRobot& robot, const std::string& motion, const Vector2d& place,
                  Random& random);

/// A kick of a ball that lay within half a step of a place of the grid (mm).
struct GridTrial {
  int x = 0, y = 0;
  KickTrial kick;
};

/// The places around a robot where kicks are tried, `step` (mm) apart.
struct KickGrid {
  static constexpr int step = 20, nearest = 60, farthest = 340, widest = 180;
};

/// One kick by one robot at each place of the grid next to a place in `near` at which the ball was
/// hit; if `near` is null, at every second place in both directions.
std::vector<GridTrial> tryGrid(MovedRobot& robot, const std::string& motion, Random& random,
                               const std::vector<GridTrial>* near);

/// A kick as described by a table, with a sentence about the reason for its best place. Without
/// places if there is none from which it reliably moves the ball.
struct DescribedKick {
  KickDescription kick;
  std::string why;
};

/// Describes a motion by its results at the places of the grid. The best place is the one from
/// which the ball reliably goes far, in a constant direction, without the robot falling.
DescribedKick describeKick(const std::string& motion, const std::vector<GridTrial>& trials);

}  // namespace gt
