#pragma once
#include "representations/behavior/SoundRequest.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

/// Solution *Default* of SoundControl: plays a wave file by the loudspeaker when the behavior
/// requests it.
class DefaultSoundControl {
 public:
  /// Provides the sound for the loudspeaker. A sound begins when it is requested and was not
  /// requested in the last cycle. It is played to its end, unless another one begins.
  void update(const SoundRequest& request, const FrameInfo& frame, Speaker& speaker);

 private:
  Sound requested_ = Sound::none;
};

}  // namespace gt
