#include "modules/modeling/robotstate/DefaultRobotStateDetector.h"

namespace gt {

void DefaultRobotStateDetector::update(const BodyPercept& body, const FrameInfo& frame,
                                       RobotState& state) {
  if (body.state != perceived_) {
    perceived_ = body.state;
    perceivedSince_ = frame.time;
  }
  if (perceived_ != believed_ && frame.time - perceivedSince_ >= parameters.settleTime) {
    believed_ = perceived_;
    lastChange_ = perceivedSince_;
  }
  state.state = believed_;
  state.lastChange = lastChange_;
  state.tailPan = body.tailPan;
  for (std::size_t i = 0; i < enumCount<Switch>; ++i) {
    const auto which = static_cast<Switch>(i);
    if (body.switches[which] && !pressed_[which]) pressedSince_[which] = frame.time;
    pressed_[which] = body.switches[which];
    state.pressedFor[which] = pressed_[which] ? frame.time - pressedSince_[which] : 0;
  }
}

}  // namespace gt
