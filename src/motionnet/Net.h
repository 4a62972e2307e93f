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

/// The columns and limits against which motion descriptions are checked.
struct Rules {
  std::vector<JointRule> joints;  ///< In the order of the columns.
};

/// A step through the net (report 3.9.2).
struct Node {
  enum class Kind { data, pid, odometry, displacement, transition, leave };

  Kind kind = Kind::data;
  int motion = 0;  ///< The motion in which the node stands.
  int line = 0;

  /// data: angle of each joint in mrad; empty: don't care.
  std::vector<std::optional<int>> angles;
  /// data: interpolate to the angles, or send them in each frame.
  bool interpolate = false;
  int frames = 0;  ///< data: number of frames.

  int joint = 0;            ///< pid
  int p = 0, i = 0, d = 0;  ///< pid
  /// odometry: speed from here on, mm/s, mm/s, mrad/s; displacement: of the next data node, mm, mm,
  /// mrad.
  int x = 0, y = 0, rotation = 0;

  int requested = -1;  ///< transition: followed if this motion is requested; -1: always.
  int target = 0;      ///< transition: index of the next node.
};

/// All motions, linked to one net. The nodes of a motion are consecutive. The last node of extern,
/// the entry, leaves the net.
struct Net {
  static constexpr int externMotion = 0;

  std::vector<std::string> motions;  ///< Their names; the first is extern.
  std::vector<Node> nodes;
  int entry = 0;  ///< Index of extern's node "start".

  /// The names of all motions except extern.
  std::vector<std::string> names() const { return {motions.begin() + 1, motions.end()}; }
};

}  // namespace motionnet
