#include "console/JoystickInput.h"

#include "console/Console.h"

namespace gt {
namespace {

constexpr std::chrono::milliseconds axesPeriod{300}, hatPeriod{40};
constexpr int axes = 4;  // beside the hat: x, y, z, accelerator

void execute(Console& console, const std::string& line) {
  if (const auto done = console.executeInput(line); !done) console.print(done.error().text());
}

}  // namespace

void JoystickInput::press(Console& console, int button, bool down) {
  if (button < 1 || button > Joystick::buttons) return;
  execute(console,
          std::string{"joystick "} + (down ? "press " : "release ") + std::to_string(button));
}

void JoystickInput::take(Console& console, SdlJoystick& device) {
  using Part = SdlJoystick::Part;
  for (const SdlJoystick::Event& event : device.take()) {
    if (event.part == Part::button)
      press(console, event.number + 1, event.value > 0);
    else if (event.part == Part::axis && event.number < axes)
      move(static_cast<Joystick::Axis>(event.number), event.value);
    else if (event.part != Part::axis && event.number == 0)
      move(event.part == Part::hatX ? Joystick::Axis::hatX : Joystick::Axis::hatY, event.value);
  }
}

void JoystickInput::update(Console& console) {
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
