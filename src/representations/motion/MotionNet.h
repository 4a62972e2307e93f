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

/// The net of all special actions (report 3.9.2), compiled from the motion descriptions in
/// `motions/`, whose names the actions have. Configuration.
struct MotionNet {
  static constexpr int jointCount = 18;  ///< All but the ears.

  struct Motion {
    std::string name;
    KickDescription kick;  ///< From the table of kicks.

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
      return Fields{
          field<&Node::kind>(),
          field<&Node::motion>("index of the motion to which the node belongs"),
          field<&Node::angles>(Unit::rad, "data: target angles"),
          field<&Node::dontCare>("data: joints left to other requests"),
          field<&Node::interpolate>(
              "data: whether the angles are interpolated and reached in the last frame"),
          field<&Node::frames>(Unit::frames, "data: duration in frames of 8 ms"),
          field<&Node::speed>(Unit::mmRadPerS, "odometry: speed of the robot from here on"),
          field<&Node::displacement>(Unit::mmRad,
                                     "displacement: motion of the robot during the next data node"),
          field<&Node::joint>("pid: joint whose gains are set"),
          field<&Node::gains>("pid: gains from here on"),
          field<&Node::always>("transition: whether it is followed for every request"),
          field<&Node::requested>("transition: index of the motion for which it is followed"),
          field<&Node::target>("transition: index of the next node")};
    }
  };

  std::vector<Motion> motions;
  std::vector<Node> nodes;
  int entry = 0;

  /// The index of a motion; -1 if there is none of that name. The empty name is that of extern.
  int find(std::string_view name) const {
    for (std::size_t i = 0; i < motions.size(); ++i)
      if (motions[i].name == name) return static_cast<int>(i);
    return -1;
  }

  /// Copies the effects of the kicks from the table. Kicks without a motion description are
  /// ignored.
  void take(const KickTable& table) {
    for (const KickDescription& kick : table.kicks)
      if (const int i = find(kick.motion); i > 0) motions[static_cast<std::size_t>(i)].kick = kick;
  }

  static constexpr auto fields() {
    return Fields{field<&MotionNet::motions>(
                      "motions of the net; the first one is extern, which has no name"),
                  field<&MotionNet::nodes>(),
                  field<&MotionNet::entry>("index of the node at which extern begins")};
  }
};

}  // namespace gt
