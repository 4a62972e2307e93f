#include "console/JoystickScheme.h"

#include <algorithm>
#include <cmath>

#include "console/JoystickRange.h"

namespace gt {
namespace {

constexpr double deadZone = 0.05;  // in which a stick that nobody holds may stand

double outsideDeadZone(double value) {
  return std::abs(value) < deadZone ? 0 : value;
}

bool same(const MotionRequest& a, const MotionRequest& b) {
  return a.type == b.type && a.walkType == b.walkType && a.specialAction == b.specialAction &&
         a.walk.rotation == b.walk.rotation && a.walk.translation == b.walk.translation;
}

bool same(const HeadMotionRequest& a, const HeadMotionRequest& b) {
  return a.tilt == b.tilt && a.pan == b.pan && a.roll == b.roll && a.mouth == b.mouth;
}

}  // namespace

void JoystickScheme::move(Joystick::Axis axis, double value) {
  if (axis == Joystick::Axis::accelerator && (value != axes_[axis] || !leverMoved_)) {
    leverMoved_ = true;
    if (isDown(actionButton)) actionChosen_ = true;
    if (kind_ == JoystickSchemeKind::stickSpeed && !isDown(actionButton)) {
      axes_[axis] = value;
      headMode_ = static_cast<HeadMode>(atLever(enumCount<HeadMode>));
    }
  }
  axes_[axis] = value;
  update();
}

void JoystickScheme::press(int button, bool down) {
  if (button < 1 || button > Joystick::buttons) return;
  down_[static_cast<std::size_t>(button)] = down;
  if (button == actionButton) actionChosen_ = false;
  if (down && button == walkTypeButton())
    walkType_ =
        static_cast<WalkType>((static_cast<std::size_t>(walkType_) + 1) % enumCount<WalkType>);
  update();
}

JoystickScheme::Changes JoystickScheme::takeChanges() {
  Changes changes;
  if (!same(motion_, takenMotion_)) changes.motion = motion_;
  if (headMode() != takenMode_) changes.headMode = headMode();
  if (!same(head_, takenHead_)) changes.head = head_;
  takenMotion_ = motion_;
  takenMode_ = headMode();
  takenHead_ = head_;
  return changes;
}

std::size_t JoystickScheme::atLever(std::size_t count) const {
  const double share = (1 - axes_[Joystick::Axis::accelerator]) / 2;
  return std::min(count - 1,
                  static_cast<std::size_t>(std::max(0., share * static_cast<double>(count))));
}

std::string JoystickScheme::action() const {
  for (std::size_t i = 0; i < std::min<std::size_t>(kicks_.size(), 4); ++i)
    if (isDown(static_cast<int>(i) + 1)) return kicks_[i];
  const bool chosen = kind_ == JoystickSchemeKind::stickSpeed && actionChosen_ && !actions_.empty();
  return chosen && isDown(actionButton) ? actions_[atLever(actions_.size())] : "";
}

Pose2D JoystickScheme::walk() const {
  using enum Joystick::Axis;
  if (movesHead()) return {};
  const double lever = leverMoved_ ? (1 - axes_[accelerator]) / 2 : 0;
  const double ahead = kind_ == JoystickSchemeKind::acceleratorSpeed ? outsideDeadZone(lever)
                                                                     : -outsideDeadZone(axes_[y]);
  return {-outsideDeadZone(axes_[z]) * fastestTurn, ahead * fastestAhead,
          -outsideDeadZone(axes_[x]) * fastestSideways};
}

void JoystickScheme::update() {
  using enum Joystick::Axis;
  if (movesHead()) {
    head_.tilt = -axes_[y] * widestTilt;
    head_.pan = -axes_[x] * widestPan;
    head_.roll = axes_[z] * widestRoll;
  }
  motion_ = {};
  motion_.walkType = walkType_;
  motion_.specialAction = action();
  if (isDown(getupButton)) {
    motion_.type = MotionType::getup;
    motion_.specialAction.clear();
  } else if (!motion_.specialAction.empty()) {
    motion_.type = MotionType::specialAction;
  } else {
    motion_.walk = walk();
    const bool stands = motion_.walk.rotation == 0 && motion_.walk.translation == Vector2d::Zero();
    motion_.type = stands ? MotionType::stand : MotionType::walk;
  }
}

}  // namespace gt
