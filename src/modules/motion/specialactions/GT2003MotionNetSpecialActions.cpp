#include "modules/motion/specialactions/GT2003MotionNetSpecialActions.h"

#include <algorithm>
#include <cmath>

#include "modules/motion/Tasks.h"

namespace gt {
namespace {

bool contains(const MotionNet& net, int node) {
  return node >= 0 && node < static_cast<int>(net.nodes.size());
}

/// One of `count` equal steps along an arc whose sum is a displacement.
Pose2D stepOf(const Pose2D& displacement, int count) {
  const double whole = displacement.rotation, part = whole / count;
  // The chord of a share of the arc: shorter than a share of the chord, and turned.
  const double shrink =
      std::abs(std::sin(whole / 2)) < 1e-9 ? 1. / count : std::sin(part / 2) / std::sin(whole / 2);
  const double turn = (part - whole) / 2;
  const Vector2d& to = displacement.translation;
  return {part, shrink * (std::cos(turn) * to.x() - std::sin(turn) * to.y()),
          shrink * (std::sin(turn) * to.x() + std::cos(turn) * to.y())};
}

}  // namespace

std::string_view specialActionOf(const MotionRequest& request) {
  return request.type == MotionType::specialAction ? std::string_view{request.specialAction}
                                                   : std::string_view{};
}

void GT2003MotionNetSpecialActions::update(const FrameInfo& frame, const MotionRequest& request,
                                           const MotionNet& net, Previous<MotionInfo> motion,
                                           Previous<JointData> joints, SpecialActionsOutput& output,
                                           Debug& debug) {
  const bool active = motion->executed.type == MotionType::specialAction;
  if (!active || !contains(net, node_)) node_ = -1;  // a net put in for another may be shorter
  const int requested = requestedMotion(net, specialActionOf(request.validAt(frame.time)), debug);
  if (active && (node_ < 0 || framesLeft_ == 0)) advance(net, requested, joints->angles);
  output.joints = joints.value;
  std::fill(output.dontCare.begin(), output.dontCare.end(), true);
  output.odometryStep = {};
  output.mayLeave = node_ < 0;
  output.action.clear();
  if (node_ < 0)
    begin();
  else
    play(net, output);
  output.gains = gains_;
}

int GT2003MotionNetSpecialActions::requestedMotion(const MotionNet& net, std::string_view name,
                                                   Debug& debug) {
  const auto isIndex = [&] { return static_cast<std::size_t>(requested_) < net.motions.size(); };
  if (name == name_ && isIndex()) return requested_;
  name_ = name;
  requested_ = net.find(name);
  if (!isIndex()) {
    debug.text(name_ + ": there is no special action of this name");
    requested_ = 0;
  }
  return requested_;
}

void GT2003MotionNetSpecialActions::begin() {
  speed_ = {};
  gains_ = {};
}

void GT2003MotionNetSpecialActions::advance(const MotionNet& net, int requested,
                                            const JointAngles& now) {
  const bool entering = node_ < 0;
  int next = entering ? net.entry : node_ + 1;
  if (entering) begin();
  Pose2D displacement;
  int motion = entering ? 0 : net.nodes[static_cast<std::size_t>(node_)].motion;
  node_ = -1;
  // The compiler rules out loops without data; the bound keeps a wrong net from hanging the robot.
  for (std::size_t steps = 0; steps < net.nodes.size() && contains(net, next); ++steps) {
    const auto& node = net.nodes[static_cast<std::size_t>(next)];
    if (node.motion != motion) {
      begin();
      displacement = {};
    }
    motion = node.motion;
    if (node.kind == MotionNodeKind::leave) return;
    if (node.kind == MotionNodeKind::data) {
      node_ = next;
      framesLeft_ = node.frames;
      from_ = now;
      dataStep_ = stepOf(displacement, std::max(node.frames, 1));
      return;
    }
    if (node.kind == MotionNodeKind::odometry) speed_ = node.speed;
    if (node.kind == MotionNodeKind::displacement) displacement = node.displacement;
    if (node.kind == MotionNodeKind::pid) gains_.gains[node.joint] = node.gains;
    const bool follow =
        node.kind == MotionNodeKind::transition && (node.always || node.requested == requested);
    next = follow ? node.target : next + 1;
  }
}

void GT2003MotionNetSpecialActions::play(const MotionNet& net, SpecialActionsOutput& output) {
  const MotionNet::Node& node = net.nodes[static_cast<std::size_t>(node_)];
  --framesLeft_;
  const double share =
      node.interpolate ? 1 - static_cast<double>(framesLeft_) / std::max(node.frames, 1) : 1;
  for (std::size_t i = 0; i < node.angles.size(); ++i) {
    output.dontCare.values[i] = node.dontCare[i];
    if (!node.dontCare[i])
      output.joints.angles.values[i] = from_.values[i] + share * (node.angles[i] - from_.values[i]);
  }
  output.odometryStep =
      Pose2D{speed_.rotation * frameTime, speed_.translation * frameTime} * dataStep_;
  if (static_cast<std::size_t>(node.motion) < net.motions.size())
    output.action = net.motions[static_cast<std::size_t>(node.motion)].name;
}

}  // namespace gt
