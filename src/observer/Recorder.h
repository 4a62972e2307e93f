#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/TemporaryFolder.h"
#include "logs/RobotLog.h"
#include "observer/ObservedRobot.h"

namespace gt {

/// Records all messages of a robot. Requests the input from its platform and its setup, so that the
/// recording can be replayed (report I.5.3: log). The recording is written to a temporary file;
/// saving copies it.
class Recorder {
 public:
  /// The robot must outlive the recorder.
  explicit Recorder(ObservedRobot& robot) : robot_{robot} {}
  ~Recorder();
  Recorder(const Recorder&) = delete;
  Recorder& operator=(const Recorder&) = delete;

  /// Starts recording; appends to an earlier recording.
  Result<void> start();
  void stop();
  bool recording() const { return recording_; }
  /// Discards the recording.
  void clear();
  std::uint64_t messages() const { return messages_; }
  /// Returns the first error of the recording, only once; later messages are lost.
  std::optional<Error> takeError() { return log_ ? log_->takeError() : std::nullopt; }
  /// Number of messages since the recording was saved last.
  std::uint64_t unsaved() const { return messages_ - saved_; }
  /// Saves the recording as a log. Returns an error if it is empty.
  Result<void> save(const std::string& file);
  /// Path where the recording was saved last; empty if it was not saved.
  const std::string& file() const { return file_; }

 private:
  Result<void> open();
  void trace(bool on);
  void take(const MessageQueue& messages);
  std::string path() const { return (folder_->path() / "recording.mcap").string(); }

  ObservedRobot& robot_;
  std::unique_ptr<TemporaryFolder> folder_;  ///< Made when something is recorded first.
  std::optional<RobotLog> log_;
  std::vector<ObservedRobot::Subscription> inputs_;
  std::shared_ptr<const void> passing_;
  bool recording_ = false;
  std::uint64_t messages_ = 0, saved_ = 0;
  std::string file_;
  Time lastImage_ = never();
};

}  // namespace gt
