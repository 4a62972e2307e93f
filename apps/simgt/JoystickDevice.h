#pragma once
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

  /// Executes what came in since this was called last. Does not block.
  void update(Console& console);

 private:
  explicit JoystickDevice(int file) : file_{file} {}

  int file_;
  JoystickInput input_;
};

}  // namespace gt
