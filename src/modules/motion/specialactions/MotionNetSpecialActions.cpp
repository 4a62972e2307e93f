#include "modules/motion/specialactions/MotionNetSpecialActions.h"

#include <algorithm>

namespace gt {
namespace {

constexpr double frameTime = 0.008;  // s

bool contains(const MotionNet& net, int node) {
  return node >= 0 && node < static_cast<int>(net.nodes.size());
}

}  // namespace

SpecialAction specialActionOf(const MotionRequest& request) {
  if (request.type == MotionType::getup) return SpecialAction::getup;
  return request.type == MotionType::specialAction ? request.specialAction : SpecialAction::none;
}

void MotionNetSpecialActions::update(const FrameInfo& frame, const MotionRequest& request,
                                     const MotionNet& net, Previous<MotionInfo> motion,
                                     Previous<JointData> joints, SpecialActionsOutput& output) {
  const auto executed = motion->executed.type;
  const bool active = executed == MotionType::specialAction || executed == MotionType::getup;
  if (!active || !contains(net, node_)) node_ = -1;  // a net put in for another may be shorter
  if (active && (node_ < 0 || framesLeft_ == 0))
    advance(net, specialActionOf(request.validAt(frame.time)), joints->angles);
  output.joints = joints.value;
  std::fill(output.dontCare.begin(), output.dontCare.end(), true);
  output.odometryStep = {};
  output.mayLeave = node_ < 0;
  output.action = SpecialAction::none;
  if (node_ >= 0) play(net.nodes[static_cast<std::size_t>(node_)], output);
}

void MotionNetSpecialActions::advance(const MotionNet& net, SpecialAction requested,
                                      const JointAngles& now) {
  const bool entering = node_ < 0;
  int next = entering ? net.entry : node_ + 1;
  if (entering) speed_ = {};
  auto action = entering ? SpecialAction::none : net.nodes[static_cast<std::size_t>(node_)].action;
  node_ = -1;
  // The compiler rules out loops without data; the bound keeps a wrong net from hanging the robot.
  for (std::size_t steps = 0; steps < net.nodes.size() && contains(net, next); ++steps) {
    const auto& node = net.nodes[static_cast<std::size_t>(next)];
    if (node.action != action) speed_ = {};
    action = node.action;
    if (node.kind == MotionNodeKind::leave) return;
    if (node.kind == MotionNodeKind::data) {
      node_ = next;
      framesLeft_ = node.frames;
      from_ = now;
      return;
    }
    if (node.kind == MotionNodeKind::odometry) speed_ = node.speed;
    const bool follow =
        node.kind == MotionNodeKind::transition && (node.always || node.requested == requested);
    next = follow ? node.target : next + 1;
  }
}

void MotionNetSpecialActions::play(const MotionNet::Node& node, SpecialActionsOutput& output) {
  --framesLeft_;
  const double share =
      node.interpolate ? 1 - static_cast<double>(framesLeft_) / std::max(node.frames, 1) : 1;
  for (std::size_t i = 0; i < node.angles.size(); ++i) {
    output.dontCare.values[i] = node.dontCare[i];
    if (!node.dontCare[i])
      output.joints.angles.values[i] = from_.values[i] + share * (node.angles[i] - from_.values[i]);
  }
  output.odometryStep = {speed_.rotation * frameTime, speed_.translation * frameTime};
  output.action = node.action;
}

}  // namespace gt
