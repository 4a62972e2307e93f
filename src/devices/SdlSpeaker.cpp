#include "devices/SdlSpeaker.h"

#include <SDL2/SDL.h>

namespace gt {

struct SdlSpeaker::Device {
  SDL_AudioDeviceID id = 0;

  explicit Device(const SDL_AudioSpec& wave)
      : id{SDL_OpenAudioDevice(nullptr, 0, &wave, nullptr, 0)} {}
  ~Device() {
    if (id != 0) SDL_CloseAudioDevice(id);
  }
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;
};

SdlSpeaker::SdlSpeaker() = default;
SdlSpeaker::~SdlSpeaker() {
  if (!device_) return;
  device_.reset();
  SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

Result<void> SdlSpeaker::play(const std::string& file) {
  SDL_AudioSpec wave;
  Uint8* samples = nullptr;
  Uint32 size = 0;
  if (!SDL_LoadWAV(file.c_str(), &wave, &samples, &size))
    return Error{.file = file, .what = std::string{"cannot be played: "} + SDL_GetError()};
  const std::unique_ptr<Uint8, void (*)(Uint8*)> free{samples, SDL_FreeWAV};
  if (!device_ && SDL_InitSubSystem(SDL_INIT_AUDIO) != 0)
    return Error{.what = std::string{"there is no audio: "} + SDL_GetError()};
  // Files may differ in their format, so each has the device opened anew.
  device_.reset();
  device_ = std::make_unique<Device>(wave);
  if (device_->id == 0 || SDL_QueueAudio(device_->id, samples, size) != 0)
    return Error{.what = std::string{"there is no loudspeaker: "} + SDL_GetError()};
  SDL_PauseAudioDevice(device_->id, 0);
  return {};
}

bool SdlSpeaker::plays() const {
  return device_ && device_->id != 0 && SDL_GetQueuedAudioSize(device_->id) > 0;
}

}  // namespace gt
