#include "modules/motion/control/DebugMotionControl.h"

#include <algorithm>
#include <cmath>

#include "modules/motion/control/MotorLimits.h"

namespace gt {

void DebugMotionControl::update(const SensorDataBuffer& sensors, const JointDataSequence& sequence,
                                JointData& joints, JointGains& gains, OdometryData& /*odometry*/,
                                MotionInfo& info) {
  const JointAngles& measured = sensors.newest().joints;
  if (!begun_) angles_ = measured;
  begun_ = true;
  if (sequence.number != number_) {
    playing_ = !sequence.lines.empty();
    line_ = 0;
    frame_ = 0;
    from_ = angles_;
  }
  number_ = sequence.number;
  if (playing_) {
    play(sequence);
    settling_ = parameters.settling;
  } else if (settling_ > 0) {
    settling_ -= frameTime;
  } else {
    stayAsForced(measured);
  }
  keepWithinLimits(angles_);
  joints.angles = angles_;
  gains = {};
  info = {};
  info.executed.type = MotionType::specialAction;
  info.stable = false;
}

void DebugMotionControl::play(const JointDataSequence& sequence) {
  if (line_ >= sequence.lines.size()) {  // other lines under the same number
    playing_ = false;
    return;
  }
  const JointDataSequence::Line& line = sequence.lines[line_];
  ++frame_;
  const int frames = std::max(line.frames, 1);
  const double share = line.interpolate ? static_cast<double>(frame_) / frames : 1;
  for (std::size_t i = 0; i < line.angles.size(); ++i)
    if (!line.dontCare[i])
      angles_.values[i] = from_.values[i] + share * (line.angles[i] - from_.values[i]);
  if (frame_ < frames) return;
  frame_ = 0;
  from_ = angles_;
  if (++line_ < sequence.lines.size()) return;
  line_ = 0;
  playing_ = sequence.loop;
}

void DebugMotionControl::stayAsForced(const JointAngles& measured) {
  for (std::size_t i = 0; i < measured.size(); ++i)
    if (std::abs(measured.values[i] - angles_.values[i]) > parameters.tolerance)
      angles_.values[i] = measured.values[i];
}

}  // namespace gt
