#pragma once
#include <memory>
#include <string>

#include "base/Result.h"

namespace gt {

/// This machine's loudspeaker, by SDL: plays wave files.
class SdlSpeaker {
 public:
  SdlSpeaker();
  ~SdlSpeaker();
  SdlSpeaker(const SdlSpeaker&) = delete;
  SdlSpeaker& operator=(const SdlSpeaker&) = delete;

  /// Begins to play a wave file, in the place of what is being played. Does not block. Returns an
  /// error if the file is none or the machine has no audio device.
  Result<void> play(const std::string& file);
  /// Whether a file is still being played.
  bool plays() const;

 private:
  struct Device;
  std::unique_ptr<Device> device_;
};

}  // namespace gt
