#pragma once
#include <SDL2/SDL.h>
#include <gtest/gtest.h>

namespace gt {

/// A joystick with four axes, eight buttons and a hat that SDL takes for a real one.
class VirtualJoystick {
 public:
  VirtualJoystick() {
    SDL_InitSubSystem(SDL_INIT_JOYSTICK);
    plugIn();
  }
  ~VirtualJoystick() {
    pullOut();
    SDL_QuitSubSystem(SDL_INIT_JOYSTICK);
  }
  VirtualJoystick(const VirtualJoystick&) = delete;
  VirtualJoystick& operator=(const VirtualJoystick&) = delete;

  void plugIn() {
    index_ = SDL_JoystickAttachVirtual(SDL_JOYSTICK_TYPE_FLIGHT_STICK, 4, 8, 1);
    EXPECT_GE(index_, 0) << SDL_GetError();
    joystick_ = SDL_JoystickOpen(index_);
  }
  void pullOut() {
    if (!joystick_) return;
    SDL_JoystickClose(joystick_);
    joystick_ = nullptr;
    SDL_JoystickDetachVirtual(index_);
  }
  SDL_Joystick* operator*() { return joystick_; }

 private:
  int index_ = -1;
  SDL_Joystick* joystick_ = nullptr;
};

}  // namespace gt
