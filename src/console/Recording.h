#pragma once
#include <string>
#include <vector>

#include "base/Result.h"
#include "streams/MessageQueue.h"

namespace gt {

/// What a robot has sent since the recording was started (report I.5.3: log).
class Recording {
 public:
  /// Keeps what comes, if the recording is on. Some hundred megabytes are kept at most: false if it
  /// is full and has ended.
  bool take(const MessageQueue& messages);

  void record(bool on) { on_ = on; }
  void clear();
  std::size_t messages() const { return messages_; }
  /// Writes what was recorded as a log (MCAP) that viewers show and `sl` replays: what a robot gets
  /// from its platform goes to /input/NAME, all else to /NAME, pictures also as JPEG.
  Result<void> save(const std::string& file, const std::string& robot) const;

 private:
  bool on_ = false;
  std::vector<std::vector<std::byte>> queues_;
  std::size_t bytes_ = 0, messages_ = 0;
};

}  // namespace gt
