#include "modules/motion/specialactions/MotionNetLoader.h"

#include <cmath>
#include <vector>

#include "representations/behavior/MotionRequest.h"
#include "representations/infrastructure/RobotDimensions.h"

namespace gt {
namespace {

/// Motions that the modules of the motion request themselves.
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
    case motionnet::Node::Kind::displacement:
      node.kind = MotionNodeKind::displacement;
      node.displacement = {from.rotation / 1000.0, static_cast<double>(from.x),
                           static_cast<double>(from.y)};
      break;
    case motionnet::Node::Kind::pid:
      node.kind = MotionNodeKind::pid;
      node.joint = static_cast<Joint>(from.joint);
      node.gains = {from.p, from.i, from.d};
      break;
    case motionnet::Node::Kind::transition:
      node.kind = MotionNodeKind::transition;
      node.always = from.requested < 0;
      if (!node.always) node.requested = from.requested;
      node.target = from.target;
      break;
    case motionnet::Node::Kind::leave:
      node.kind = MotionNodeKind::leave;
  }
  return node;
}

Error firstOf(const std::vector<motionnet::Diagnostic>& errors) {
  const auto& first = errors.front();
  return {.file = first.file, .line = first.line, .field = first.field, .what = first.message};
}

}  // namespace

motionnet::Rules motionRules() {
  motionnet::Rules rules;
  for (int i = 0; i < MotionNet::jointCount; ++i) {
    const auto joint = static_cast<Joint>(i);
    const auto limits = limitsOf(joint);
    rules.joints.push_back({std::string{enumName(joint)},
                            static_cast<int>(std::lround(limits.low * 1000)),
                            static_cast<int>(std::lround(limits.high * 1000))});
  }
  return rules;
}

Result<MotionNet> motionNetOf(const motionnet::Net& net, const std::string& source) {
  MotionNet result;
  for (const std::string& name : net.motions) result.motions.push_back({name, {}});
  result.motions[motionnet::Net::externMotion].name.clear();
  for (const auto name : needed)
    if (result.find(name) < 0)
      return Error{.file = source,
                   .field = std::string{name},
                   .what = "no motion description for this special action"};
  for (const auto& from : net.nodes) result.nodes.push_back(nodeOf(from));
  result.entry = net.entry;
  return result;
}

Result<JointDataSequence> jointDataOf(const std::string& text, const std::string& file,
                                      const std::string& folder) {
  std::vector<motionnet::Diagnostic> errors;
  const auto others = motionnet::readFolder(folder, errors);
  std::vector<motionnet::Node> data;
  if (errors.empty()) data = motionnet::dataOf({file, text}, others, motionRules(), errors);
  if (!errors.empty()) return firstOf(errors);
  if (data.empty()) return Error{.file = file, .what = "holds no line of joint data"};
  JointDataSequence sequence;
  for (const auto& node : data) {
    const MotionNet::Node line = nodeOf(node);
    sequence.lines.push_back({line.angles, line.dontCare, line.interpolate, line.frames});
  }
  return sequence;
}

Result<MotionNet> loadMotionNet(const std::string& folder) {
  const auto compilation = motionnet::compileFolder(folder, motionRules());
  if (compilation) return motionNetOf(compilation.net, folder);
  return firstOf(compilation.errors);
}

}  // namespace gt
