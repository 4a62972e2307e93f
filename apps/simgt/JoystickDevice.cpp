#include "JoystickDevice.h"

#include <fcntl.h>
#include <linux/joystick.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace gt {
namespace {

constexpr double fullScale = 32767;
constexpr std::chrono::milliseconds axesPeriod{300}, hatPeriod{40};

void execute(Console& console, const std::string& line) {
  if (const auto done = console.executeInput(line); !done) console.print(done.error().text());
}

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
      axes_.values[event.number] = event.value / fullScale;
    else if (type == JS_EVENT_BUTTON && event.number < Joystick::buttons)
      execute(console, std::string{"joystick "} + (event.value ? "press " : "release ") +
                           std::to_string(event.number + 1));
  }
  moveAxes(console);
}

void JoystickDevice::moveAxes(Console& console) {
  const bool hatHeld = axes_[Joystick::Axis::hatX] != 0 || axes_[Joystick::Axis::hatY] != 0;
  if (!hatHeld && axes_.values == sent_.values) return;
  const Time now = console.session().time();
  const auto clock = Clock::now();
  const auto least = hatHeld ? hatPeriod : axesPeriod;
  // Simulated time may stand, or pass much faster than the clock.
  if (now - sentAt_ < least.count() && clock - sentAtClock_ < least) return;
  std::string line = "joystick";
  for (std::size_t i = 0; i < enumCount<Joystick::Axis>; ++i)
    line += " " + std::string{enumNames<Joystick::Axis>[i]} + " " + std::to_string(axes_.values[i]);
  sent_ = axes_;
  sentAt_ = now;
  sentAtClock_ = clock;
  execute(console, line);
}

}  // namespace gt
