#include "JoystickDevice.h"

#include <fcntl.h>
#include <linux/joystick.h>
#include <unistd.h>

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
  const auto execute = [&](const std::string& what, double value) {
    const auto done = console.execute("joystick " + what + " " + std::to_string(value));
    if (!done) console.print(done.error().text());
  };
  js_event event;
  while (file_ >= 0 && read(file_, &event, sizeof event) == sizeof event) {
    const int type = event.type & ~JS_EVENT_INIT;
    if (type == JS_EVENT_AXIS && event.number < enumCount<Joystick::Axis>)
      axes_.values[event.number] = event.value / fullScale;
    else if (type == JS_EVENT_BUTTON)
      execute(event.value ? "press" : "release", event.number + 1);
  }
  // The hat moves the head for as long as it is held.
  for (std::size_t i = 0; i < enumCount<Joystick::Axis>; ++i) {
    const auto axis = static_cast<Joystick::Axis>(i);
    const bool held = axis >= Joystick::Axis::hatX && axes_.values[i] != 0;
    if (!held && axes_.values[i] == told_.values[i]) continue;
    told_.values[i] = axes_.values[i];
    execute(std::string{enumName(axis)}, axes_.values[i]);
  }
}

}  // namespace gt
