#pragma once
#include <string>
#include <vector>

#include "base/Random.h"
#include "measure/worlds/MovedRobot.h"
#include "representations/motion/KickTable.h"

namespace gt {

/// What one kick did.
struct KickTrial {
  Vector2d way = Vector2d::Zero();  ///< mm, of the ball, in the robot's system before the kick
  double seconds = 0;               ///< from the request until the robot stands
  double strike = 0;                ///< until the ball is fastest
  Pose2D moved;                     ///< of the robot
  bool fell = false;
  bool overlaps = false;  ///< There is no room for the ball: the robot stands there.
  double byHead = 0;      ///< Share of the ball's speed that it gained where the head alone pushed.
};

/// A robot in the middle of the field faces anywhere, walks some steps with its eyes on the ball as
/// it does when it gets to one, and is asked for the kick; the ball is put down at a place (mm) in
/// the robot's system as the kick begins. When the robot stands again, the ball rolls, and no wall
/// has stopped it yet: from there its way is calculated.
KickTrial tryKick(MovedRobot& robot, const std::string& motion, const Vector2d& place,
                  Random& random);

/// A kick of a ball that lay within half a step of a place of the grid (mm).
struct GridTrial {
  int x = 0, y = 0;
  KickTrial kick;
};

/// The places before a robot where kicks are tried, all `step` (mm) apart.
struct KickGrid {
  static constexpr int step = 20, nearest = 60, farthest = 340, widest = 180;
};

/// One kick by one robot at each place of the grid around which another place in `near` lies, or at
/// all in steps of two if that is null.
std::vector<GridTrial> tryGrid(MovedRobot& robot, const std::string& motion, Random& random,
                               const std::vector<GridTrial>* near);

/// A kick as a table describes it, with a sentence why its best place is the best. Without places
/// if it moves balls reliably from none.
struct DescribedKick {
  KickDescription kick;
  std::string why;
};

/// Describes a motion by what it did at the places of the grid. The best place is that from which
/// the ball surely goes far, and one way, and the robot stays on its feet.
DescribedKick describeKick(const std::string& motion, const std::vector<GridTrial>& trials);

}  // namespace gt
