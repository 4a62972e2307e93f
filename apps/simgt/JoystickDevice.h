#pragma once
#include <chrono>
#include <memory>
#include <string>

#include "console/Console.h"

namespace gt {

/// A joystick of this machine, by the kernel's device (/dev/input/js0) or any file or pipe with its
/// events, for a console.
class JoystickDevice {
 public:
  /// An error if the device cannot be opened.
  static Result<std::unique_ptr<JoystickDevice>> open(const std::string& path);
  ~JoystickDevice();
  JoystickDevice(const JoystickDevice&) = delete;
  JoystickDevice& operator=(const JoystickDevice&) = delete;

  /// Executes what came in since this was called last: commands of buttons at once, movements of
  /// axes at most every 300 ms (report J.5.5), of a hat that is held more often. Does not block.
  void update(Console& console);

 private:
  using Clock = std::chrono::steady_clock;
  using Axes = EnumArray<Joystick::Axis, double>;

  explicit JoystickDevice(int file) : file_{file} {}
  void moveAxes(Console& console);

  int file_;
  Axes axes_, sent_;
  Time sentAt_ = never();
  Clock::time_point sentAtClock_{};
};

}  // namespace gt
