#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/Result.h"
#include "base/Time.h"
#include "streams/mcap/Mcap.h"

namespace gt {

/// Plays a log. The messages recorded at one time form a moment. Time advances by `pass`; the
/// listener then plays the moments that are due.
class LogPlayer {
 public:
  /// The messages recorded at one time.
  struct Moment {
    Time time;
    std::uint64_t first;  ///< Number of the first message in the log, from 0.
  };
  using Handler = std::function<Result<void>(const McapChannel&, const McapMessage&)>;

  /// Reads the log once to find its moments. Of a damaged log the undamaged part is played; the
  /// lost parts are listed by its reader's damage().
  static Result<LogPlayer> open(const std::string& path);

  const std::string& path() const { return path_; }
  const McapReader& log() const { return log_; }
  /// Number of messages of a channel.
  std::uint64_t messagesOf(std::uint16_t channel) const;
  const std::vector<Moment>& moments() const { return moments_; }
  std::uint64_t messages() const { return messages_; }
  /// Times of the first and the last moment.
  Time begin() const { return moments_.front().time; }
  Time end() const { return moments_.back().time; }

  /// Index of the moment that is played next; one beyond the last moment at the log's end.
  std::size_t position() const { return position_; }
  bool atEnd() const { return position_ == moments_.size(); }
  /// Recording time of the moment that was played last; the log's begin if there was none.
  Time now() const;

  void play() { playing_ = true; }
  void pause() { playing_ = false; }
  bool playing() const { return playing_; }
  /// Sets the speed of the log's time relative to real time; 1 as recorded.
  void setSpeed(double speed) { speed_ = speed; }
  double speed() const { return speed_; }
  /// Sets whether the log starts again at its end.
  void setLoop(bool on) { loop_ = on; }
  bool loop() const { return loop_; }

  /// Continues with a moment, with the first moment that is not before a time, or with the moment
  /// of a message.
  void seek(std::size_t moment);
  void seekTime(Time time);
  void seekMessage(std::uint64_t message);
  /// Sets the log's time; later moments are due once it has advanced to them.
  void waitFrom(Time time) { passed_ = static_cast<double>(time - begin()); }
  /// The log's time: all moments up to this time are due.
  Time time() const { return begin() + static_cast<std::int64_t>(passed_); }

  /// Advances the time by `ms` of the listener's time.
  void pass(double ms);
  /// Whether the next moment is due. At the end of a loop this is the first moment.
  bool due();
  /// Handles the messages of the next moment in their order, whether or not it is due. Returns
  /// false at the end. If another program has changed the log, it ends there, and an error is
  /// returned once.
  Result<bool> next(const Handler& handle);

 private:
  LogPlayer(std::string path, McapReader log) : path_{std::move(path)}, log_{std::move(log)} {}
  bool read();
  Error cutOff();

  std::string path_;
  McapReader log_;
  std::vector<Moment> moments_;
  std::uint64_t messages_ = 0;
  std::map<std::uint16_t, std::uint64_t> messagesOf_;
  std::size_t position_ = 0;
  bool playing_ = true;
  bool loop_ = false;
  double speed_ = 1;
  double passed_ = 0;  ///< Log time up to which all moments are due, in ms since the log's begin.
  // The next message that was read but not handled yet, in the order of the file.
  McapMessage message_;
  std::uint64_t number_ = 0;
  bool hasMessage_ = false;
};

}  // namespace gt
