#include "modules/motion/control/DefaultSoundControl.h"

namespace gt {

void DefaultSoundControl::update(const SoundRequest& request, const FrameInfo& frame,
                                 Speaker& speaker) {
  if (request.sound != requested_ && request.sound != Sound::none)
    speaker = {request.sound, frame.time};
  requested_ = request.sound;
}

}  // namespace gt
