#include "JoystickDevice.h"

#include <fcntl.h>
#include <linux/joystick.h>
#include <unistd.h>

#include "console/Commands.h"

namespace gt {
namespace {

constexpr double fullScale = 32767;

}  // namespace

JoystickDevice::JoystickDevice(const std::string& path) {
  if (!path.empty()) file_ = open(path.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
}

JoystickDevice::~JoystickDevice() {
  if (file_ >= 0) close(file_);
}

void JoystickDevice::update(Console& console) {
  js_event event;
  while (file_ >= 0 && read(file_, &event, sizeof event) == sizeof event) {
    const int type = event.type & ~JS_EVENT_INIT;
    if (type == JS_EVENT_AXIS && event.number < enumCount<Joystick::Axis>) {
      console.joystick().move(static_cast<Joystick::Axis>(event.number), event.value / fullScale);
    } else if (type == JS_EVENT_BUTTON) {
      const auto command = console.joystick().press(event.number + 1, event.value != 0);
      if (!command) continue;
      if (const auto done = console.execute(*command); !done) console.print(done.error().text());
    }
  }
  if (file_ < 0) return;
  if (const auto done = moveByJoystick(console); !done) console.print(done.error().text());
}

}  // namespace gt
