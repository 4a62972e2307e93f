#pragma once
#include "representations/behavior/SoundRequest.h"
#include "representations/infrastructure/FrameInfo.h"

namespace gt {

/// Solution *Default* of SoundControl: has the loudspeaker play a wave file when the behavior
/// requests it.
class DefaultSoundControl {
 public:
  /// Provides what the loudspeaker plays: a sound begins when it is requested and was not requested
  /// in the last cycle; it is played to its end, unless another one begins.
  void update(const SoundRequest& request, const FrameInfo& frame, Speaker& speaker);

 private:
  Sound requested_ = Sound::none;
};

}  // namespace gt
