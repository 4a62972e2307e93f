#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/Geometry.h"
#include "representations/infrastructure/Joints.h"
#include "streams/Reflection.h"

namespace gt {

enum class MotionNodeKind { data, odometry, transition, leave };

/// Where a kick plays a ball, seen from the robot as it stands before it: x ahead, y to the left.
struct KickDescription {
  /// An area of the ball from which it leaves in the kick's direction.
  struct Reach {
    double nearest = 0, farthest = 0;
    double rightmost = 0, leftmost = 0;
    double spread = 0;

    static constexpr auto fields() {
      return Fields{field("nearest", &Reach::nearest, "mm", "least distance ahead"),
                    field("farthest", &Reach::farthest, "mm", "greatest distance ahead"),
                    field("rightmost", &Reach::rightmost, "mm", "least distance to the left"),
                    field("leftmost", &Reach::leftmost, "mm", "greatest distance to the left"),
                    field("spread", &Reach::spread, "degree",
                          "how far the ball may go astray to either side of the direction")};
    }
  };

  double x = 0, y = 0;
  double direction = 0;
  std::vector<Reach> reach;

  /// The least spread with which the kick plays a ball at a place; nothing where it does not. With
  /// a margin, the areas are so much larger on all sides.
  std::optional<double> spreadAt(const Vector2d& ball, double margin) const {
    std::optional<double> least;
    for (const Reach& r : reach)
      if (ball.x() > r.nearest - margin && ball.x() < r.farthest + margin &&
          ball.y() > r.rightmost - margin && ball.y() < r.leftmost + margin &&
          (!least || r.spread < *least))
        least = r.spread;
    return least;
  }

  static constexpr auto fields() {
    using K = KickDescription;
    return Fields{field("x", &K::x, "mm", "where the ball is best, ahead"),
                  field("y", &K::y, "mm", "where the ball is best, to the left"),
                  field("direction", &K::direction, "degree",
                        "where the ball goes, counterclockwise from straight ahead"),
                  field("reach", &K::reach, "", "areas from which it does; none: is no kick")};
  }
};

/// The net of all special actions (report 3.9.2), made from the motion descriptions in `motions/`,
/// which name them. Configuration.
struct MotionNet {
  static constexpr int jointCount = 18;  ///< All but the ears.

  struct Motion {
    std::string name;
    KickDescription kick;

    bool isKick() const { return !kick.reach.empty(); }

    static constexpr auto fields() {
      return Fields{field("name", &Motion::name), field("kick", &Motion::kick)};
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
    bool always = false;
    int requested = 0;
    int target = 0;

    static constexpr auto fields() {
      return Fields{
          field("kind", &Node::kind),
          field("motion", &Node::motion, "", "index of the motion to which the node belongs"),
          field("angles", &Node::angles, "rad", "data"),
          field("dontCare", &Node::dontCare, "", "data: joints left to other requests"),
          field("interpolate", &Node::interpolate, "", "data: reach the angles in the last frame"),
          field("frames", &Node::frames, "frames", "data: of 8 ms"),
          field("speed", &Node::speed, "mm/s, rad/s", "odometry: from here on"),
          field("always", &Node::always, "", "transition: followed whatever is requested"),
          field("requested", &Node::requested, "", "transition: followed for this motion"),
          field("target", &Node::target, "", "transition: index of the next node")};
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

  static constexpr auto fields() {
    return Fields{field("motions", &MotionNet::motions, "", "the first is extern, without a name"),
                  field("nodes", &MotionNet::nodes),
                  field("entry", &MotionNet::entry, "", "index of the node of extern")};
  }
};

}  // namespace gt
