#pragma once
#include <optional>
#include <string>
#include <vector>

namespace motionnet {

/// One driven joint of the robot: a column of the data lines.
struct JointRule {
  std::string name;
  int low, high;  ///< Allowed angles in mrad.
};

/// What the motion descriptions are checked against.
struct Rules {
  std::vector<JointRule> joints;  ///< In the order of the columns.
};

/// A step through the net (report 3.9.2).
struct Node {
  enum class Kind { data, pid, odometry, displacement, transition, leave };

  Kind kind = Kind::data;
  int motion = 0;  ///< The motion in which the node stands.
  int line = 0;

  std::vector<std::optional<int>> angles;  ///< data: mrad for each joint; nothing: don't care.
  bool interpolate = false;                ///< data: go there, or send the angles again and again.
  int frames = 0;                          ///< data: for how long.

  int joint = 0;            ///< pid
  int p = 0, i = 0, d = 0;  ///< pid
  /// odometry: mm/s, mm/s, mrad/s from here on; displacement: mm, mm, mrad by the next data.
  int x = 0, y = 0, rotation = 0;

  int requested = -1;  ///< transition: followed if this motion is requested; -1: whichever is.
  int target = 0;      ///< transition: index of the next node.
};

/// All motions, linked to one net: the nodes of a motion stand one behind the other; the last node
/// of extern, the entry, leaves the net.
struct Net {
  static constexpr int externMotion = 0;

  std::vector<std::string> motions;  ///< Their names; the first is extern.
  std::vector<Node> nodes;
  int entry = 0;  ///< Index of extern's node "start".

  /// The names of the motions but extern.
  std::vector<std::string> names() const { return {motions.begin() + 1, motions.end()}; }
};

}  // namespace motionnet
