#pragma once
#include <array>
#include <vector>

#include "base/Geometry.h"
#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/Joints.h"

namespace gt {

enum class MotionNodeKind { data, odometry, transition, leave };

/// The net of all special actions (report 3.9.2), made from the motion descriptions in `motions/`.
/// Configuration.
struct MotionNet {
  static constexpr int jointCount = 18;  ///< All but the ears.

  struct Node {
    MotionNodeKind kind = MotionNodeKind::leave;
    SpecialAction action = SpecialAction::none;
    std::array<double, jointCount> angles{};
    std::array<bool, jointCount> dontCare{};
    bool interpolate = false;
    int frames = 0;
    Pose2D speed;
    bool always = false;
    SpecialAction requested = SpecialAction::none;
    int target = 0;

    static constexpr auto fields() {
      return Fields{
          field("kind", &Node::kind),
          field("action", &Node::action, "", "to which the node belongs; none for extern"),
          field("angles", &Node::angles, "rad", "data"),
          field("dontCare", &Node::dontCare, "", "data: joints left to other requests"),
          field("interpolate", &Node::interpolate, "", "data: reach the angles in the last frame"),
          field("frames", &Node::frames, "frames", "data: of 8 ms"),
          field("speed", &Node::speed, "mm/s, rad/s", "odometry: from here on"),
          field("always", &Node::always, "", "transition: followed whatever is requested"),
          field("requested", &Node::requested, "", "transition: followed for this; none: leave"),
          field("target", &Node::target, "", "transition: index of the next node")};
    }
  };

  std::vector<Node> nodes;
  int entry = 0;

  static constexpr auto fields() {
    return Fields{field("nodes", &MotionNet::nodes),
                  field("entry", &MotionNet::entry, "", "index of the node of extern")};
  }
};

}  // namespace gt
