#include "JoystickDevice.h"

#include <fcntl.h>
#include <linux/joystick.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gt {
namespace {

constexpr double fullScale = 32767;

}  // namespace

Result<std::unique_ptr<JoystickDevice>> JoystickDevice::open(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
  if (file < 0)
    return Error{.file = path, .what = std::string{"cannot be opened: "} + std::strerror(errno)};
  return std::unique_ptr<JoystickDevice>{new JoystickDevice{file}};
}

JoystickDevice::~JoystickDevice() {
  close(file_);
}

void JoystickDevice::update(Console& console) {
  js_event event;
  while (read(file_, &event, sizeof event) == sizeof event) {
    const int type = event.type & ~JS_EVENT_INIT;
    if (type == JS_EVENT_AXIS && event.number < enumCount<Joystick::Axis>)
      input_.move(static_cast<Joystick::Axis>(event.number), event.value / fullScale);
    else if (type == JS_EVENT_BUTTON)
      JoystickInput::press(console, event.number + 1, event.value != 0);
  }
  input_.update(console);
}

}  // namespace gt
