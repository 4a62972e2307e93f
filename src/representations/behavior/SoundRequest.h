#pragma once
#include "base/Enum.h"
#include "base/Time.h"
#include "streams/Reflection.h"

namespace gt {

/// The sounds that the robot can play: each is the wave file of that name in `sounds/`.
enum class Sound { none, bing, rise, fall, warning, fanfare };

/// What the robot's loudspeaker shall play (report 3.8). Provided by BehaviorControl.
struct SoundRequest {
  Sound sound = Sound::none;

  static constexpr auto fields() {
    return Fields{field<&SoundRequest::sound>("sound that is played once when it is requested")};
  }
};

/// The sound that the loudspeaker plays. Provided by SoundControl.
struct Speaker {
  Sound sound = Sound::none;
  Time began = never();

  static constexpr auto fields() {
    return Fields{field<&Speaker::sound>("the sound that was started last"),
                  field<&Speaker::began>(Unit::ms)};
  }
};

}  // namespace gt
