#pragma once
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "representations/infrastructure/JointGains.h"
#include "representations/motion/KickTable.h"
#include "streams/Reflection.h"

namespace gt {

enum class MotionNodeKind { data, pid, odometry, displacement, transition, leave };

/// The net of all special actions (report 3.9.2), made from the motion descriptions in `motions/`,
/// which name them. Configuration.
struct MotionNet {
  static constexpr int jointCount = 18;  ///< All but the ears.

  struct Motion {
    std::string name;
    KickDescription kick;  ///< Of the table of kicks.

    bool isKick() const { return !kick.places.empty(); }

    static constexpr auto fields() {
      return Fields{field<&Motion::name>(), field<&Motion::kick>()};
    }
  };

  struct Node {
    MotionNodeKind kind = MotionNodeKind::leave;
    int motion = 0;
    std::array<double, jointCount> angles{};
    std::array<bool, jointCount> dontCare{};
    bool interpolate = false;
    int frames = 0;
    Pose2D speed;
    Pose2D displacement;
    Joint joint{};
    PidGains gains;
    bool always = false;
    int requested = 0;
    int target = 0;

    static constexpr auto fields() {
      return Fields{field<&Node::kind>(),
                    field<&Node::motion>("index of the motion to which the node belongs"),
                    field<&Node::angles>(Unit::rad, "data"),
                    field<&Node::dontCare>("data: joints left to other requests"),
                    field<&Node::interpolate>("data: reach the angles in the last frame"),
                    field<&Node::frames>(Unit::frames, "data: of 8 ms"),
                    field<&Node::speed>(Unit::mmRadPerS, "odometry: from here on"),
                    field<&Node::displacement>(
                        Unit::mmRad, "displacement: by which the next data node moves the robot"),
                    field<&Node::joint>("pid"),
                    field<&Node::gains>("pid: from here on"),
                    field<&Node::always>("transition: followed whatever is requested"),
                    field<&Node::requested>("transition: followed for this motion"),
                    field<&Node::target>("transition: index of the next node")};
    }
  };

  std::vector<Motion> motions;
  std::vector<Node> nodes;
  int entry = 0;

  /// The index of a motion; -1 if there is none of that name. The empty name is extern's.
  int find(std::string_view name) const {
    for (std::size_t i = 0; i < motions.size(); ++i)
      if (motions[i].name == name) return static_cast<int>(i);
    return -1;
  }

  /// Takes over from the table what its kicks do; a kick that no motion description has is ignored.
  void take(const KickTable& table) {
    for (const KickDescription& kick : table.kicks)
      if (const int i = find(kick.motion); i > 0) motions[static_cast<std::size_t>(i)].kick = kick;
  }

  static constexpr auto fields() {
    return Fields{field<&MotionNet::motions>("the first is extern, without a name"),
                  field<&MotionNet::nodes>(),
                  field<&MotionNet::entry>("index of the node of extern")};
  }
};

}  // namespace gt
