#include "modules/motion/getup/GravityGetupEngine.h"

#include <algorithm>
#include <cmath>

#include "modules/motion/Tasks.h"

namespace gt {
namespace {}  // namespace

std::string_view GravityGetupEngine::actionFor(const Vector3d& up) const {
  const double aside = std::abs(up.y());
  if (up.z() < -aside) return getupFromBack;
  if (up.z() > std::cos(parameters.upright)) return getupFromBelly;
  if (aside > std::abs(up.x())) return getupFromSide;
  return up.x() < 0 ? getupFromNose : getupFromBelly;
}

void GravityGetupEngine::update(const FrameInfo& frame, const SensorDataBuffer& sensors,
                                const MotionNet& net, Previous<MotionInfo> motion,
                                Previous<JointData> joints, GetupEngineOutput& output,
                                Debug& debug) {
  const double share = std::min(1., frameTime / parameters.average);
  acceleration_ += share * (sensors.newest().acceleration - acceleration_);
  const bool begins = !active_;
  active_ = motion->executed.type == MotionType::getup;
  if (active_ && (begins || performed_.mayLeave)) {
    const Vector3d up = acceleration_.normalized();
    const bool done = !begins && up.z() > std::cos(parameters.upright);
    output.action = done ? std::string_view{} : actionFor(up);
  }
  if (!active_) output.action.clear();

  MotionRequest request;
  request.time = frame.time;
  MotionInfo performing;  // as if it were the net's turn
  if (!output.action.empty()) {
    performing.executed.type = MotionType::specialAction;
    // Once it has begun it is no longer requested: it would be repeated.
    request.type = performed_.mayLeave ? MotionType::specialAction : MotionType::stand;
    request.specialAction = output.action;
  }
  actions_.update(frame, request, net, {performing}, joints, performed_, debug);
  output.joints = performed_.joints;
  output.dontCare = performed_.dontCare;
  output.gains = performed_.gains;
  output.mayLeave = performed_.mayLeave;
}

}  // namespace gt
