#pragma once
#include <chrono>

#include "base/Time.h"
#include "console/Joystick.h"
#include "devices/SdlJoystick.h"

namespace gt {

class Console;

/// Converts events of a joystick into commands of a console: those of buttons at once, movements of
/// axes at most every 300 ms (report J.5.5), of a hat that is held at most every 40 ms.
class JoystickInput {
 public:
  /// Processes all pending events of a device.
  void take(Console& console, SdlJoystick& device);
  /// Sends the axes to the console if that is due.
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
