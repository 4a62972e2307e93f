// The devices of a build without SDL: there are none.
#include "devices/SdlJoystick.h"
#include "devices/SdlSpeaker.h"

namespace gt {
namespace {

Error none(const char* device) {
  return {.what = std::string{"cannot be used: "} + device +
                  " need SDL, which this build has not; install libsdl2-dev and build anew"};
}

}  // namespace

struct SdlJoystick::Device {};

SdlJoystick::SdlJoystick(std::unique_ptr<Device> device) : device_{std::move(device)} {}
SdlJoystick::~SdlJoystick() = default;

Result<std::unique_ptr<SdlJoystick>> SdlJoystick::open() {
  return none("joysticks");
}

std::string SdlJoystick::name() const {
  return {};
}

std::vector<SdlJoystick::Event> SdlJoystick::take() {
  return {};
}

struct SdlSpeaker::Device {};

SdlSpeaker::SdlSpeaker() = default;
SdlSpeaker::~SdlSpeaker() = default;

Result<void> SdlSpeaker::play(const std::string& file) {
  Error error = none("loudspeakers");
  error.file = file;
  return error;
}

bool SdlSpeaker::plays() const {
  return false;
}

}  // namespace gt
