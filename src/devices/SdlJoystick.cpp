#include "devices/SdlJoystick.h"

#include <SDL2/SDL.h>

#include <algorithm>

namespace gt {
namespace {

constexpr double fullScale = 32767;

std::string reason(const char* what) {
  return std::string{what} + ": " + SDL_GetError();
}

}  // namespace

/// The subsystem of SDL, and the joystick that is open in it.
struct SdlJoystick::Device {
  SDL_Joystick* joystick = nullptr;

  Device() = default;
  ~Device() {
    close();
    SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  void openFirst() {
    if (!joystick && SDL_NumJoysticks() > 0) joystick = SDL_JoystickOpen(0);
  }
  void close() {
    if (joystick) SDL_JoystickClose(joystick);
    joystick = nullptr;
  }
  bool is(SDL_JoystickID id) const {
    return joystick != nullptr && SDL_JoystickInstanceID(joystick) == id;
  }
};

SdlJoystick::SdlJoystick(std::unique_ptr<Device> device) : device_{std::move(device)} {}
SdlJoystick::~SdlJoystick() = default;

Result<std::unique_ptr<SdlJoystick>> SdlJoystick::open() {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // Ctrl-C is the program's
  SDL_SetHint(SDL_HINT_JOYSTICK_ALLOW_BACKGROUND_EVENTS, "1");
  if (SDL_InitSubSystem(SDL_INIT_JOYSTICK) != 0)
    return Error{.field = "joystick", .what = reason("SDL cannot look for joysticks")};
  auto device = std::make_unique<Device>();
  device->openFirst();
  if (!device->joystick)
    return Error{.field = "joystick",
                 .what = SDL_NumJoysticks() > 0 ? reason("cannot be opened")
                                                : std::string{"none is plugged in"}};
  return std::unique_ptr<SdlJoystick>{new SdlJoystick{std::move(device)}};
}

std::string SdlJoystick::name() const {
  const char* name = SDL_JoystickName(device_->joystick);
  return name ? name : "";
}

std::vector<SdlJoystick::Event> SdlJoystick::take() {
  std::vector<Event> events;
  SDL_Event event;
  while (SDL_PollEvent(&event) != 0) {
    if (event.type == SDL_JOYDEVICEADDED) {
      device_->openFirst();
    } else if (event.type == SDL_JOYDEVICEREMOVED && device_->is(event.jdevice.which)) {
      device_->close();
      device_->openFirst();
    } else if (event.type == SDL_JOYAXISMOTION && device_->is(event.jaxis.which)) {
      events.push_back(
          {Part::axis, event.jaxis.axis, std::max(-1., event.jaxis.value / fullScale)});
    } else if (event.type == SDL_JOYHATMOTION && device_->is(event.jhat.which)) {
      const auto held = [&](int direction) { return (event.jhat.value & direction) != 0 ? 1 : 0; };
      const int hat = event.jhat.hat;
      events.push_back({Part::hatX, hat, 1. * (held(SDL_HAT_RIGHT) - held(SDL_HAT_LEFT))});
      events.push_back({Part::hatY, hat, 1. * (held(SDL_HAT_DOWN) - held(SDL_HAT_UP))});
    } else if ((event.type == SDL_JOYBUTTONDOWN || event.type == SDL_JOYBUTTONUP) &&
               device_->is(event.jbutton.which)) {
      events.push_back(
          {Part::button, event.jbutton.button, event.jbutton.state == SDL_PRESSED ? 1. : 0.});
    }
  }
  return events;
}

}  // namespace gt
