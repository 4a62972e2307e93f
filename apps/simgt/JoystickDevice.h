#pragma once
#include <string>

#include "console/Console.h"

namespace gt {

/// A joystick of this machine, by the kernel's device (/dev/input/js0), for a console.
class JoystickDevice {
 public:
  /// Does nothing if the path is empty or cannot be opened.
  explicit JoystickDevice(const std::string& path);
  ~JoystickDevice();
  JoystickDevice(const JoystickDevice&) = delete;
  JoystickDevice& operator=(const JoystickDevice&) = delete;

  /// Does what came in since this was called last: commands of buttons, walking and the head.
  void update(Console& console);

 private:
  int file_ = -1;
  EnumArray<Joystick::Axis, double> axes_, told_;
};

}  // namespace gt
