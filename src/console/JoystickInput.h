#pragma once
#include <chrono>

#include "base/Time.h"
#include "console/Joystick.h"
#include "devices/SdlJoystick.h"

namespace gt {

class Console;

/// Turns what happens on a joystick into commands of a console: those of buttons at once, movements
/// of axes at most every 300 ms (report J.5.5), of a hat that is held more often.
class JoystickInput {
 public:
  /// Takes all that has happened on a device.
  void take(Console& console, SdlJoystick& device);
  /// Passes the axes on if that is due.
  void update(Console& console);

 private:
  using Clock = std::chrono::steady_clock;
  using Axes = EnumArray<Joystick::Axis, double>;

  static void press(Console& console, int button, bool down);
  void move(Joystick::Axis axis, double value) { axes_[axis] = value; }

  Axes axes_, sent_;
  Time sentAt_ = never();
  Clock::time_point sentAtClock_{};
};

}  // namespace gt
