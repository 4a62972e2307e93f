#include "console/Joystick.h"

#include <algorithm>

#include "console/JoystickRange.h"

namespace gt {
namespace {

constexpr double hatSpeed = 0.5;  // rad/s

}  // namespace

std::optional<std::string> Joystick::press(int button, bool down) {
  if (button < 1 || button > buttons) return std::nullopt;
  down_[static_cast<std::size_t>(button)] = down;
  const auto command = commands_.find(button);
  if (!down || command == commands_.end() || command->second.empty()) return std::nullopt;
  return command->second;
}

bool Joystick::pressed() const {
  return std::any_of(down_.begin(), down_.end(), [](bool down) { return down; });
}

std::optional<Pose2D> Joystick::walk() {
  if (!moved_ || pressed()) return std::nullopt;
  const Pose2D speed{-axes_[Axis::z] * fastestTurn, -axes_[Axis::y] * fastestAhead,
                     -axes_[Axis::x] * fastestSideways};
  if (speed.translation == lastWalk_.translation && speed.rotation == lastWalk_.rotation)
    return std::nullopt;
  lastWalk_ = speed;
  return speed;
}

std::optional<HeadMotionRequest> Joystick::head(Time now) {
  if (!moved_) return std::nullopt;
  const double seconds = lastHead_ == never() ? 0 : static_cast<double>(now - lastHead_) / 1000;
  lastHead_ = now;
  const HeadMotionRequest before = head_;
  const std::array<double*, 3> joints{&head_.tilt, &head_.pan, &head_.roll};
  constexpr std::array widest{widestTilt, widestPan, widestRoll};
  const auto lever = static_cast<std::size_t>(headAxis_);
  *joints[lever] = axes_[Axis::accelerator] * widest[lever];
  // The hat's two directions move the other two joints, in their order.
  std::array hat{axes_[Axis::hatY], axes_[Axis::hatX]};
  for (std::size_t joint = 0, next = 0; joint < joints.size(); ++joint)
    if (joint != lever)
      *joints[joint] = std::clamp(*joints[joint] - hat[next++] * hatSpeed * seconds, -widest[joint],
                                  widest[joint]);
  if (head_.tilt == before.tilt && head_.pan == before.pan && head_.roll == before.roll)
    return std::nullopt;
  return head_;
}

}  // namespace gt
