#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/TemporaryFolder.h"
#include "logs/RobotLog.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// Records all that a robot sends, and has it send what its platform gives it and what made it: so
/// the recording can be replayed (report I.5.3: log). It grows in a temporary file; saving copies
/// it.
class Recorder {
 public:
  /// The robot must outlive the recorder.
  explicit Recorder(ObservedRobot& robot) : robot_{robot} {}
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Records from now on, to what was recorded before.
  Result<void> start();
  void stop();
  bool recording() const { return recording_; }
  /// Forgets what was recorded.
  void clear();
  std::uint64_t messages() const { return messages_; }
  /// The first error while it was recorded, once: later messages are lost.
  std::optional<Error> takeError() { return log_ ? log_->takeError() : std::nullopt; }
  /// Messages since the recording was saved last.
  std::uint64_t unsaved() const { return messages_ - saved_; }
  /// Writes a log of what was recorded; an error if that is nothing.
  Result<void> save(const std::string& file);
  /// Where it was saved last; empty: nowhere.
  const std::string& file() const { return file_; }

 private:
  Result<void> open();
  void trace(bool on);
  void take(const MessageQueue& messages);
  std::string path() const { return (folder_->path() / "recording.mcap").string(); }

  ObservedRobot& robot_;
  std::unique_ptr<TemporaryFolder> folder_;  ///< Once something was recorded.
  std::optional<RobotLog> log_;
  std::vector<ObservedRobot::Subscription> inputs_;
  std::shared_ptr<const void> passing_;
  bool recording_ = false;
  std::uint64_t messages_ = 0, saved_ = 0;
  std::string file_;
  Time lastImage_ = never();
};

}  // namespace gt
