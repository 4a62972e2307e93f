#include "modules/motion/specialactions/MotionNetLoader.h"

#include <cmath>
#include <vector>

#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// Motions that the modules of the motion ask for themselves.
constexpr std::string_view needed[] = {standAction, getupFromBelly, getupFromSide, getupFromBack,
                                       getupFromNose};

MotionNet::Node nodeOf(const motionnet::Node& from) {
  MotionNet::Node node;
  node.motion = from.motion;
  switch (from.kind) {
    case motionnet::Node::Kind::data:
      node.kind = MotionNodeKind::data;
      for (std::size_t i = 0; i < node.angles.size(); ++i) {
        node.dontCare[i] = !from.angles[i];
        node.angles[i] = from.angles[i].value_or(0) / 1000.0;
      }
      node.interpolate = from.interpolate;
      node.frames = from.frames;
      break;
    case motionnet::Node::Kind::odometry:
      node.kind = MotionNodeKind::odometry;
      node.speed = {from.rotation / 1000.0, static_cast<double>(from.x),
                    static_cast<double>(from.y)};
      break;
    case motionnet::Node::Kind::transition:
      node.kind = MotionNodeKind::transition;
      node.always = from.requested < 0;
      if (!node.always) node.requested = from.requested;
      break;
    case motionnet::Node::Kind::pid:
    case motionnet::Node::Kind::leave:
      node.kind = MotionNodeKind::leave;
  }
  return node;
}

}  // namespace

motionnet::Rules motionRules() {
  motionnet::Rules rules;
  for (int i = 0; i < MotionNet::jointCount; ++i) {
    const auto joint = static_cast<Joint>(i);
    const auto limits = limitsOf(joint);
    rules.joints.push_back({std::string{enumName(joint)},
                            static_cast<int>(std::ceil(limits.low * 1000)),
                            static_cast<int>(std::floor(limits.high * 1000))});
  }
  return rules;
}

Result<MotionNet> motionNetOf(const motionnet::Net& net, const std::string& source) {
  // The motors take no gains while they run: lines with gains are left out.
  std::vector<int> place;
  MotionNet result;
  for (const std::string& name : net.motions) result.motions.push_back({name, {}});
  result.motions[motionnet::Net::externMotion].name.clear();
  for (const auto name : needed)
    if (result.find(name) < 0)
      return Error{.file = source,
                   .field = std::string{name},
                   .what = "no motion description for this special action"};
  for (const auto& from : net.nodes) {
    place.push_back(static_cast<int>(result.nodes.size()));
    if (from.kind != motionnet::Node::Kind::pid) result.nodes.push_back(nodeOf(from));
  }
  for (std::size_t i = 0; i < net.nodes.size(); ++i)
    if (net.nodes[i].kind == motionnet::Node::Kind::transition)
      result.nodes[static_cast<std::size_t>(place[i])].target =
          place[static_cast<std::size_t>(net.nodes[i].target)];
  result.entry = place[static_cast<std::size_t>(net.entry)];
  return result;
}

Result<MotionNet> loadMotionNet(const std::string& folder) {
  const auto compilation = motionnet::compileFolder(folder, motionRules());
  if (compilation) return motionNetOf(compilation.net, folder);
  const auto& first = compilation.errors.front();
  return Error{.file = first.file, .line = first.line, .field = first.field, .what = first.message};
}

}  // namespace gt
